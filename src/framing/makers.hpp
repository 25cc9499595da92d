#pragma once
/// Makes meshes of contact frames in the plane of the axes, from coordinates along t1 and t2.

#include <cstdint>
#include <span>
#include <vector>

#include "contact/scene/scene.hpp"
#include "geometry/rectangle.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Holds what a contact covers of a line along the rolling direction.
struct Strip {
  double y = 0, from = 0, to = 0;
};

/// Makes a mesh whose lines of nodes are the strips, each with along + 1 nodes from end to end, graded to both ends by
/// cosines: quadrilaterals, and triangles beside a first or last strip that is a point. At least three strips in
/// ascending order of y, all but the outer ones longer than 0; along >= 2.
SurfaceMesh strips_mesh(const Axes& axes, std::span<const Strip> strip, std::int64_t along);
/// Makes a mesh of several patches, each of strips as above.
SurfaceMesh strips_mesh(const Axes& axes, std::span<const std::vector<Strip>> patch, std::int64_t along);

/// Places the unit disc as an ellipse with these semi-axes, the first at `angle` (radian) from t1.
FramePlace place_of_disc(double semi1, double semi2, double angle);

/// Returns across + 1 strips of an ellipse with these semi-axes, the first at `angle` (radian) from t1, at the heights
/// h cos(pi j / across) from its centre.
std::vector<Strip> strips_of_ellipse(double semi1, double semi2, double angle, std::int64_t across);

/// Makes nx by ny elements of one size and any type; triangles halve quadrilaterals along alternating diagonals. Nodes
/// come line by line from the least y.
SurfaceMesh rectangle_mesh(const Axes& axes, ElementType type, std::int64_t nx, std::int64_t ny, const Rectangle& r);

/// Holds a rectangle and its counts of elements along and across.
struct RectangleCells {
  Rectangle box{};
  std::int64_t along = 0, across = 0;
  bool operator==(const RectangleCells&) const = default;
};

/// Makes a mesh of several rectangles that do not touch, each as above, one after the other.
SurfaceMesh rectangles_mesh(const Axes& axes, ElementType type, std::span<const RectangleCells> rectangle);

}  // namespace rollcon
