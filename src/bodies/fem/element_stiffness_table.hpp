#pragma once
/// Tabulates the formulation of each type of element at its quadrature points.

#include <algorithm>
#include <array>
#include <vector>

#include "bodies/fem/element_stiffness.hpp"

namespace rollcon::fem {

constexpr int max_points = 27, max_modes = 4;
constexpr int max_functions = 20;  ///< shape functions and incompatible modes

/// Holds tables at the quadrature points; derivatives are d[(point * 3 + direction) * nodes + node].
struct ElementTable {
  int nodes = 0, points = 0;
  /// Reference directions r with an incompatible mode 1 - xi_r^2.
  std::vector<int> bubble;
  /// Number of functions that dilatation is projected on: 1 and `modes - 1` reference coordinates.
  int modes = 1;
  /// Largest bulk modulus over G for the dilatation's part orthogonal to 1.
  double cap = 0;
  std::vector<double> w, d;
  std::vector<double> centre;  ///< derivatives at the centre, [direction][node]
  std::vector<Vec3> offset;    ///< offsets of the points from the centre: xi, eta, zeta
  std::vector<double> mode;    ///< functions of the dilatation, [point][mode]

  int functions() const { return nodes + static_cast<int>(bubble.size()); }
};

/// Holds what make(type, hex8) returns for each formulation of an element.
template <class T>
class OfEachElement {
 public:
  explicit OfEachElement(T (*make)(VolumeType, Hex8)) {
    for (const VolumeType type : types) made_.push_back(make(type, Hex8::enhanced));
    made_.push_back(make(VolumeType::hex8, Hex8::b_bar));
  }
  /// Returns the entry of a type; hex8 means nothing for the other types.
  const T& of(VolumeType type, Hex8 hex8) const {
    if (type == VolumeType::hex8 && hex8 == Hex8::b_bar) return made_.back();
    return made_[static_cast<std::size_t>(std::find(types.begin(), types.end(), type) - types.begin())];
  }

 private:
  static constexpr std::array types{VolumeType::tet4,    VolumeType::tet10, VolumeType::wedge6,
                                    VolumeType::wedge15, VolumeType::hex8,  VolumeType::hex20};
  std::vector<T> made_;
};

/// Returns a table that is made once, on first use. Safe for several threads.
const ElementTable& element_table(VolumeType type, Hex8 hex8);

}  // namespace rollcon::fem
