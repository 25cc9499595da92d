#pragma once
/// Convex polygons in the plane, cut by lines.

#include <vector>

#include "geometry/vec2.hpp"

namespace rollcon {

/// Corners counter-clockwise.
using Polygon = std::vector<Vec2>;

/// Signed, positive when counter-clockwise; any simple polygon.
double area(const Polygon& p);

/// Whether the point is inside or on the edge.
bool holds(const Polygon& p, const Vec2& point);

/// Left (and on the line): what lies to the left of the line from a to b; right, if wanted: the rest. Both overwritten,
/// empty when nothing is left.
void cut(const Polygon& p, const Vec2& a, const Vec2& b, Polygon& left, Polygon* right);

/// The part of both; `work` is scratch.
void intersect(const Polygon& p, const Polygon& q, Polygon& common, Polygon& work);

/// Removes from `rest` what `q` covers and calls hit(part) for each part removed, all convex.
template <class F>
void subtract(std::vector<Polygon>& rest, const Polygon& q, double least_area, F hit) {
  std::vector<Polygon> kept;
  Polygon left, right;
  for (const Polygon& whole : rest) {
    Polygon inside = whole;
    std::vector<Polygon> outside;
    for (std::size_t i = 0; i < q.size() && !inside.empty(); ++i) {
      cut(inside, q[i], q[(i + 1) % q.size()], left, &right);
      if (area(right) > least_area) outside.push_back(right);
      inside.swap(left);
    }
    if (area(inside) > least_area) {
      hit(inside);
      kept.insert(kept.end(), outside.begin(), outside.end());
    } else {
      kept.push_back(whole);
    }
  }
  rest.swap(kept);
}

}  // namespace rollcon
