#pragma once
/// What element stiffnesses share: the formulation of each type, tabulated at its quadrature points.

#include <algorithm>
#include <array>
#include <vector>

#include "bodies/fem/element_stiffness.hpp"

namespace rollcon::fem {

constexpr int max_points = 27, max_modes = 4;
constexpr int max_functions = 20;  ///< shape functions and incompatible modes

/// Derivatives d[(point * 3 + direction) * nodes + node] lie one after the other.
struct ElementTable {
  int nodes = 0, points = 0;
  /// Reference directions r with an incompatible mode 1 - xi_r^2.
  std::vector<int> bubble;
  /// Dilatation is projected on 1 and on `modes - 1` reference coordinates.
  int modes = 1;
  /// Bulk modulus over G of the dilatation's part orthogonal to 1: at most this.
  double cap = 0;
  std::vector<double> w, d;
  std::vector<double> centre;  ///< [direction][node]
  std::vector<Vec3> offset;    ///< of the points from the centre: xi, eta, zeta
  std::vector<double> mode;    ///< [point][mode]

  int functions() const { return nodes + static_cast<int>(bubble.size()); }
};

/// What make(type, hex8) returns, of each formulation of an element.
template <class T>
class OfEachElement {
 public:
  explicit OfEachElement(T (*make)(VolumeType, Hex8)) {
    for (const VolumeType type : types) made_.push_back(make(type, Hex8::enhanced));
    made_.push_back(make(VolumeType::hex8, Hex8::b_bar));
  }
  /// hex8 means nothing for the other types.
  const T& of(VolumeType type, Hex8 hex8) const {
    if (type == VolumeType::hex8 && hex8 == Hex8::b_bar) return made_.back();
    return made_[static_cast<std::size_t>(std::find(types.begin(), types.end(), type) - types.begin())];
  }

 private:
  static constexpr std::array types{VolumeType::tet4,    VolumeType::tet10, VolumeType::wedge6,
                                    VolumeType::wedge15, VolumeType::hex8,  VolumeType::hex20};
  std::vector<T> made_;
};

/// Made once, on first use; thread-safe.
const ElementTable& element_table(VolumeType type, Hex8 hex8);

}  // namespace rollcon::fem
