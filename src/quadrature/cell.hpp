#pragma once
/// A part of an element: a parallelogram or triangle in reference coordinates.

#include "quadrature/element.hpp"

namespace rollcon::quadrature {

struct Vec2 {
  double x, y;
};
inline Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator*(double s, Vec2 a) {
  return {s * a.x, s * a.y};
}
inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

struct Cell {
  int corners;
  Vec2 corner[4];  ///< reference coordinates, counter-clockwise
  int depth = 0;   ///< halvings of the area, about

  Vec2 centre() const;
  /// Parts of equal reference size: a quadrilateral halved along its first or second direction or
  /// both, a triangle in four. Returns their number.
  int split(bool first, bool second, Cell* parts) const;
  /// A quadrilateral along the diagonal through its corner 0, or the other one.
  int cut(bool other, Cell* parts) const;
  /// A triangle from the point `part` of the way along its side (from corner `side`) to the corner
  /// opposite.
  int split_at_foot(int side, double part, Cell* parts) const;
  /// A triangle halfway between a side and the corner opposite; what is beside the side along its
  /// diagonal from the side's first corner, or the other one.
  int split_needle(int side, bool other, Cell* parts) const;
  /// How far a reference point lies outside, in half sizes of the cell (0: inside or on it).
  double distance_outside(Vec2 point) const;
};

Cell whole_element(ElementType type);

/// Corners, edge midpoints (after the edge's first corner's index) and centre relative to the
/// observer.
struct CellShape {
  Vec2 corner[4], middle[4], centre;
  double area, half_length;
};

}  // namespace rollcon::quadrature
