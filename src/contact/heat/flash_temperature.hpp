#pragma once
/// Finds the surface temperature of a rolling contact by frictional heat (Ertz & Knothe, Wear 253, 2002, 498-508;
/// docs/friction.md): half-spaces below a source that moves so fast that heat is carried along the rolling direction
/// and spreads into the depth alone. Both surfaces have the same temperature where they touch.

#include <array>
#include <span>
#include <vector>

#include "mesh/stream_lines.hpp"

namespace rollcon {

/// Tells what a body does with heat.
struct Heat {
  double conductivity = 0;  ///< power/(length temperature)
  double capacity = 0;      ///< energy/(volume temperature)
  double temperature = 0;   ///< temperature far from the contact
  bool given = false;
  bool operator==(const Heat&) const = default;
};

using BothHeats = std::array<Heat, 2>;

/// Describes the surface of a frame whose material travels against x.
struct HeatedSurface {
  const StreamLines& lines;
  std::span<const double> power;     ///< frictional power per area, at the nodes
  std::span<const double> pressure;  ///< pressure, above 0 where the surfaces touch
  double speed = 0;                  ///< speed of the material
  BothHeats heat;                    ///< one body at least conducts
};

/// Finds temperatures of the surfaces of bodies 1 and 2 at points of the frame's plane, two a point: before the
/// contact, in it, and behind it. On a line with several parts in contact, heat flows between bodies of unequal
/// background temperature as in one part from the first edge to the last.
void surface_temperatures(const HeatedSurface& surface, std::span<const double> x, std::span<const double> y,
                          std::span<double> temperature);
/// Finds the temperatures at all nodes of the frame.
void surface_temperatures(const HeatedSurface& surface, std::span<const double> x, std::span<double> temperature);

}  // namespace rollcon
