#include "geometry/coupled_element.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/box.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/surface_geometry.hpp"
#include "mesh/surface_quadrature.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// The distance up to which a face may lie off a layer element, over the element's diameter, exceeds the height of an
/// arc of 90 degrees over its chord.
constexpr double reach = 0.25;
/// The least cosine between a face and the element it lies under keeps walls at an edge from counting.
constexpr double least_cosine = 0.05;
/// Pieces below the first fraction of the element's area are rounding; an uncovered area above the second is looked
/// for.
constexpr double least_piece = 1e-15, covered = 1e-12;
constexpr int most_points = 16;

/// Returns the rule with n = 1, 2, ... points each way.
const PlaneRule& rule(int n) {
  static const std::vector<PlaneRule> rules = [] {
    std::vector<PlaneRule> r;
    for (int k = 1; k <= most_points; ++k) r.push_back(triangle_rule(2 * k - 1));
    return r;
  }();
  return rules[at(std::clamp(n, 1, most_points) - 1)];
}

/// Returns the total degree of the shape functions.
int degree(ElementType type) {
  if (corner_count(type) == 3) return is_quadratic(type) ? 2 : 1;
  return type == ElementType::quad4 ? 2 : type == ElementType::quad8 ? 3 : 4;
}

}  // namespace

struct ElementCoupling::Side {
  std::int64_t element;
  ElementType type;
  SurfacePatch patch;
  PlaneMap map;
  const PlaneChart& chart;
  ReferencePoint p;

  Side(const SurfaceMesh& mesh, std::int64_t e, const PlaneChart& on)
      : element(e), type(mesh.type[at(e)]), patch(mesh, e), map(patch, on), chart(on), p(map.middle()) {}

  /// Returns the area of the element over that of its projection.
  double slope() const {
    const auto d = patch.at(p.xi, p.eta);
    const Vec3 normal = cross(d.u, d.v);
    return length(normal) / std::max(std::abs(dot(chart.n, normal)), least_cosine * length(normal));
  }
  /// Returns the least over the largest Jacobian at the corners, r. The inverse of the map has a root where the
  /// Jacobian, here linear, vanishes; r tells how many points a triangle needs beyond those for polynomials.
  double ratio(const Vec2& a, const Vec2& b, const Vec2& c) {
    if (map.affine()) return 1;
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Vec2* y : {&a, &b, &c}) {
      const double j = std::abs(map.invert(*y, p));
      least = std::min(least, j), most = std::max(most, j);
    }
    return most > 0 ? least / most : 0;
  }
};

std::span<const std::int64_t> ElementCoupling::candidates(std::int64_t element) {
  const Box box = box_of(layer_.node, layer_.element(element));
  const double margin = reach * element_diameter(layer_, element);
  const Vec3 beyond{margin, margin, margin};
  faces_.near(box.low - beyond, box.high + beyond, candidate_);
  return candidate_;
}

void ElementCoupling::project(const PlaneChart& chart, std::int64_t element) {
  double middle = 0;
  const auto own = layer_.element(element);
  for (const std::int32_t k : own) middle += chart.height(layer_.node[at(k)]);
  middle /= static_cast<double>(own.size());
  under_.clear();
  for (const std::int64_t f : candidate_) {
    const Vec3 normal = outline_normal(body_, f);
    if (dot(normal, chart.n) <= least_cosine * length(normal)) continue;
    Under under{f, 0, {}};
    outline(body_, f, chart, under.part);
    const auto nodes = body_.element(f);
    for (const std::int32_t k : nodes)
      under.height += (chart.height(body_.node[at(k)]) - middle) / static_cast<double>(nodes.size());
    under.height = std::abs(under.height);
    under_.push_back(std::move(under));
  }
}

std::span<const CoupledNode> ElementCoupling::integrate(std::int64_t element) {
  for (const CoupledNode& r : row_) place_[at(r.node)] = -1;
  row_.clear();
  columns_ = layer_.element(element).size();
  const PlaneChart chart(layer_, element);
  Side upper(layer_, element, chart);
  std::vector<Polygon> whole;
  outline(layer_, element, chart, whole);
  project(chart, element);
  double size = 0, found = 0;
  for (const Polygon& p : whole) size += area(p);
  std::vector<std::pair<std::size_t, Polygon>> piece;
  Polygon common, work;
  for (std::size_t u = 0; u < under_.size(); ++u)
    for (const Polygon& q : under_[u].part)
      for (const Polygon& p : whole) {
        intersect(p, q, common, work);
        const double a = area(common);
        if (!(a > least_piece * size)) continue;
        found += a;
        piece.emplace_back(u, common);
      }
  std::vector<Polygon> rest;
  if (!(std::abs(found - size) <= covered * size)) {
    // Some faces leave a part bare or lie over one another; they take what they cover one after the other, nearest
    // first.
    piece.clear();
    std::vector<std::size_t> order(under_.size());
    for (std::size_t u = 0; u < order.size(); ++u) order[u] = u;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t p, std::size_t q) { return under_[p].height < under_[q].height; });
    rest = whole;
    for (const std::size_t u : order)
      for (const Polygon& q : under_[u].part)
        subtract(rest, q, least_piece * size, [&](const Polygon& p) { piece.emplace_back(u, p); });
  }
  for (std::size_t i = 0; i < piece.size();) {
    Side lower(body_, under_[piece[i].first].face, chart);
    const std::size_t u = piece[i].first;
    for (; i < piece.size() && piece[i].first == u; ++i) pair(piece[i].second, upper, lower);
  }
  for (const Polygon& p : rest) bare(p, upper);
  slivers(chart, upper);
  if (row_.empty()) to_nearest(element);
  settle(element);
  return row_;
}

void ElementCoupling::pair(const Polygon& piece, Side& upper, Side& lower) {
  const int polynomial = (degree(upper.type) + degree(lower.type)) / 2 + 1;
  const bool affine = upper.map.affine() && lower.map.affine(), flat = upper.map.flat() && lower.map.flat();
  Shape above, below;
  for (std::size_t k = 2; k < piece.size(); ++k) {
    const Vec2 &a = piece[0], &b = piece[k - 1], &c = piece[k];
    int points = polynomial;
    if (!affine) {
      const double r = std::min(upper.ratio(a, b, c), lower.ratio(a, b, c));
      const double z = (1 + r * r) / (1 - r * r);
      const double rate = 2 * std::log(z + std::sqrt(z * z - 1));
      points = polynomial + (flat ? static_cast<int>(to_index(std::min(24 / rate, 16.0))) : 1);
    }
    const PlaneRule& at_points = rule(points);
    const double jacobian = cross(b - a, c - a);
    for (std::size_t q = 0; q < at_points.size(); ++q) {
      const double s = at_points.xi[q], t = at_points.eta[q];
      const Vec2 y{a[0] + s * (b[0] - a[0]) + t * (c[0] - a[0]), a[1] + s * (b[1] - a[1]) + t * (c[1] - a[1])};
      upper.map.invert(y, upper.p);
      lower.map.invert(y, lower.p);
      double w = at_points.w[q] * jacobian;
      if (!upper.map.flat()) w *= upper.slope();
      evaluate_shape(upper.type, upper.p.xi, upper.p.eta, above);
      evaluate_shape(lower.type, lower.p.xi, lower.p.eta, below);
      add(above, lower.element, below, w);
    }
  }
}

void ElementCoupling::bare(const Polygon& piece, Side& upper) {
  const PlaneRule& points = rule(degree(upper.type) + 1);
  for (std::size_t k = 2; k < piece.size(); ++k) {
    const Vec2 &a = piece[0], &b = piece[k - 1], &c = piece[k];
    const double jacobian = cross(b - a, c - a);
    for (std::size_t q = 0; q < points.size(); ++q) {
      const double s = points.xi[q], t = points.eta[q];
      at_point({a[0] + s * (b[0] - a[0]) + t * (c[0] - a[0]), a[1] + s * (b[1] - a[1]) + t * (c[1] - a[1])},
               points.w[q] * jacobian, upper);
    }
  }
}

// Adds the areas between curved sides and their two chords, positive where the side bulges out. The neighbour's points
// are these with the other sign.
void ElementCoupling::slivers(const PlaneChart& chart, Side& upper) {
  if (!is_quadratic(upper.type)) return;
  static const LineRule along = gauss_legendre(4), across = gauss_legendre(2);
  const auto nodes = layer_.element(upper.element);
  const auto corners = at(corner_count(upper.type));
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec2 p = chart(layer_.node[at(nodes[i])]), q = chart(layer_.node[at(nodes[(i + 1) % corners])]),
               m = chart(layer_.node[at(nodes[corners + i])]);
    // The side is the parabola p + s (q - p) + 4 s (1 - s) bulge.
    const Vec2 side = q - p, bulge{m[0] - 0.5 * (p[0] + q[0]), m[1] - 0.5 * (p[1] + q[1])};
    if (std::abs(cross(side, bulge)) <= 1e-12 * (side[0] * side[0] + side[1] * side[1])) continue;
    for (const double half : {0.0, 0.5})
      for (std::size_t u = 0; u < along.x.size(); ++u)
        for (std::size_t v = 0; v < across.x.size(); ++v) {
          const double r = 0.5 * (1 + along.x[u]), s = half + 0.5 * r, t = 0.5 * (1 + across.x[v]);
          const double chord = half == 0 ? 2 * s : 2 - 2 * s, bow = 4 * s * (1 - s) - chord;
          const double chord_slope = half == 0 ? 2 : -2, bow_slope = 4 - 8 * s - chord_slope;
          const double f = chord + t * bow, f_slope = chord_slope + t * bow_slope;
          const Vec2 to_side{bow * bulge[0], bow * bulge[1]},
              step{side[0] + f_slope * bulge[0], side[1] + f_slope * bulge[1]};
          at_point({p[0] + s * side[0] + f * bulge[0], p[1] + s * side[1] + f * bulge[1]},
                   0.125 * along.w[u] * across.w[v] * cross(to_side, step), upper);
        }
  }
}

// Couples a single point to the face under it, or to the nearest face if none is under it.
void ElementCoupling::at_point(const Vec2& y, double area, Side& upper) {
  upper.map.invert(y, upper.p);
  area *= upper.slope();
  Shape above, below;
  evaluate_shape(upper.type, upper.p.xi, upper.p.eta, above);
  const Under* under = nullptr;
  for (const Under& u : under_)
    if ((!under || u.height < under->height) &&
        std::any_of(u.part.begin(), u.part.end(), [&](const Polygon& p) { return holds(p, y); }))
      under = &u;
  if (under) {
    Side lower(body_, under->face, upper.chart);
    lower.map.invert(y, lower.p);
    evaluate_shape(lower.type, lower.p.xi, lower.p.eta, below);
    add(above, under->face, below, area);
    return;
  }
  const SurfacePoint point = faces_.nearest(upper.patch.origin() + upper.patch.at(upper.p.xi, upper.p.eta).x);
  evaluate_shape(body_.type[at(point.element)], point.xi, point.eta, below);
  add(above, point.element, below, area);
}

// Couples an element that is too warped for its outline to the nearest faces, point by point.
void ElementCoupling::to_nearest(std::int64_t element) {
  Shape below;
  integrate_element(layer_, element, [&](const Shape& shape, const Vec3& x, double area) {
    const SurfacePoint point = faces_.nearest(x);
    evaluate_shape(body_.type[at(point.element)], point.xi, point.eta, below);
    add(shape, point.element, below, area);
  });
}

CoupledNode& ElementCoupling::row(std::int32_t node) {
  std::int32_t& place = place_[at(node)];
  if (place < 0) {
    place = static_cast<std::int32_t>(row_.size());
    row_.emplace_back(CoupledNode{node, {}});
  }
  return row_[at(place)];
}

void ElementCoupling::add(const Shape& upper, std::int64_t face, const Shape& lower, double area) {
  const auto nodes = body_.element(face);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    CoupledNode& r = row(nodes[i]);
    const double w = area * lower.value[i];
    for (std::size_t j = 0; j < columns_; ++j) r.value[j] += w * upper.value[j];
  }
}

// Corrects the integrals, which are not exact over pieces of curved or distorted elements. What is missing of int N_j
// is distributed like the element's loads under a constant traction, which thus keep their proportions.
void ElementCoupling::settle(std::int64_t element) {
  std::array<double, max_element_nodes> missing{};
  integrate_element(layer_, element, [&](const Shape& shape, const Vec3&, double area) {
    for (std::size_t j = 0; j < columns_; ++j) missing[j] += area * shape.value[j];
  });
  double all = 0;
  for (const CoupledNode& r : row_)
    for (std::size_t j = 0; j < columns_; ++j) {
      missing[j] -= r.value[j];
      all += r.value[j];
    }
  for (CoupledNode& r : row_) {
    double constant = 0;
    for (std::size_t j = 0; j < columns_; ++j) constant += r.value[j];
    for (std::size_t j = 0; j < columns_; ++j) r.value[j] += missing[j] * constant / all;
  }
}

}  // namespace rollcon
