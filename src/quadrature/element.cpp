#include "quadrature/element.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/shape.hpp"
#include "quadrature/ellipse.hpp"
#include "support/index.hpp"

namespace rollcon::quadrature {
namespace {

Vec3 node_of(const ElementGeometry& e, int k) {
  return {e.node[0][k], e.node[1][k], e.node[2][k]};
}

/// Returns the largest distance of the nodes from where the affine map through three corners has them, or, with
/// `straight`, of the midside and centre nodes from the bilinear map of the corners.
double departure(const ElementGeometry& e, bool straight) {
  const int corners = e.corners;
  Vec3 corner[4];
  for (int i = 0; i < corners; ++i) corner[i] = node_of(e, i);
  double worst = 0;
  if (!straight && corners == 4) worst = 0.25 * length(corner[0] - corner[1] + corner[2] - corner[3]);
  for (int i = corners; i < e.nodes; ++i) {
    Vec3 x{};
    if (i < 2 * corners)
      x = 0.5 * (corner[i - corners] + corner[(i + 1) % corners]);
    else
      for (const Vec3& c : corner) x = x + 0.25 * c;
    worst = std::max(worst, length(node_of(e, i) - x));
  }
  return worst;
}

/// Measures how far normal vector and Jacobian are from constants; `off` is the nodes' departure from an affine map.
void measure_map(ElementGeometry& e, double off) {
  e.degree = direction_degree(e.type, MapKind::affine);
  if (e.map == MapKind::affine) return;
  e.extra = direction_degree(e.type, e.map) - e.degree;
  const Cell cell = whole_element(e.type);
  const int corners = e.corners;
  auto normal = [&e](Vec2 at) {
    Vec3 x, u, v;
    e.tangents(at, x, u, v);
    return cross(u, v);
  };
  Vec3 c[4], m[4];
  const Vec3 centre = normal(cell.centre());
  double change = 2 * off / e.shape.half_length;
  for (int i = 0; i < corners; ++i) {
    c[i] = normal(cell.corner[i]);
    m[i] = normal(0.5 * (cell.corner[i] + cell.corner[(i + 1) % corners]));
    for (const Vec3& n : {c[i], m[i]}) {
      const Vec3 turn = 1 / length(n) * n - 1 / length(centre) * centre;
      change = std::max(change, length(n - centre) / length(centre));
      e.bend = std::max(e.bend, dot(turn, turn));
    }
  }
  e.log_departure = std::min(std::log(change), -0.05);
  double axis[2] = {1e300, 1e300};
  if (corners == 3) {
    for (int i = 0; i < 3; ++i) axis[0] = std::min(axis[0], ellipse_axis(c[i], m[i], c[(i + 1) % 3]));
    axis[1] = axis[0];
  } else {
    axis[0] =
        std::min({ellipse_axis(c[0], m[0], c[1]), ellipse_axis(m[3], centre, m[1]), ellipse_axis(c[3], m[2], c[2])});
    axis[1] =
        std::min({ellipse_axis(c[0], m[3], c[3]), ellipse_axis(m[0], centre, m[2]), ellipse_axis(c[1], m[1], c[2])});
  }
  // The parabola through three normals only approximates the Jacobian; below the least value given here the element is
  // cut anyway.
  for (int k = 0; k < 2; ++k) e.jacobian_log_rho[k] = std::max(0.8 * log_rho(axis[k]), 0.3);
}

double path(const Vec3& a, const Vec3& b, const Vec3& c) {
  return length(b - a) + length(c - b);
}

}  // namespace

void ElementGeometry::tangents(Vec2 reference, Vec3& x, Vec3& d_xi, Vec3& d_eta) const {
  Shape s;
  evaluate_shape(type, reference.x, reference.y, s);
  for (std::size_t j = 0; j < 3; ++j) {
    double a = 0, b = 0, c = 0;
    for (int k = 0; k < nodes; ++k) {
      const auto i = static_cast<std::size_t>(k);
      a += s.value[i] * node[j][k];
      b += s.d_xi[i] * node[j][k];
      c += s.d_eta[i] * node[j][k];
    }
    x[j] = a;
    d_xi[j] = b;
    d_eta[j] = c;
  }
}

Vec3 ElementGeometry::position(Vec2 reference) const {
  Vec3 x, d_xi, d_eta;
  tangents(reference, x, d_xi, d_eta);
  return x;
}

CellShape measure(const ElementGeometry& element, const Cell& cell) {
  CellShape g;
  const int n = g.corners = cell.corners;
  g.depth = cell.depth;
  for (int i = 0; i < n; ++i) {
    g.corner[i] = element.position(cell.corner[i]);
    g.middle[i] = element.position(0.5 * (cell.corner[i] + cell.corner[(i + 1) % n]));
  }
  g.centre = element.position(cell.centre());
  double longest = 0;
  for (int i = 0; i < n; ++i) longest = std::max(longest, path(g.corner[i], g.middle[i], g.corner[(i + 1) % n]));
  g.half_length = 0.5 * longest;
  const Vec3 a = n == 3 ? g.corner[1] - g.corner[0] : g.corner[2] - g.corner[0];
  const Vec3 b = n == 3 ? g.corner[2] - g.corner[0] : g.corner[3] - g.corner[1];
  g.area = 0.5 * length(cross(a, b));
  return g;
}

ElementGeometry element_geometry(ElementType type, std::span<const Vec3> node) {
  constexpr double negligible = 1e-13;  // rounding of the coordinates; no effect on 1e-9
  ElementGeometry e;
  e.type = type;
  e.nodes = node_count(type);
  e.corners = corner_count(type);
  for (int k = 0; k < max_element_nodes; ++k)
    for (std::size_t j = 0; j < 3; ++j) e.node[j][k] = node[at(std::min(k, e.nodes - 1))][j];
  e.shape = measure(e, whole_element(e.type));
  const CellShape& s = e.shape;
  if (e.corners == 4) {
    e.half[0] = 0.5 * std::max({path(s.corner[0], s.middle[0], s.corner[1]), path(s.middle[3], s.centre, s.middle[1]),
                                path(s.corner[3], s.middle[2], s.corner[2])});
    e.half[1] = 0.5 * std::max({path(s.corner[0], s.middle[3], s.corner[3]), path(s.middle[0], s.centre, s.middle[2]),
                                path(s.corner[1], s.middle[1], s.corner[2])});
  } else {
    e.half[0] = e.half[1] = s.half_length;
  }
  for (int i = 0; i < e.corners; ++i)
    e.radius = std::max({e.radius, length(s.corner[i] - s.centre), length(s.middle[i] - s.centre)});
  const double curved = departure(e, true), any = departure(e, false);
  if (curved > negligible * s.half_length)
    e.map = MapKind::curved;
  else if (any > negligible * s.half_length)
    e.map = MapKind::straight;
  measure_map(e, any);
  return e;
}

ElementGeometry element_geometry(const SurfaceMesh& mesh, std::int64_t element, double scale) {
  Vec3 node[max_element_nodes];
  const auto ids = mesh.element(element);
  for (std::size_t k = 0; k < ids.size(); ++k) node[k] = scale * mesh.node[at(ids[k])];
  return element_geometry(mesh.type[at(element)], {node, ids.size()});
}

int direction_degree(ElementType type, MapKind map) {
  switch (type) {
    case ElementType::tri3:
      return 1;
    case ElementType::tri6:
      return map == MapKind::curved ? 4 : 2;
    case ElementType::quad4:
      return map == MapKind::affine ? 1 : 2;
    default:
      return map == MapKind::affine ? 2 : map == MapKind::straight ? 3 : 5;
  }
}

int ray_degree(ElementType type, MapKind map) {
  switch (type) {
    case ElementType::tri3:
      return 1;
    case ElementType::tri6:
      return map == MapKind::curved ? 4 : 2;
    case ElementType::quad4:
      return map == MapKind::affine ? 2 : 3;
    default: {
      const int shape = type == ElementType::quad8 ? 3 : 4;
      return shape + (map == MapKind::affine ? 0 : map == MapKind::straight ? 1 : 3);
    }
  }
}

}  // namespace rollcon::quadrature
