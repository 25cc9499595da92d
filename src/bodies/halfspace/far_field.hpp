#pragma once
/// Integrates over elements seen from afar by plain Gauss rules whose points, weights and Jacobians are computed once.
///
/// The rule of an element is the smallest one with
///   C area/R (1.9 R/a)^-m <= tolerance,   m = degree of exactness + 1 - degree of N J,
/// R the distance, a the half-length of the longest side (see rule_selection.hpp): one comparison of R^2 with a product
/// of an element's and an observer's factor.

#include <cstdint>
#include <vector>

#include "bodies/halfspace/kernels.hpp"
#include "mesh/frame.hpp"
#include "mesh/quadrature.hpp"
#include "quadrature/element.hpp"

namespace rollcon::halfspace {

using namespace quadrature;

/// Constant C of the rule above.
inline constexpr double far_constant = 6;
/// Part of the tolerance that one element gets; the rest is for the sum at a node.
inline constexpr double element_share = 0.1;

/// Returns the geometry of an element of the frame, on the plane.
ElementGeometry plane_geometry(const Frame& frame, std::int64_t element);

/// Holds elements of one type and one kind of map.
class FarGroup {
 public:
  FarGroup(const Frame& frame, std::vector<std::int64_t> elements, ElementType type, MapKind map);

  std::int64_t size() const { return static_cast<std::int64_t>(elements_.size()); }
  int nodes() const { return node_count(type_); }
  int levels() const { return static_cast<int>(levels_.size()); }
  const ElementGeometry& shape(std::int64_t e) const { return shapes_[static_cast<std::size_t>(e)]; }
  const std::int32_t* connectivity(std::int64_t e) const { return connectivity_.data() + e * nodes(); }

  /// Returns the largest area over distance, as the scale of the integrals of an observer's row.
  double scale(double px, double py) const;
  /// Sets level[e] to the index of the rule for each element, or to levels() where none will do.
  void select(double px, double py, double tolerance, std::uint8_t* level) const;

  FarSources sources(int level) const;
  int points(int level) const { return levels_[static_cast<std::size_t>(level)].n; }

  /// Holds forces at all sources of every rule from nodal tractions [3 * node + component].
  struct Forces {
    std::vector<std::vector<double>> component[3];  ///< forces by level
  };
  Forces forces(const double* traction) const;
  /// Returns 1 for elements with a node whose tractions are not all zero.
  std::vector<std::uint8_t> loaded(const double* traction) const;
  FarForces sources(int level, const Forces& forces) const;

  std::size_t bytes() const;

 private:
  struct Level {
    int exponent = 0;  ///< m of the rule above
    int n = 0, padded = 0;
    std::vector<double> shape, x, y, w;
    std::vector<double> factor;  ///< element's factor in the limit of R^2
  };
  Level make_level(const PlaneRule& rule, int degree) const;

  ElementType type_;
  MapKind map_;
  std::vector<std::int64_t> elements_;
  std::vector<ElementGeometry> shapes_;
  std::vector<std::int32_t> connectivity_;
  std::vector<double> centre_x_, centre_y_, half2_, area_;
  std::vector<Level> levels_;
};

}  // namespace rollcon::halfspace
