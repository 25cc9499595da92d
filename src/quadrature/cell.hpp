#pragma once
/// Represents a part of an element: a parallelogram or triangle in reference coordinates.

#include "mesh/element_type.hpp"

namespace rollcon::quadrature {

/// Defines its operators as friends so that they do not hide those of Vec3.
struct Vec2 {
  double x, y;
  friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
};

struct Cell {
  int corners;
  Vec2 corner[4];  ///< reference coordinates, counter-clockwise
  int depth = 0;   ///< number of halvings of the area, about

  Vec2 centre() const;
  /// Splits into parts of equal reference size: a quadrilateral is halved along its first or second direction or both,
  /// a triangle cut in four. Returns their number.
  int split(bool first, bool second, Cell* parts) const;
  /// Returns how far a reference point lies outside, in half sizes of the cell (0: inside or on it).
  double distance_outside(Vec2 point) const;
};

Cell whole_element(ElementType type);

}  // namespace rollcon::quadrature
