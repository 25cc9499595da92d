#include "quadrature/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "quadrature/lines.hpp"
#include "quadrature/plane_part.hpp"
#include "quadrature/polar.hpp"
#include "quadrature/rules.hpp"

namespace rollcon::quadrature {
namespace {

constexpr int max_depth = 100;  ///< halvings of area; what is left is smaller than rounding
constexpr int too_many = 99;
constexpr double most_uneven = 0.3;  ///< departure from the tangent map that polar takes
// Polar coordinates work so far outside, in half sizes: not where nodes of regular grids lie, or rounding would choose.
// Slender triangles have many neighbours in their reach; round ones have Gauss's rules long before. Quadratic shape
// functions grow too fast outside, and lose digits; slender parallelograms have lines instead.
constexpr double reach_linear_triangle = 40.3;
constexpr double reach_affine = 2.5;
constexpr double reach_mapped = 0.3;
constexpr double reach_plane = 0.6;   ///< beside parts taken in their plane
constexpr double least_slender = 16;  ///< length over width from where lines and the plane save points
constexpr int most_lines = 16;
constexpr double least_series_log = 1.3;  ///< for parts taken in their plane: about 12 points for nine digits

class Integration {
 public:
  Integration(const ElementGeometry& element, Tolerance tolerance, bool strong, NearWorkspace& workspace,
              const std::function<void()>& kernel)
      : element_(element), tolerance_(tolerance), strong_(strong), workspace_(workspace), kernel_(kernel) {
    workspace_.points.n = 0;
  }

  void run(const OnElement& on) {
    if (on.known) set_foot(find_foot(element_, on.reference, true));
    integrate(whole_element(element_.type), element_.shape);
    flush();
  }

 private:
  void integrate(const Cell& cell, const CellShape& shape) {
    Selection selection{too_many, too_many, false};
    const bool touched = foot_inside_ && foot_.height == 0 && cell.distance_outside(foot_.reference) <= 1e-12;
    if (!touched) selection = select_rule(element_, shape, tolerance_);
    if (selection.gauss)
      return cell.corners == 3 ? triangle_gauss(cell, selection.first)
                               : square_gauss(cell, selection.first, selection.second);
    if (cell.depth >= max_depth) return;
    if (!foot_.found) set_foot(find_foot(element_, cell.centre(), false));
    if (foot_.found && polar(cell)) return;
    const int along = slender(cell, shape);
    std::optional<PlanePart> part;
    if (along >= 0) part = plane_part(element_, cell, shape);
    if (part && (lines(*part, shape) || in_plane(*part, shape))) return;
    bool first = selection.first > most_line_points, second = selection.second > most_line_points;
    if (part) {
      first = along == 0;
      second = along == 1;
    }
    Cell parts[4];
    const int n = cell.corners == 3 ? halve(cell, shape, parts) : cell.split(first, second, parts);
    for (int i = 0; i < n; ++i) integrate(parts[i], measure(element_, parts[i]));
  }

  /// Cuts a triangle across its longest side, so that parts of a slender one get better shapes.
  static int halve(const Cell& cell, const CellShape& shape, Cell* parts) {
    int longest = 0;
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      const double side = length(shape.corner[(i + 1) % 3] - shape.corner[i]);
      if (side > most) {
        most = side;
        longest = i;
      }
    }
    const Vec2 a = cell.corner[longest], b = cell.corner[(longest + 1) % 3], c = cell.corner[(longest + 2) % 3],
               middle = 0.5 * (a + b);
    parts[0] = {3, {a, middle, c, {}}, cell.depth + 1};
    parts[1] = {3, {middle, b, c, {}}, cell.depth + 1};
    return 2;
  }

  void set_foot(const Foot& foot) {
    foot_ = foot;
    foot_inside_ = foot.found && whole_element(element_.type).distance_outside(foot.reference) <= 1e-9;
  }

  void triangle_gauss(const Cell& cell, int degree) {
    const Vec2 a = cell.corner[1] - cell.corner[0], b = cell.corner[2] - cell.corner[0];
    const double area = cross(a, b);
    for (const TriangleRule& rule : symmetric_triangle_rules())
      if (rule.degree >= degree) {
        for (std::size_t q = 0; q < rule.points.size(); ++q)
          add(cell.corner[0] + rule.points.xi[q] * a + rule.points.eta[q] * b, area * rule.points.w[q]);
        return;
      }
  }

  void square_gauss(const Cell& cell, int n1, int n2) {
    const LineRule &rule1 = line_rule(n1), &rule2 = line_rule(n2);
    const Vec2 a = 0.5 * (cell.corner[1] - cell.corner[0]);
    const Vec2 b = 0.5 * (cell.corner[3] - cell.corner[0]);
    const Vec2 c = cell.centre();
    const double area = cross(a, b);
    for (std::size_t i = 0; i < rule1.x.size(); ++i)
      for (std::size_t j = 0; j < rule2.x.size(); ++j)
        add(c + rule1.x[i] * a + rule2.x[j] * b, area * rule1.w[i] * rule2.w[j]);
  }

  /// Returns the direction along the element in which the cell is much longer than wide, or -1. Where the ends are
  /// slanted, cuts along the other direction would make parts that all lie side by side along the point, as many as the
  /// element is slender.
  int slender(const Cell& cell, const CellShape& shape) const {
    if (cell.corners == 3 || element_.map == MapKind::curved) return -1;
    const int along = element_.half[0] >= element_.half[1] ? 0 : 1;
    const double middle = length(along == 0 ? shape.middle[1] - shape.middle[3] : shape.middle[2] - shape.middle[0]);
    return middle * middle > least_slender * shape.area ? along : -1;
  }

  /// Integrates along lines, where Gauss's rule serves in one direction only.
  bool lines(const PlanePart& part, const CellShape& shape) {
    const int longer = length(shape.middle[1] - shape.middle[3]) > length(shape.middle[2] - shape.middle[0]) ? 0 : 1;
    return lines_along(part, shape, longer) || lines_along(part, shape, 1 - longer);
  }

  bool lines_along(const PlanePart& part, const CellShape& shape, int along) {
    const Cell& cell = part.cell;
    const Vec2 half1 = 0.5 * (cell.corner[1] - cell.corner[0]), half2 = 0.5 * (cell.corner[3] - cell.corner[0]);
    const Vec2 a = along == 0 ? half1 : half2, b = along == 0 ? half2 : half1, centre = cell.centre(),
               foot = part.local(part.foot.reference);
    const double area = cross(half1, half2);
    const Lines lines = lines_across(element_, shape, along, along == 0 ? foot.x : foot.y, tolerance_);
    if (lines.number > most_lines) return false;
    const LineRule &outer = line_rule(lines.number), &inner = line_rule(lines.points);
    for (std::size_t i = 0; i < outer.x.size(); ++i) {
      const SinhMap map = lines.line(outer.x[i]);
      const double half = 0.5 * (map.u2 - map.u1) / lines.pieces;
      for (int k = 0; k < lines.pieces; ++k)
        for (std::size_t j = 0; j < inner.x.size(); ++j) {
          const double e = std::exp(map.u1 + half * (2 * k + 1 + inner.x[j]));
          add(centre + (map.t0 + 0.5 * map.eta * (e - 1 / e)) * a + outer.x[i] * b,
              area * outer.w[i] * inner.w[j] * half * 0.5 * map.eta * (e + 1 / e));
        }
    }
    return true;
  }

  /// Sums signed triangles from the foot to the sides, all in the element's plane.
  bool in_plane(const PlanePart& part, const CellShape& shape) {
    if (part.series_log < least_series_log) return false;
    const Foot& foot = part.foot;
    const double outside = std::max(std::abs(foot.reference.x), std::abs(foot.reference.y)) - 1;
    if (outside > reach_plane) return false;
    if (!weak() && outside > 0 && foot.height <= outside * shape.half_length) return false;
    part_ = &part;
    for (int i = 0; i < 4; ++i) {
      const EdgeView view = view_edge(part.affine, foot, part.corner(i), part.corner(i + 1), tolerance_);
      if (view.counts) polar_edge(part.affine, foot, view);
    }
    part_ = nullptr;
    return true;
  }

  /// Says whether the foot serves for polar coordinates. With the foot outside of the cell, its surroundings are added
  /// and taken away again, without loss where the integrand there is no larger than on the cell itself.
  bool foot_serves(const Cell& cell) const {
    const double outside = cell.distance_outside(foot_.reference);
    if (outside <= 1e-12) return true;
    const double reach = element_.map != MapKind::affine      ? reach_mapped
                         : element_.type == ElementType::tri3 ? reach_linear_triangle
                                                              : reach_affine;
    if (outside > reach) return false;
    return weak() || foot_.height > outside_length(cell);
  }

  /// Says that no kernel is strongly singular about the foot: a point on the element has N(x) taken away.
  bool weak() const { return !strong_ || (foot_.height == 0 && foot_inside_); }

  /// Returns about how far outside of the cell the foot lies.
  double outside_length(const Cell& cell) const {
    double longest = 0;
    for (int i = 0; i < cell.corners; ++i)
      longest = std::max(longest, length(foot_.tangent(cell.corner[(i + 1) % cell.corners] - cell.corner[i])));
    return 0.5 * longest * cell.distance_outside(foot_.reference);
  }

  /// Sums signed triangles from the foot to the cell's edges.
  bool polar(const Cell& cell) {
    if (!foot_serves(cell)) return false;
    EdgeView view[4];
    for (int i = 0; i < cell.corners; ++i) {
      view[i] = view_edge(element_, foot_, cell.corner[i], cell.corner[(i + 1) % cell.corners], tolerance_);
      if (view[i].uneven > most_uneven) return false;
    }
    for (int i = 0; i < cell.corners; ++i)
      if (view[i].counts) polar_edge(element_, foot_, view[i]);
    return true;
  }

  void polar_edge(const ElementGeometry& element, const Foot& foot, const EdgeView& view) {
    const PolarRule rule = polar_rule(element, foot, view, tolerance_);
    const LineRule& around = line_rule(rule.angle);
    const double half = 0.5 * (view.u2 - view.u1) / rule.angle_pieces;
    const double area = cross(view.a, view.b);
    for (int k = 0; k < rule.angle_pieces; ++k) {
      const double middle = view.u1 + (2 * k + 1) * half;
      for (std::size_t j = 0; j < around.x.size(); ++j) {
        const double e = std::exp(middle + half * around.x[j]);
        const double t = view.t0 + 0.5 * view.eta * (e - 1 / e);
        const double weight = area * around.w[j] * half * 0.5 * view.eta * (e + 1 / e);
        ray(foot, view.a + t * view.b, weight, rule);
      }
    }
  }

  void ray(const Foot& foot, Vec2 direction, double weight, const PolarRule& rule) {
    const LineRule& line = line_rule(rule.ray);
    const double d = foot.height;
    const double scale = d / length(foot.tangent(direction));
    const double half = 0.5 * (d > 0 ? std::asinh(1 / scale) : 1) / rule.ray_pieces;
    for (int k = 0; k < rule.ray_pieces; ++k)
      for (std::size_t i = 0; i < line.x.size(); ++i) {
        const double v = half * (2 * k + 1 + line.x[i]);
        double s = v, slope = 1;
        if (d > 0) {
          const double e = std::exp(v);
          s = 0.5 * scale * (e - 1 / e);
          slope = 0.5 * scale * (e + 1 / e);
        }
        add(foot.reference + s * direction, weight * s * slope * half * line.w[i]);
      }
  }

  void add(Vec2 reference, double weight) {
    if (part_) part_->place(reference, weight);
    NearPoints& p = workspace_.points;
    if (p.n == near_capacity) flush();
    p.xi[p.n] = reference.x;
    p.eta[p.n] = reference.y;
    p.w[p.n++] = weight;
  }

  void flush() {
    if (workspace_.points.n == 0) return;
    workspace_.evaluations += workspace_.points.n;
    kernel_();
    workspace_.points.n = 0;
  }

  const ElementGeometry& element_;
  const Tolerance tolerance_;
  const bool strong_;
  NearWorkspace& workspace_;
  const std::function<void()>& kernel_;
  Foot foot_;
  bool foot_inside_ = false;
  const PlanePart* part_ = nullptr;  ///< part in whose coordinates the points are; null: the element's
};

}  // namespace

void near_field(const ElementGeometry& element, const Vec3& point, const OnElement& on, Tolerance tolerance,
                bool strong, NearWorkspace& workspace, const std::function<void()>& kernel) {
  // Coordinates relative to the point, which kernels use, lose no digits where the element is close to it.
  ElementGeometry relative = element;
  for (std::size_t j = 0; j < 3; ++j)
    for (double& node : relative.node[j]) node -= point[j];
  relative.shape = seen_from(element.shape, point);
  Integration(relative, tolerance, strong, workspace, kernel).run(on);
}

}  // namespace rollcon::quadrature
