#pragma once
/// Elements of a surface under load, seen from afar: boxes of them, each with the same forces taken to a grid of
/// Chebyshev points.
///
/// Forces f_k = integral of L_k t over the box, L_k the Lagrange functions of q x q Chebyshev points, act as the
/// tractions t do to the error of interpolating the kernel over the box. In one direction, with the box scaled to
/// [-1, 1] and the observer at x along it and at least d beside it, the kernel is analytic within the ellipse with foci
/// -1 and 1 through x + i d, whose half-axis A = (|x + i d + 1| + |x + i d - 1|)/2: the error falls like rho^-q,
/// rho = A + sqrt(A^2 - 1). Boxes are halved at the median along their longer side. Stresses at 10,000 points under
/// 1,000 nodes take 0.04 to 0.09 s instead of 1.1 s element by element, under 3,600 nodes 0.07 to 0.10 s instead of 2.3
/// s.

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/halfspace/interior_kernels.hpp"
#include "quadrature/element.hpp"

namespace rollcon::halfspace {

/// An element under load: what kernels want, and what choosing a rule does.
struct LoadedElement {
  InteriorElement element;
  quadrature::ElementGeometry geometry;
  double largest = 0;  ///< traction component
};

/// Gauss rule of at least that degree: symmetric on triangles (the highest there is, if need be), a product elsewhere.
void plain_rule(ElementType type, int degree, NearPoints& points);

/// Squared half-axis A of the ellipse above, the least over a box that reaches half_along and half_beside to each side
/// of the origin, for an observer at (along, beside, z).
double ellipse_axis2(double along, double beside, double z, double half_along, double half_beside);

class SourceTree {
 public:
  struct Box {
    double x = 0, y = 0, half_x = 0, half_y = 0;  ///< centre and half sides
    std::int32_t first = 0, last = 0;             ///< elements order[first .. last)
    std::int32_t child = -1;                      ///< the first of two; -1: a leaf
  };
  static constexpr int grids = 3;

  /// Elements must outlive it. error: of what a box does, over integral of |t| / R^2 (see box_constant).
  SourceTree(std::span<const LoadedElement> elements, double error);

  std::span<const Box> boxes() const { return boxes_; }
  std::span<const std::int32_t> order() const { return order_; }
  /// The smallest grid that serves from there; -1: none.
  int grid(const Box& box, const InteriorPoint& at) const;
  InteriorForces forces(std::int64_t box, int grid) const;
  int points(int grid) const { return q_[static_cast<std::size_t>(grid)]; }

 private:
  void divide(std::int32_t box);
  void collect(std::int32_t box);
  void add_element(const LoadedElement& e, std::int32_t box);
  double* data(std::int64_t box, int grid) { return data_[grid].data() + box * 5 * padded_[grid]; }

  std::span<const LoadedElement> elements_;
  std::vector<std::int32_t> order_;
  std::vector<Box> boxes_;
  int q_[grids] = {}, padded_[grids] = {};
  double least_axis2_[grids] = {};
  std::vector<double> data_[grids];  ///< per box: x, y, fx, fy, fz
};

}  // namespace rollcon::halfspace
