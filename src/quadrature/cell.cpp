#include "quadrature/cell.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon::quadrature {

Vec2 Cell::centre() const {
  Vec2 sum{0, 0};
  for (int i = 0; i < corners; ++i) sum = sum + corner[i];
  return (1.0 / corners) * sum;
}

int Cell::split(bool first, bool second, Cell* parts) const {
  Vec2 middle[4];
  for (int i = 0; i < corners; ++i) middle[i] = 0.5 * (corner[i] + corner[(i + 1) % corners]);
  if (corners == 3) {
    for (int i = 0; i < 3; ++i) parts[i] = {3, {corner[i], middle[i], middle[(i + 2) % 3], {}}, depth + 2};
    parts[3] = {3, {middle[0], middle[1], middle[2], {}}, depth + 2};
    return 4;
  }
  if (first && second) {
    const Vec2 c = centre();
    for (int i = 0; i < 4; ++i) {
      // The corner stays at its own place in the cell, so that directions do not change their meaning.
      const int next = (i + 1) % 4, opposite = (i + 2) % 4, before = (i + 3) % 4;
      parts[i].corners = 4;
      parts[i].depth = depth + 2;
      parts[i].corner[i] = corner[i];
      parts[i].corner[next] = middle[i];
      parts[i].corner[opposite] = c;
      parts[i].corner[before] = middle[before];
    }
    return 4;
  }
  if (first) {
    parts[0] = {4, {corner[0], middle[0], middle[2], corner[3]}, depth + 1};
    parts[1] = {4, {middle[0], corner[1], corner[2], middle[2]}, depth + 1};
  } else {
    parts[0] = {4, {corner[0], corner[1], middle[1], middle[3]}, depth + 1};
    parts[1] = {4, {middle[3], middle[1], corner[2], corner[3]}, depth + 1};
  }
  return 2;
}

double Cell::distance_outside(Vec2 point) const {
  const Vec2 a = corner[1] - corner[0], b = corner[corners - 1] - corner[0], d = point - corner[0];
  const double area = cross(a, b), s = cross(d, b) / area, t = cross(a, d) / area;
  if (corners == 4) return 2 * std::max({0.0, std::abs(s - 0.5) - 0.5, std::abs(t - 0.5) - 0.5});
  return 2 * std::max({0.0, -s, -t, s + t - 1});
}

Cell whole_element(ElementType type) {
  if (corner_count(type) == 3) return {3, {{0, 0}, {1, 0}, {0, 1}, {}}, 0};
  return {4, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0};
}

}  // namespace rollcon::quadrature
