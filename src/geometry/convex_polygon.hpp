#pragma once
/// Represents convex polygons in the plane, and cuts them by lines.

#include <vector>

#include "geometry/vec2.hpp"

namespace rollcon {

/// The corners run counter-clockwise.
using Polygon = std::vector<Vec2>;

/// Returns the signed area of any simple polygon, positive when its corners run counter-clockwise.
double area(const Polygon& p);

/// Says whether the point is inside or on the edge.
bool holds(const Polygon& p, const Vec2& point);

/// Splits the polygon by the line from a to b: `left` receives what lies to the left of it or on it, `right`, unless
/// null, the rest. Both are overwritten, and empty when nothing is left.
void cut(const Polygon& p, const Vec2& a, const Vec2& b, Polygon& left, Polygon* right);

/// Computes the part that both polygons cover; `work` is scratch.
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
