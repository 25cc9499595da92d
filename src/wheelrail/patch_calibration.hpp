#pragma once
/// Calibrates the ellipse that stands for a patch, so that a creep-force table has the patch's own linear theory
/// (docs/wheelrail.md, Forces from a table).

#include <array>

#include "tables/creep_map.hpp"

namespace rollcon {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Says how the creepages of an ellipse follow from those of its patch. x is along the rolling direction and y across
/// the rail to the right, both from the patch's reference. Creepages are those at the middle of both surfaces there,
/// brought to the ellipse's centre; height is the turning about y over the speed.
struct PatchCalibration {
  Matrix3 stretch{};                ///< creepages of linear theory by those of the patch
  std::array<double, 3> lifted{};   ///< and by height
  std::array<double, 3> sliding{};  ///< creepages of sliding by height
  Matrix3 linear{};                 ///< the ellipse's forces by creepages, over G a b, lengths over sqrt(a b)
  std::array<double, 2> centre{};   ///< centre of pressure
  double a = 0, b = 0;              ///< semi-axes over those of the Hertzian patch
  double load = 0, pressure = 0;    ///< load and largest pressure over those of the Hertzian patch
  double filled = 0;                ///< share of the ellipse of its pressures' moments that the patch fills
};
static_assert(sizeof(PatchCalibration) == sizeof(CreepMap::Numbers));

}  // namespace rollcon
