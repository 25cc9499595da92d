#include "geometry/convex_polygon.hpp"

#include <cstddef>

namespace rollcon {

double area(const Polygon& p) {
  double twice = 0;
  for (std::size_t i = 2; i < p.size(); ++i) twice += cross(p[i - 1] - p[0], p[i] - p[0]);
  return 0.5 * twice;
}

bool holds(const Polygon& p, const Vec2& point) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (cross(p[(i + 1) % p.size()] - p[i], point - p[i]) < 0) return false;
  return !p.empty();
}

void cut(const Polygon& p, const Vec2& a, const Vec2& b, Polygon& left, Polygon* right) {
  left.clear();
  if (right) right->clear();
  if (p.empty()) return;
  const Vec2 along = b - a;
  Vec2 from = p.back();
  double before = cross(along, from - a);
  for (const Vec2& to : p) {
    const double here = cross(along, to - a);
    if ((before < 0 && here > 0) || (before > 0 && here < 0)) {
      const double s = before / (before - here);
      const Vec2 between{from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])};
      left.push_back(between);
      if (right) right->push_back(between);
    }
    if (here >= 0) left.push_back(to);
    if (right && here <= 0) right->push_back(to);
    from = to;
    before = here;
  }
  if (left.size() < 3) left.clear();
  if (right && right->size() < 3) right->clear();
}

void intersect(const Polygon& p, const Polygon& q, Polygon& common, Polygon& work) {
  common = p;
  for (std::size_t i = 0; i < q.size() && !common.empty(); ++i) {
    cut(common, q[i], q[(i + 1) % q.size()], work, nullptr);
    common.swap(work);
  }
}

}  // namespace rollcon
