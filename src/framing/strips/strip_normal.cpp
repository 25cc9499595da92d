#include <algorithm>
#include <cmath>
#include <limits>

#include "framing/strips/strip_contact.hpp"
#include "linalg/dense.hpp"

namespace rollcon::strips {
namespace {

constexpr int most_rounds = 15;
constexpr double longest_step = 0.3;  // part of a half chord or half width
// Newton's steps square their errors: after a step of this size, over sizes, the next one is lost in rounding.
constexpr double last_step = 3e-7;
constexpr double rounded_step = 1e-5, rounded = 1e-6;  // step that no longer shortens residuals, their size
constexpr double small_step = 1e-3;                    // step after which the same factors may do for another
constexpr double least_share = 0.02;                   // least part of a step that is shortened as residuals grow
// A start is hopeless after so many steps that wanted to be this long, over half chords: in 9,000 solves that ended
// well there were at most three.
constexpr double hopeless_step = 3;
constexpr int most_hopeless = 5;
// Steps with the factors of an earlier solution: how many at most; the longest first one, over sizes, and that from
// which Newton's method is as fast; the greatest ratio of a step to the one before; the size of a step that is left
// out.
constexpr int most_kept = 5;
constexpr double longest_kept = 0.03, long_kept = 3e-3, slowest_kept = 0.02, left_out = 1e-11;

}  // namespace

void StripSolver::sample(const PlaneField* field, std::span<const StripPoint> points, const StripLayout& layout,
                         const double* geometry, Samples& into) {
  const std::size_t n = points.size();
  into.point.resize(n);
  into.slope.resize(n);
  into.value.resize(n);
  for (std::size_t i = 0; i < n; ++i) into.point[i] = {layout.x(points[i], geometry), layout.y(points[i], geometry)};
  if (field) return field->at(into.point, into.value.data(), into.slope.data());
  std::fill(into.value.begin(), into.value.end(), 0.0);
  std::fill(into.slope.begin(), into.slope.end(), Vec2{});
}

void StripSolver::normal_rows(const StripScene& scene, const StripState& state, Rows rows, double* matrix, int columns,
                              int stride, double* residual) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  const double cn = scene.bodies.cn;
  const bool rates = rows == Rows::all;
  const int gap_rows = rows == Rows::pressures ? l.nodes : l.nodes + l.geometry, approach = columns - 1;
  const int fields = integrals_.coupled() ? 3 : 1;
  sample(scene.gap, l.observers, l, g, gap_);
  for (int i = 0; i < gap_rows; ++i) {
    const StripPoint& at = l.observers[i];
    const Observation u = integrals_.observe(Displacement::normal, rates, at, 0);
    residual[i] = gap_.value[i] - state.approach;
    if (rows == Rows::none) {
      for (int k = 0; k < fields; ++k) residual[i] += integrals_.displacement(u, k, k);
      continue;
    }
    double* row = matrix + static_cast<std::ptrdiff_t>(i) * stride;
    std::fill(row, row + stride, 0.0);
    integrals_.add_row(u, 0, 1 / cn, row);
    row[approach] = -1;
    for (int k = 0; k < fields; ++k)
      residual[i] += rates ? integrals_.add_rates(u, k, k, at, 1, row + l.nodes) : integrals_.displacement(u, k, k);
    if (!rates) continue;
    l.add_motion(at, gap_.slope[i][0], gap_.slope[i][1], row + l.nodes);
    if (stride > columns && fields > 1) {
      // Derivatives by tractions go to the columns of friction.
      form_.assign(2 * static_cast<std::size_t>(l.nodes), 0);
      double *u1 = form_.data(), *u2 = u1 + l.nodes;
      integrals_.add_row(u, 1, 1, u1);
      integrals_.add_row(u, 2, 1, u2);
      spread(u1, u2, row + columns);
      spread_bounds(scene, state, u1, u2, row, row + l.nodes);
    }
  }
  double* row = rows == Rows::none ? nullptr : matrix + static_cast<std::ptrdiff_t>(gap_rows) * stride;
  if (row) std::fill(row, row + stride, 0.0);
  if (!scene.by_load) {
    if (row) row[approach] = 1;
    residual[gap_rows] = state.approach - scene.value;
    return;
  }
  // The load over the first width is as large as gaps are.
  double load = -cn * scene.value;
  const double per_length = 1 / g[l.width_of(0)];
  for (int i = 0; i < l.nodes; ++i) {
    const int half = l.half_of(i / l.nodes_each), width = l.width_of(l.part_of(i / l.nodes_each));
    const double unit = l.unit_weight[i], p = cn * state.pressure[i];
    load += unit * g[half] * g[width] * p;
    if (!row) continue;
    row[i] = unit * g[half] * g[width] * per_length;
    if (!rates) continue;
    row[l.nodes + half] += unit * g[width] * p * per_length;
    row[l.nodes + width] += unit * g[half] * p * per_length;
  }
  residual[gap_rows] = load * per_length;
}

// Returns the longest change of a chord or a width, over its half.
double StripSolver::normal_size(const StripState& state, const double* step) {
  const StripLayout& l = state.layout;
  const double *g = state.geometry.data(), *by = step + l.nodes;
  double longest = 0;
  for (int row = 0; row < l.rows; ++row)
    longest = std::max(longest, (std::abs(by[row]) + std::abs(by[l.half_of(row)])) / g[l.half_of(row)]);
  for (int part = 0; part < l.parts; ++part)
    longest =
        std::max(longest, (std::abs(by[l.centre_of(part)]) + std::abs(by[l.width_of(part)])) / g[l.width_of(part)]);
  return longest;
}

// Returns the largest change of a pressure over the highest.
double StripSolver::normal_step(const StripScene& scene, StripState& state, const double* step, double share) {
  const StripLayout& l = state.layout;
  double highest = 0, change = 0;
  for (int i = 0; i < l.nodes; ++i) {
    state.pressure[i] -= share * step[i] / scene.bodies.cn;
    highest = std::max(highest, std::abs(state.pressure[i]));
    change = std::max(change, std::abs(step[i]) / scene.bodies.cn);
  }
  for (int i = 0; i < l.geometry; ++i) state.geometry[i] -= share * step[l.nodes + i];
  state.approach -= share * step[l.nodes + l.geometry];
  return change / highest;
}

void StripSolver::set_fields(const StripState& state) {
  integrals_.set_field(0, state.pressure.data());
  for (int k = 0; k < 2; ++k) integrals_.set_field(1 + k, state.traction.data() + k * state.layout.nodes);
}

bool StripSolver::press_on(const StripScene& scene, StripState& state) {
  // Solves for the pressures of the strips as they are.
  const StripLayout& l = state.layout;
  const int n = l.nodes + 1;
  integrals_.lay(l, scene.bodies, state.geometry.data());
  set_fields(state);
  step_.resize(static_cast<std::size_t>(n + l.geometry));
  normal_rows(scene, state, Rows::pressures, lu_.prepare(n, l.geometry), n, n, step_.data());
  if (!lu_.factor()) return false;
  lu_.solve(step_.data());
  for (int i = 0; i < l.nodes; ++i) state.pressure[i] -= step_[i] / scene.bodies.cn;
  state.approach -= step_[l.nodes];
  return true;
}

// Computes a step with the factors at hand; it leaves an error in proportion to the product of both sizes. Returns the
// longest change of a chord or a width, over its half: infinity where it is no number.
double StripSolver::kept_step(const StripScene& scene, StripState& state, const StripFactors& factors, int n) {
  integrals_.lay(state.layout, scene.bodies, state.geometry.data());
  set_fields(state);
  normal_rows(scene, state, Rows::none, nullptr, n, n, step_.data());
  factors.normal.solve(step_.data());
  const double size = norm2(step_.data(), n);
  return std::isfinite(size) ? normal_size(state, step_.data()) : std::numeric_limits<double>::infinity();
}

// Goes on from a solution nearby with its factors, if they are those of the same strips. Returns whether this solved
// the problem; otherwise the state is one to go on from.
bool StripSolver::press_by_kept(const StripScene& scene, StripState& state, int n) {
  const StripLayout& l = state.layout;
  const StripFactors& f = factors(state);
  if (f.parts != l.parts || f.across != l.across || f.by_load != scene.by_load || f.normal.size() != n) return false;
  double before = 0;
  for (int round = 0; round < most_kept; ++round) {
    const double moved = kept_step(scene, state, f, n);
    if (!(moved < longest_kept)) return false;
    const double change = std::max(moved, normal_step(scene, state, step_.data(), 1));
    if (change < left_out || (round > 0 && change * change < left_out * before)) return true;
    if (change > (round == 0 ? long_kept : slowest_kept * before)) return false;
    before = change;
  }
  return false;
}

StripReport StripSolver::press(const StripScene& scene, StripState& state, StripStart start) {
  const StripLayout& l = state.layout;
  const int n = l.nodes + l.geometry + 1;
  StripReport report{StripStatus::not_converged};
  step_.resize(static_cast<std::size_t>(n));
  StripFactors& f = factors(state);
  if (&f == &large_) f.parts = 0;
  if (start == StripStart::solution && press_by_kept(scene, state, n)) {
    report.status = StripStatus::solved;
    return report;
  }
  if (start != StripStart::solution) {
    state.pressure.assign(static_cast<std::size_t>(l.nodes), 0);
    if (start == StripStart::geometry) state.traction.assign(2 * static_cast<std::size_t>(l.nodes), 0);
    if (!press_on(scene, state)) return report;
  }
  double before = std::numeric_limits<double>::infinity(), share = 0, change = 1;
  int hopeless = 0;
  while (report.normal_rounds++ < most_rounds) {
    integrals_.lay(l, scene.bodies, state.geometry.data());
    set_fields(state);
    residual_.resize(static_cast<std::size_t>(n));
    f.parts = 0;
    normal_rows(scene, state, Rows::all, f.normal.prepare(n), n, n, residual_.data());
    const double now = norm2(residual_.data(), n);
    if (!(now < before) && change < rounded_step) {
      // Rounding alone may be left of residuals, which then are far below the overlap.
      double overlap = 0;
      for (int i = 0; i < l.nodes; ++i) overlap = std::max(overlap, state.approach - gap_.value[i]);
      if (now < rounded * overlap) {
        report.status = StripStatus::solved;
        return report;
      }
    }
    if (!(now < before) && share > least_share) {
      // The step before was too long.
      share /= 2;
      normal_step(scene, state, step_.data(), -share);
      continue;
    }
    before = now;
    if (!f.normal.factor()) return report;
    f.across = l.across;
    f.parts = l.parts;
    f.by_load = scene.by_load;
    step_.swap(residual_);
    f.normal.solve(step_.data());
    const double longest = normal_size(state, step_.data());
    if (!std::isfinite(longest) || (longest > hopeless_step && ++hopeless == most_hopeless)) return report;
    share = longest > longest_step ? longest_step / longest : 1;
    change = std::max(longest, normal_step(scene, state, step_.data(), share));
    const auto last = [&] {
      const double moved = kept_step(scene, state, f, n);
      return std::isfinite(moved) ? std::max(moved, normal_step(scene, state, step_.data(), 1)) : moved;
    };
    if (change < last_step || (change < small_step && last() * change < last_step * last_step)) {
      report.status = StripStatus::solved;
      return report;
    }
  }
  return report;
}

StripTotals StripSolver::totals(const StripState& state) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  StripTotals t;
  t.approach = state.approach;
  t.motion = state.motion;
  for (int i = 0; i < l.nodes; ++i) {
    const double w = l.unit_weight[i] * l.cell(l.node[i], g);
    const double x = l.x(l.centroid[i], g), y = l.y(l.centroid[i], g);
    const double p = w * state.pressure[i], t1 = w * state.traction[i], t2 = w * state.traction[l.nodes + i];
    t.load += p;
    t.pressed = t.pressed + Vec2{p * x, p * y};
    t.force = {t.force[0] + t1, t.force[1] + t2, t.force[2] + x * t2 - y * t1};
  }
  return t;
}

}  // namespace rollcon::strips
