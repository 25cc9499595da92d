#include "geometry/plane_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/surface_geometry.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// A corner whose angle has a smaller sine is rounding of a straight line.
constexpr double straight = 1e-13;

/// Returns the number of nodes along the element's edge.
int ring_size(ElementType type) {
  return is_quadratic(type) ? 2 * corner_count(type) : corner_count(type);
}
int ring(ElementType type, int i) {
  return is_quadratic(type) ? i / 2 + (i % 2) * corner_count(type) : i;
}

/// Returns the triangles of local nodes that make up the element, for outlines that are not convex.
std::span<const std::array<int, 3>> triangles(ElementType type) {
  static constexpr std::array<int, 3> tri3[] = {{0, 1, 2}}, tri6[] = {{0, 3, 5}, {3, 1, 4}, {4, 2, 5}, {3, 4, 5}},
                                      quad4[] = {{0, 1, 2}, {0, 2, 3}},
                                      quad8[] = {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}},
                                      quad9[] = {{0, 4, 8}, {4, 1, 8}, {1, 5, 8}, {5, 2, 8},
                                                 {2, 6, 8}, {6, 3, 8}, {3, 7, 8}, {7, 0, 8}};
  switch (type) {
    case ElementType::tri3:
      return tri3;
    case ElementType::tri6:
      return tri6;
    case ElementType::quad4:
      return quad4;
    case ElementType::quad8:
      return quad8;
    case ElementType::quad9:
      return quad9;
  }
  return {};
}

/// Leaves out corners on a straight line; returns false when the polygon is not convex.
bool make_convex(Polygon& p) {
  Polygon corner;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 in = p[i] - p[(i + p.size() - 1) % p.size()], out = p[(i + 1) % p.size()] - p[i];
    const double turn = cross(in, out), bound = straight * std::hypot(in[0], in[1]) * std::hypot(out[0], out[1]);
    if (turn < -bound) return false;
    if (turn > bound) corner.push_back(p[i]);
  }
  p.swap(corner);
  return p.size() >= 3;
}

}  // namespace

Vec3 outline_normal(const SurfaceMesh& mesh, std::int64_t element) {
  const auto nodes = mesh.element(element);
  const ElementType type = mesh.type[at(element)];
  const auto place = [&](int i) { return mesh.node[at(nodes[at(ring(type, i))])]; };
  Vec3 sum{0, 0, 0};
  for (int i = 2; i < ring_size(type); ++i) sum = sum + cross(place(i - 1) - place(0), place(i) - place(0));
  return sum;
}

PlaneChart::PlaneChart(const SurfaceMesh& mesh, std::int64_t element)
    : origin(mesh.node[at(mesh.element(element)[0])]), n(normalized(outline_normal(mesh, element))) {
  const Vec3 side = mesh.node[at(mesh.element(element)[1])] - origin;
  a = normalized(side - dot(side, n) * n);
  b = cross(n, a);
}

void outline(const SurfaceMesh& mesh, std::int64_t element, const PlaneChart& chart, std::vector<Polygon>& part) {
  part.clear();
  const ElementType type = mesh.type[at(element)];
  const auto nodes = mesh.element(element);
  const auto point = [&](int i) { return chart(mesh.node[at(nodes[at(i)])]); };
  Polygon whole;
  for (int i = 0; i < ring_size(type); ++i) whole.push_back(point(ring(type, i)));
  if (make_convex(whole) && area(whole) > 0) {
    part.push_back(std::move(whole));
    return;
  }
  const auto cut_up = [&](std::span<const std::array<int, 3>> cells) {
    double least = std::numeric_limits<double>::infinity();
    part.clear();
    for (const auto& t : cells) {
      part.push_back({point(t[0]), point(t[1]), point(t[2])});
      least = std::min(least, area(part.back()));
    }
    return least > 0;
  };
  static constexpr std::array<int, 3> other_diagonal[] = {{0, 1, 3}, {1, 2, 3}};
  if (cut_up(triangles(type)) || (type == ElementType::quad4 && cut_up(other_diagonal))) return;
  cut_up(triangles(type));
  std::erase_if(part, [](const Polygon& p) { return !(area(p) > 0); });
}

PlaneMap::PlaneMap(const SurfacePatch& patch, const PlaneChart& chart)
    : size_(patch.size()), triangle_(patch.triangle()) {
  const Vec2 start = chart(patch.origin());
  const double rounding = 16 * epsilon * (size_ + length(patch.origin()));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3& c = patch.coefficient(i, j);
      c_[i][j] = {dot(chart.a, c), dot(chart.b, c)};
      if (i + j > 1) affine_ = affine_ && length(c) <= rounding;
      if (i + j > 0) flat_ = flat_ && std::abs(dot(chart.n, c)) <= 1e-9 * size_;
    }
  c_[0][0] = {c_[0][0][0] + start[0], c_[0][0][1] + start[1]};
}

double PlaneMap::invert(const Vec2& y, ReferencePoint& p) const {
  const double low = triangle_ ? -0.25 : -1.5, high = triangle_ ? 1.25 : 1.5;
  double det = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    double f[2], u[2], v[2];
    for (std::size_t k = 0; k < 2; ++k) {
      if (affine_) {
        u[k] = c_[1][0][k], v[k] = c_[0][1][k];
        f[k] = c_[0][0][k] + p.xi * u[k] + p.eta * v[k] - y[k];
        continue;
      }
      double g[3], h[3];  // Horner's rule in eta for each power of xi
      for (int i = 0; i < 3; ++i) {
        g[i] = c_[i][0][k] + p.eta * (c_[i][1][k] + p.eta * c_[i][2][k]);
        h[i] = c_[i][1][k] + 2 * p.eta * c_[i][2][k];
      }
      f[k] = g[0] + p.xi * (g[1] + p.xi * g[2]) - y[k];
      u[k] = g[1] + 2 * p.xi * g[2];
      v[k] = h[0] + p.xi * (h[1] + p.xi * h[2]);
    }
    det = u[0] * v[1] - u[1] * v[0];
    if (det == 0) return det;
    const double du = (v[0] * f[1] - v[1] * f[0]) / det, dv = (u[1] * f[0] - u[0] * f[1]) / det;
    const ReferencePoint next{std::clamp(p.xi + du, low, high), std::clamp(p.eta + dv, low, high)};
    const double moved = std::abs(next.xi - p.xi) + std::abs(next.eta - p.eta);
    p = next;
    // The next step would be the square of this one, below rounding.
    if (affine_ || moved < 3e-9) return det;
  }
  return det;
}

}  // namespace rollcon
