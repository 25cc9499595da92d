#include "bodies/halfspace/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/halfspace/error_model.hpp"
#include "mesh/shape.hpp"
#include "quadrature/cell.hpp"
#include "quadrature/rules.hpp"

namespace rollcon::halfspace {

using quadrature::Vec2;

namespace {

constexpr int max_depth = 120;  ///< halvings of area; what is left is smaller than rounding
constexpr double slender = 4;   ///< sides' ratio from which the longer one is split alone
constexpr double most_gauss_points = 12;  ///< per direction, before a cell is split
constexpr double most_uneven = 0.3;       ///< departure from the tangent map that polar takes
constexpr double reach_affine = 4;        ///< how far outside polar works, in half sizes
constexpr double reach_mapped = 0.3;

/// Position and tangent map at a reference point.
struct Tangent {
  Vec2 x, d_xi, d_eta;
  Vec2 operator()(Vec2 v) const { return v.x * d_xi + v.y * d_eta; }
};

class Integration {
 public:
  Integration(const ElementShape& shape, double px, double py, double tolerance, int terms,
              const Kernels& kernels, NearWorkspace& workspace, double* integral)
      : shape_(shape),
        nodes_(node_count(shape.type)),
        tolerance_(tolerance),
        terms_(terms),
        kernels_(kernels),
        workspace_(workspace),
        integral_(integral) {
    element_.type = shape.type;
    for (int i = 0; i < nodes_; ++i) {
      element_.x[i] = shape.x[i] - px;
      element_.y[i] = shape.y[i] - py;
    }
    workspace_.points.n = 0;
  }

  void run() {
    integrate(whole_element(shape_.type));
    flush();
  }

 private:
  Vec2 position(Vec2 reference) const {
    Shape s;
    evaluate_shape(shape_.type, reference.x, reference.y, s);
    Vec2 x{0, 0};
    for (int i = 0; i < nodes_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      x = x + s.value[k] * Vec2{element_.x[i], element_.y[i]};
    }
    return x;
  }

  Tangent tangent(Vec2 reference) const {
    Shape s;
    evaluate_shape(shape_.type, reference.x, reference.y, s);
    Tangent t{{0, 0}, {0, 0}, {0, 0}};
    for (int i = 0; i < nodes_; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Vec2 node{element_.x[i], element_.y[i]};
      t.x = t.x + s.value[k] * node;
      t.d_xi = t.d_xi + s.d_xi[k] * node;
      t.d_eta = t.d_eta + s.d_eta[k] * node;
    }
    return t;
  }

  /// Newton's method for the observer's reference point; false if it has none within reach.
  bool locate(Vec2 start) {
    Vec2 at = start;
    for (int iteration = 0; iteration < 20; ++iteration) {
      const Tangent t = tangent(at);
      const double jacobian = cross(t.d_xi, t.d_eta);
      if (!(jacobian > 0)) return false;
      const Vec2 step{cross(t.d_eta, t.x) / jacobian, cross(t.x, t.d_xi) / jacobian};
      at = at + step;
      if (!(std::abs(at.x) + std::abs(at.y) < 20)) return false;
      if (std::abs(step.x) + std::abs(step.y) < 1e-11) {
        origin_ = at;
        frame_ = tangent(at);
        return cross(frame_.d_xi, frame_.d_eta) > 0;
      }
    }
    return false;
  }

  void integrate(const Cell& cell) {
    CellShape geometry;
    measure(cell, geometry);
    bool split_first = true, split_second = true;
    if (gauss(cell, geometry, split_first, split_second)) return;
    if (cell.depth >= max_depth) return;
    if (locate(cell.centre()) && polar(cell)) return;
    Cell parts[4];
    const int n = cell.corners == 3
                      ? split_triangle(cell, geometry, parts)
                      : split_square(cell, geometry, split_first, split_second, parts);
    for (int i = 0; i < n; ++i) integrate(parts[i]);
  }

  /// Splitting must make slender cells rounder: the cells between one that is as it was and an
  /// observer beside its long side would otherwise be as many as the sides' ratio.
  int split_square(const Cell& cell, const CellShape& g, bool first, bool second,
                   Cell* parts) const {
    // Mapped elements would need more triangles than squares.
    if (first && second && shape_.map == MapKind::affine) {
      const Vec2 a = g.middle[1] - g.middle[3], b = g.middle[2] - g.middle[0];
      const double aa = dot(a, a), bb = dot(b, b), area = cross(a, b);
      if (slender * slender * area * area < aa * bb) {
        const Vec2 c = g.corner[2] - g.corner[0], d = g.corner[3] - g.corner[1];
        return cell.cut(dot(d, d) < dot(c, c), parts);
      }
      first = aa * slender * slender > bb;
      second = bb * slender * slender > aa;
    }
    return cell.split(first, second, parts);
  }

  static int split_triangle(const Cell& cell, const CellShape& g, Cell* parts) {
    double square[3];
    int longest = 0, shortest = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec2 side = g.corner[(i + 1) % 3] - g.corner[i];
      square[i] = dot(side, side);
      if (square[i] > square[longest]) longest = i;
      if (square[i] < square[shortest]) shortest = i;
    }
    const double height = 2 * g.area / std::sqrt(square[longest]);
    if (!(slender * height < std::sqrt(square[longest]))) return cell.split(true, true, parts);
    if (square[shortest] > 4 * height * height) {
      const int next = (longest + 1) % 3;
      const Vec2 base = g.corner[next] - g.corner[longest],
                 apex = g.corner[(longest + 2) % 3] - g.corner[longest];
      return cell.split_at_foot(longest, dot(base, apex) / dot(base, base), parts);
    }
    // Of the trapezoid beside the shortest side, the shorter diagonal.
    const int next = (shortest + 1) % 3, tip = (shortest + 2) % 3;
    const Vec2 one = 0.5 * (g.corner[next] + g.corner[tip]) - g.corner[shortest],
               other = 0.5 * (g.corner[shortest] + g.corner[tip]) - g.corner[next];
    return cell.split_needle(shortest, dot(other, other) < dot(one, one), parts);
  }

  void measure(const Cell& cell, CellShape& g) const {
    const int n = cell.corners;
    for (int i = 0; i < n; ++i) {
      g.corner[i] = position(cell.corner[i]);
      g.middle[i] = position(0.5 * (cell.corner[i] + cell.corner[(i + 1) % n]));
    }
    g.centre = position(cell.centre());
    double longest = 0;
    for (int i = 0; i < n; ++i) {
      const Vec2 side = g.corner[(i + 1) % n] - g.corner[i];
      longest = std::max(longest, dot(side, side));
    }
    g.half_length = 0.5 * std::sqrt(longest);
    const Vec2 a = n == 3 ? g.corner[1] - g.corner[0] : g.corner[2] - g.corner[0];
    const Vec2 b = n == 3 ? g.corner[2] - g.corner[0] : g.corner[3] - g.corner[1];
    g.area = 0.5 * std::abs(cross(a, b));
  }

  /// Gauss's rule if few enough points do; else says which directions ask for a split.
  bool gauss(const Cell& cell, const CellShape& g, bool& split_first, bool& split_second) {
    const double distance = std::max(std::sqrt(dot(g.centre, g.centre)), 0.5 * g.half_length);
    const double safety = shape_.map == MapKind::affine ? 1 : 10;
    const double tolerance = tolerance_ * distance / (safety * g.area);
    if (cell.corners == 3) {
      const int p = corner_count(shape_.type) == 3 ? direction_degree(shape_.type, shape_.map)
                                                   : ray_degree(shape_.type, shape_.map);
      double rho = 1e300;
      for (int i = 0; i < 3; ++i)
        rho = std::min(rho, ellipse_parameter(g.corner[i], g.middle[i], g.corner[(i + 1) % 3]));
      const double degree = needed_degree(rho, p, tolerance);
      for (const TriangleRule& rule : symmetric_triangle_rules())
        if (rule.degree >= degree) return triangle_gauss(cell, rule);
      return false;
    }
    const int p = direction_degree(shape_.type, shape_.map);
    const double first = std::min({ellipse_parameter(g.corner[0], g.middle[0], g.corner[1]),
                                   ellipse_parameter(g.middle[3], g.centre, g.middle[1]),
                                   ellipse_parameter(g.corner[3], g.middle[2], g.corner[2])});
    const double second = std::min({ellipse_parameter(g.corner[0], g.middle[3], g.corner[3]),
                                    ellipse_parameter(g.middle[0], g.centre, g.middle[2]),
                                    ellipse_parameter(g.corner[1], g.middle[1], g.corner[2])});
    const double n1 = needed_points(first, p, tolerance), n2 = needed_points(second, p, tolerance);
    split_first = !(n1 <= most_gauss_points);
    split_second = !(n2 <= most_gauss_points);
    if (!split_first && !split_second)
      return square_gauss(cell, static_cast<int>(n1), static_cast<int>(n2));
    return false;
  }

  bool triangle_gauss(const Cell& cell, const TriangleRule& rule) {
    const Vec2 a = cell.corner[1] - cell.corner[0], b = cell.corner[2] - cell.corner[0];
    const double area = cross(a, b);
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      add(cell.corner[0] + rule.points.xi[q] * a + rule.points.eta[q] * b, area * rule.points.w[q]);
    return true;
  }

  bool square_gauss(const Cell& cell, int n1, int n2) {
    const LineRule &rule1 = line_rule(n1), &rule2 = line_rule(n2);
    const Vec2 a = 0.5 * (cell.corner[1] - cell.corner[0]);
    const Vec2 b = 0.5 * (cell.corner[3] - cell.corner[0]);
    const Vec2 c = cell.centre();
    const double area = cross(a, b);
    for (std::size_t i = 0; i < rule1.x.size(); ++i)
      for (std::size_t j = 0; j < rule2.x.size(); ++j)
        add(c + rule1.x[i] * a + rule2.x[j] * b, area * rule1.w[i] * rule2.w[j]);
    return true;
  }

  /// Signed triangles from the observer's reference point to the cell's edges.
  bool polar(const Cell& cell) {
    const double reach = shape_.map == MapKind::affine ? reach_affine : reach_mapped;
    if (!(cell.distance_outside(origin_) <= reach)) return false;
    EdgeView view[4];
    for (int i = 0; i < cell.corners; ++i) {
      view[i] = look(cell.corner[i], cell.corner[(i + 1) % cell.corners]);
      if (view[i].uneven > most_uneven) return false;
    }
    for (int i = 0; i < cell.corners; ++i)
      if (view[i].share > 0) polar_edge(view[i]);
    return true;
  }

  /// An edge of a cell in the metric of the tangent map, as the observer sees it.
  struct EdgeView {
    Vec2 a, b;          ///< the edge is origin + a + t b, 0 <= t <= 1
    double t0, eta;     ///< foot and height of the observer, in units of t
    double u1, u2;      ///< of the ends: t = t0 + eta sinh(u)
    double share = 0;   ///< in the integral of 1/r; 0 if it does not count
    double uneven = 0;  ///< largest relative departure of the map from its tangent
  };

  EdgeView look(Vec2 begin, Vec2 end) const {
    EdgeView view;
    view.a = begin - origin_;
    view.b = end - begin;
    const Vec2 pa = frame_(view.a), pb = frame_(view.b);
    const double length2 = dot(pb, pb), height = std::abs(cross(pa, pb)) / std::sqrt(length2);
    // On the edge up to rounding; the points of a thinner triangle could not be told from ours.
    if (!(height > 1e-14 * shape_.half_length)) return view;
    view.eta = height / std::sqrt(length2);
    view.t0 = -dot(pa, pb) / length2;
    view.u1 = std::asinh(-view.t0 / view.eta);
    view.u2 = std::asinh((1 - view.t0) / view.eta);
    const double share = height * (view.u2 - view.u1);
    if (!(share > 1e-3 * tolerance_)) return view;
    view.share = share;
    if (shape_.map == MapKind::affine) return view;
    // Where the ray is shortest, and all along: past a second zero of the map the rays would run
    // over the observer once more.
    const int steps = is_quadratic(shape_.type) ? 8 : 2;
    for (int k = 0; k <= steps; ++k)
      view.uneven = std::max(view.uneven, unevenness(view.a + double(k) / steps * view.b));
    for (const double t : {view.t0, view.t0 - view.eta, view.t0 + view.eta, view.t0 - 3 * view.eta,
                           view.t0 + 3 * view.eta})
      if (t >= 0 && t <= 1) view.uneven = std::max(view.uneven, unevenness(view.a + t * view.b));
    return view;
  }

  /// Relative departure of the map from its tangent at the end of a ray.
  double unevenness(Vec2 ray) const {
    const Vec2 linear = frame_(ray), d = position(origin_ + ray) - linear;
    return std::sqrt(dot(d, d) / dot(linear, linear));
  }

  void polar_edge(const EdgeView& view) {
    const double span = view.u2 - view.u1;
    const double safety = shape_.map == MapKind::affine ? 3 : 300;
    const double tolerance = tolerance_ / (safety * view.share);
    const LineRule& along = line_rule(ray_points(view.uneven, tolerance));
    int pieces = 1;
    const LineRule& around = line_rule(angle_points(span, view.uneven, tolerance, pieces));
    const double half = 0.5 * span / pieces, area = cross(view.a, view.b);
    for (int k = 0; k < pieces; ++k) {
      const double middle = view.u1 + (2 * k + 1) * half;
      for (std::size_t j = 0; j < around.x.size(); ++j) {
        const double e = std::exp(middle + half * around.x[j]);
        const double t = view.t0 + 0.5 * view.eta * (e - 1 / e);
        const double weight = area * around.w[j] * half * 0.5 * view.eta * (e + 1 / e);
        const Vec2 ray = view.a + t * view.b;
        for (std::size_t i = 0; i < along.x.size(); ++i) {
          const double s = 0.5 * (1 + along.x[i]);
          add(origin_ + s * ray, weight * s * 0.5 * along.w[i]);
        }
      }
    }
  }

  /// Along a ray: a polynomial, times the map's departure from its tangent, which is singular at
  /// about s = 1/uneven.
  int ray_points(double uneven, double tolerance) const {
    const int p = ray_degree(shape_.type, shape_.map);
    int n = p / 2 + 1;
    if (uneven > 0 && tolerance < uneven) {
      const double z = 2 / uneven - 1, rho = z + std::sqrt(z * z - 1);
      n = std::max(n,
                   static_cast<int>(std::ceil(
                       0.5 * (p + std::log(rule_constant * uneven / tolerance) / std::log(rho)))));
    }
    return std::min(n, max_line_points);
  }

  /// In the angle: singular at u = +- i pi/2, where the ray's length vanishes.
  int angle_points(double span, double uneven, double tolerance, int& pieces) const {
    const double pole = 0.5 * std::numbers::pi * (1 - uneven);
    const double digits = std::log(20 / std::min(tolerance, 1.0));
    int best = 0;
    double cost = 1e300;
    for (int m = 1; m <= 24; ++m) {
      const double z = 2 * pole * m / span, rho = z + std::sqrt(1 + z * z);
      const int n = std::max(2, static_cast<int>(std::ceil(0.5 * digits / std::log(rho))) + 1);
      if (n <= max_line_points && n * m < cost) {
        cost = n * m;
        best = n;
        pieces = m;
      }
      if (m > 2 && n <= 4) break;
    }
    return best > 0 ? best : max_line_points;
  }

  void add(Vec2 reference, double weight) {
    NearPoints& p = workspace_.points;
    if (p.n == near_capacity) flush();
    p.xi[p.n] = reference.x;
    p.eta[p.n] = reference.y;
    p.w[p.n++] = weight;
  }

  void flush() {
    if (workspace_.points.n == 0) return;
    workspace_.evaluations += workspace_.points.n;
    kernels_.near(element_, workspace_.points, terms_, integral_);
    workspace_.points.n = 0;
  }

  const ElementShape& shape_;
  const int nodes_;
  const double tolerance_;
  const int terms_;
  const Kernels& kernels_;
  NearWorkspace& workspace_;
  double* integral_;
  NearElement element_;
  Vec2 origin_{};
  Tangent frame_{};
};

}  // namespace

void near_integrals(const ElementShape& element, double px, double py, double tolerance, int terms,
                    const Kernels& kernels, NearWorkspace& workspace, double* integral) {
  Integration(element, px, py, tolerance, terms, kernels, workspace, integral).run();
}

}  // namespace rollcon::halfspace
