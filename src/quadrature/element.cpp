#include "quadrature/element.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/shape.hpp"

namespace rollcon::quadrature {
namespace {

/// Largest distance of the midside and centre nodes from where a straight-sided element has them.
double curvature(const ElementShape& e) {
  const int corners = corner_count(e.type);
  double worst = 0;
  for (int i = corners; i < node_count(e.type); ++i) {
    double x = 0, y = 0;
    if (i < 2 * corners) {
      const int a = i - corners, b = (a + 1) % corners;
      x = 0.5 * (e.x[a] + e.x[b]);
      y = 0.5 * (e.y[a] + e.y[b]);
    } else {
      for (int k = 0; k < corners; ++k) {
        x += e.x[k] / corners;
        y += e.y[k] / corners;
      }
    }
    worst = std::max(worst, std::hypot(e.x[i] - x, e.y[i] - y));
  }
  return worst;
}

/// Distance of the corners from a parallelogram.
double skewness(const ElementShape& e) {
  if (corner_count(e.type) == 3) return 0;
  return std::hypot(e.x[0] - e.x[1] + e.x[2] - e.x[3], e.y[0] - e.y[1] + e.y[2] - e.y[3]);
}

}  // namespace

ElementShape element_shape(const Frame& frame, std::int64_t element) {
  constexpr double negligible = 1e-13;  // rounding of the coordinates; no effect on 1e-9
  ElementShape e;
  e.type = frame.mesh.type[static_cast<std::size_t>(element)];
  const auto nodes = frame.mesh.element(element);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    e.x[i] = frame.x[static_cast<std::size_t>(nodes[i])];
    e.y[i] = frame.y[static_cast<std::size_t>(nodes[i])];
  }
  const int corners = corner_count(e.type);
  const double centre = corners == 3 ? 1.0 / 3 : 0.0;
  Shape shape;
  evaluate_shape(e.type, centre, centre, shape);
  double xu = 0, xv = 0, yu = 0, yv = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    e.centre_x += shape.value[i] * e.x[i];
    e.centre_y += shape.value[i] * e.y[i];
    xu += shape.d_xi[i] * e.x[i];
    yu += shape.d_xi[i] * e.y[i];
    xv += shape.d_eta[i] * e.x[i];
    yv += shape.d_eta[i] * e.y[i];
  }
  // Twice the triangle's or a quarter of the quadrilateral's area, were the Jacobian constant.
  e.area = std::abs(xu * yv - xv * yu) * (corners == 3 ? 0.5 : 4.0);
  double longest = 0;
  for (int i = 0; i < corners; ++i) {
    const int j = (i + 1) % corners;
    double side = std::hypot(e.x[j] - e.x[i], e.y[j] - e.y[i]);
    if (is_quadratic(e.type)) {
      const int m = corners + i;
      side = std::hypot(e.x[m] - e.x[i], e.y[m] - e.y[i]) +
             std::hypot(e.x[j] - e.x[m], e.y[j] - e.y[m]);
    }
    longest = std::max(longest, side);
  }
  e.half_length = 0.5 * longest;
  if (curvature(e) > negligible * longest)
    e.map = MapKind::curved;
  else if (skewness(e) > negligible * longest)
    e.map = MapKind::straight;
  return e;
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
