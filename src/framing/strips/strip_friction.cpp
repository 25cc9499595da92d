#include <algorithm>
#include <cmath>

#include "framing/strips/strip_contact.hpp"
#include "linalg/dense.hpp"

namespace rollcon::strips {
namespace {

constexpr int most_rounds = 60;
constexpr double converged = 1e-11;  // residual of the laws over the largest bound
// Steps with kept factors: the residual, over the largest bound, to begin with, and what steps leave of it at most.
constexpr double first_kept = 0.05, rate_of_kept = 0.02;

}  // namespace

void StripSolver::rigid_slip(const StripScene& scene, const StripState& state) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  rigid_.resize(2 * static_cast<std::size_t>(l.nodes));
  for (int k = 0; k < 2; ++k) sample(scene.slip[k], l.slip_place, l, g, slip_[k]);
  for (int i = 0; i < l.nodes; ++i) {
    rigid_[i] = slip_[0].value[i];
    rigid_[l.nodes + i] = slip_[1].value[i];
  }
}

void StripSolver::slip_rows(const StripScene& scene, const StripState& state, bool rates) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  const std::size_t n = static_cast<std::size_t>(l.nodes);
  const int kinds = integrals_.kinds(Displacement::slip);
  for (int k = 0; k < kinds; ++k) compliance_[k].assign(n * n, 0);
  if (rates) slip_rates_.assign(2 * n * l.geometry, 0);
  slip_now_.resize(2 * n);
  // Kinds of displacement for the fields 0 to 2, for slip along x and along y.
  constexpr int kind_of[2][3] = {{3, 0, 1}, {4, 1, 2}};
  rigid_slip(scene, state);
  for (int i = 0; i < l.nodes; ++i) {
    const int half = l.half_of(i / l.nodes_each);
    const double per = 1 / (l.spacing[i] * g[half]);
    const Observation here = integrals_.observe(Displacement::slip, rates, l.node[i], 0),
                      there = integrals_.observe(Displacement::slip, rates, l.upstream[i], 1);
    for (int k = 0; k < kinds; ++k) {
      integrals_.add_row(here, k, per, compliance_[k].data() + i * n);
      integrals_.add_row(there, k, -per, compliance_[k].data() + i * n);
    }
    for (int d = 0; d < 2 && rates; ++d) {
      double* row = slip_rates_.data() + (d * n + i) * l.geometry;
      for (int field = integrals_.coupled() ? 0 : 1; field < 3; ++field) {
        const int k = kind_of[d][field];
        const double u = integrals_.add_rates(here, k, field, l.node[i], per, row),
                     v = integrals_.add_rates(there, k, field, l.upstream[i], -per, row);
        row[half] -= (u - v) * per / g[half];
      }
    }
  }
  for (int i = 0; i < l.nodes; ++i) {
    const auto carry_from_next = [&](std::vector<double>& rows, std::size_t first, int columns) {
      const auto [own, next, after] = l.carry[i];
      if (next == 0) return;
      double* row = rows.data() + (first + i) * columns;
      for (int j = 0; j < columns; ++j) row[j] = own * row[j] + next * row[j + columns] + after * row[j + 2 * columns];
    };
    for (int k = 0; k < kinds; ++k) carry_from_next(compliance_[k], 0, l.nodes);
    for (int d = 0; d < 2 && rates; ++d) {
      carry_from_next(slip_rates_, d * n, l.geometry);
      const Vec2 slope = slip_[d].slope[i];
      const double spin = state.motion[2];
      l.add_motion(l.slip_place[i], slope[0] + (d == 1 ? spin : 0), slope[1] - (d == 0 ? spin : 0),
                   slip_rates_.data() + (d * n + i) * l.geometry);
    }
  }
  // Scales of the laws: traction per slip.
  scale_.resize(n);
  const double *a = compliance_[0].data(), *b = compliance_[1].data(), *c = compliance_[2].data();
  for (std::size_t i = 0; i < n; ++i, a += n, b += n, c += n) {
    double first = 0, second = 0;
    for (std::size_t j = 0; j < n; ++j) {
      first += a[j] * a[j] + b[j] * b[j];
      second += b[j] * b[j] + c[j] * c[j];
    }
    scale_[i] = 1 / std::sqrt(std::max(first, second));
  }
}

void StripSolver::slip(const StripState& state) {
  const StripLayout& l = state.layout;
  const double *t1 = state.traction.data(), *t2 = t1 + l.nodes, *p = state.pressure.data();
  for (int i = 0; i < l.nodes; ++i) {
    const Vec2 at = slip_[0].point[i];
    double s1 = rigid_[i] + state.motion[0] - state.motion[2] * at[1],
           s2 = rigid_[l.nodes + i] + state.motion[1] + state.motion[2] * at[0];
    const double *a = compliance_[0].data() + static_cast<std::ptrdiff_t>(i) * l.nodes,
                 *b = compliance_[1].data() + static_cast<std::ptrdiff_t>(i) * l.nodes,
                 *c = compliance_[2].data() + static_cast<std::ptrdiff_t>(i) * l.nodes;
    s1 += dot(a, t1, l.nodes) + dot(b, t2, l.nodes);
    s2 += dot(b, t1, l.nodes) + dot(c, t2, l.nodes);
    if (integrals_.coupled()) {
      s1 += dot(compliance_[3].data() + static_cast<std::ptrdiff_t>(i) * l.nodes, p, l.nodes);
      s2 += dot(compliance_[4].data() + static_cast<std::ptrdiff_t>(i) * l.nodes, p, l.nodes);
    }
    slip_now_[i] = s1;
    slip_now_[l.nodes + i] = s2;
  }
}

// Nodes that stick slip by what rounding leaves.
void StripSolver::keep_slip(StripState& state) const {
  state.slip = slip_now_;
  const std::size_t n = laws_.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!laws_[i].slides) state.slip[i] = state.slip[n + i] = 0;
}

void StripSolver::bounds(const StripScene& scene, const StripState& state) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  bound_.resize(static_cast<std::size_t>(l.nodes));
  if (scene.friction) sample(scene.friction, l.node, l, g, friction_);
  for (int i = 0; i < l.nodes; ++i) {
    bound_[i] = scene.mu * (scene.friction ? friction_.value[i] : 1) * std::max(state.pressure[i], 0.0);
  }
}

void StripSolver::load_errors(const StripScene& scene, const StripState& state) {
  const StripTotals t = totals(state);
  for (int k = 0; k < 3; ++k) load_error_[k] = scene.force_given[k] ? t.force[k] - scene.motion[k] : 0;
}

double StripSolver::judge(const StripScene& scene, const StripState& state) {
  const StripLayout& l = state.layout;
  laws_.resize(static_cast<std::size_t>(l.nodes));
  const double* g = state.geometry.data();
  double worst = 0, largest = 0, limit = 0;  // limit: the force of all nodes sliding
  for (int i = 0; i < l.nodes; ++i) {
    const double t1 = state.traction[i], t2 = state.traction[l.nodes + i], r = scale_[i];
    const double a1 = t1 - r * slip_now_[i], a2 = t2 - r * slip_now_[l.nodes + i], length = std::hypot(a1, a2);
    Law& law = laws_[i];
    law.slides = !(length < bound_[i]);
    law.share = law.slides && length > 0 ? bound_[i] / length : 1;
    law.along = length > 0 ? Vec2{a1 / length, a2 / length} : Vec2{1, 0};
    worst = std::max(worst, std::hypot(t1 - law.share * a1, t2 - law.share * a2));
    largest = std::max(largest, bound_[i]);
    limit += bound_[i] * l.unit_weight[i] * l.cell(l.node[i], g);
  }
  double residual = largest > 0 ? worst / largest : 0;
  friction_limit_ = limit;
  load_errors(scene, state);
  for (int k = 0; k < 3; ++k) {
    const double scale = limit * (k == 2 ? state.geometry[l.width_of(0)] : 1);
    if (scene.force_given[k]) residual = std::max(residual, std::abs(load_error_[k]) / scale);
  }
  return residual;
}

// Columns of a linear form in the tractions, sum of u t1 + v t2: two of a node that sticks, one of a node that slides,
// across its direction.
double* StripSolver::spread(const double* u, const double* v, double* to) const {
  for (std::size_t j = 0; j < laws_.size(); ++j) {
    const Law& law = laws_[j];
    if (law.slides) {
      *to++ = v[j] * law.along[0] - u[j] * law.along[1];
    } else {
      *to++ = u[j];
      *to++ = v[j];
    }
  }
  return to;
}

// Writes the form by pressures (over cn) and geometry, on which the tractions of nodes that slide depend.
void StripSolver::spread_bounds(const StripScene& scene, const StripState& state, const double* u, const double* v,
                                double* pressure, double* geometry) const {
  const StripLayout& l = state.layout;
  for (int j = 0; j < l.nodes; ++j) {
    if (!laws_[j].slides) continue;
    const double along = u[j] * laws_[j].along[0] + v[j] * laws_[j].along[1];
    pressure[j] += along * scene.mu * (scene.friction ? friction_.value[j] : 1) / scene.bodies.cn;
    if (!scene.friction) continue;
    const double by = along * scene.mu * state.pressure[j];
    l.add_motion(l.node[j], by * friction_.slope[j][0], by * friction_.slope[j][1], geometry);
  }
}

int StripSolver::reduced_size() const {
  int size = 0;
  for (const Law& law : laws_) size += law.slides ? 1 : 2;
  return size;
}

void StripSolver::put_on_bounds(StripState& state) const {
  const std::size_t n = laws_.size();
  for (std::size_t i = 0; i < n; ++i)
    if (laws_[i].slides) {
      state.traction[i] = bound_[i] * laws_[i].along[0];
      state.traction[n + i] = bound_[i] * laws_[i].along[1];
    }
}

// Rows of a step. With e the direction, b the bound, g = b over the augmented traction's length:
//   stick: s = 0;   slide: t = b e + z k, k across e, (1 - g) z + g r k.s = 0;   loads that are given
// Columns: z or t, motions whose loads are given; if complete, pressures, geometry and approach before.
void StripSolver::friction_rows(const StripScene& scene, const StripState& state, bool complete, double* row,
                                int columns) {
  const StripLayout& l = state.layout;
  const int n = l.nodes, before = complete ? n + l.geometry + 1 : 0;
  form_.resize(2 * static_cast<std::size_t>(n));
  double *u = form_.data(), *v = u + n;
  for (int i = 0; i < n; ++i) {
    const Law& law = laws_[i];
    const auto at = static_cast<std::ptrdiff_t>(i) * n;
    const double *a = compliance_[0].data() + at, *b = compliance_[1].data() + at, *c = compliance_[2].data() + at;
    const double f = law.share * scale_[i];
    for (int d = 0; d < (law.slides ? 1 : 2); ++d, row += columns) {
      const double r1 = law.slides ? -f * law.along[1]
                        : d == 0   ? scale_[i]
                                   : 0,
                   r2 = law.slides ? f * law.along[0]
                        : d == 1   ? scale_[i]
                                   : 0;
      for (int j = 0; j < n; ++j) {
        u[j] = r1 * a[j] + r2 * b[j];
        v[j] = r1 * b[j] + r2 * c[j];
      }
      if (complete) {
        std::fill(row, row + before, 0.0);
        spread_bounds(scene, state, u, v, row, row + n);
        const double* rate = slip_rates_.data() + static_cast<std::ptrdiff_t>(i) * l.geometry;
        axpy(r1, rate, row + n, l.geometry);
        axpy(r2, rate + static_cast<std::ptrdiff_t>(n) * l.geometry, row + n, l.geometry);
        for (int k = 0; k < 2 && integrals_.coupled(); ++k)
          axpy((k == 0 ? r1 : r2) / scene.bodies.cn, compliance_[3 + k].data() + at, row, n);
      }
      // The node's own column, across the direction, has 1 - g more.
      u[i] -= law.slides ? (1 - law.share) * law.along[1] : 0;
      v[i] += law.slides ? (1 - law.share) * law.along[0] : 0;
      double* to = spread(u, v, row + before);
      const Vec2 place = slip_[0].point[i];
      if (scene.force_given[0]) *to++ = r1;
      if (scene.force_given[1]) *to++ = r2;
      if (scene.force_given[2]) *to++ = r2 * place[0] - r1 * place[1];
    }
  }
  for (int k = 0; k < 3; ++k) {
    if (!scene.force_given[k]) continue;
    std::fill(row, row + columns, 0.0);
    total_slope_.assign(static_cast<std::size_t>(n + l.geometry), 0);
    total_slopes(state, k, total_slope_.data(), u, v);
    if (complete) {
      std::copy(total_slope_.begin() + n, total_slope_.end(), row + n);
      spread_bounds(scene, state, u, v, row, row + n);
    }
    spread(u, v, row + before);
    row += columns;
  }
}

// Computes what the rows are off by at the state.
void StripSolver::friction_errors(const StripScene& scene, double* error) const {
  const std::size_t n = laws_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Law& law = laws_[i];
    const double r = law.share * scale_[i], s1 = r * slip_now_[i], s2 = r * slip_now_[n + i];
    if (law.slides) {
      *error++ = s2 * law.along[0] - s1 * law.along[1];
    } else {
      *error++ = s1;
      *error++ = s2;
    }
  }
  for (int k = 0; k < 3; ++k)
    if (scene.force_given[k]) *error++ = load_error_[k];
}

void StripSolver::take(const StripScene& scene, StripState& state, const double* by, double share) const {
  const std::size_t n = laws_.size();
  double *t1 = state.traction.data(), *t2 = t1 + n;
  for (std::size_t i = 0; i < n; ++i) {
    const Law& law = laws_[i];
    if (law.slides) {
      t1[i] += share * *by * law.along[1];
      t2[i] -= share * *by++ * law.along[0];
    } else {
      t1[i] -= share * *by++;
      t2[i] -= share * *by++;
    }
  }
  for (int k = 0; k < 3; ++k)
    if (scene.force_given[k]) state.motion[k] -= share * *by++;
}

// Says whether factors are those of the same nodes sticking and the same loads given.
bool StripSolver::is_kept(const StripScene& scene, const StripFactors& factors) const {
  return factors.force_given == scene.force_given &&
         std::equal(laws_.begin(), laws_.end(), factors.slides.begin(), factors.slides.end(),
                    [](const Law& law, char slides) { return law.slides == (slides != 0); });
}

bool StripSolver::friction_step(const StripScene& scene, StripState& state, bool by_kept) {
  const int loads = scene.force_given[0] + scene.force_given[1] + scene.force_given[2];
  const int size = reduced_size() + loads, most = 2 * state.layout.nodes + 3;
  put_on_bounds(state);
  slip(state);
  if (loads > 0) load_errors(scene, state);
  step_.resize(static_cast<std::size_t>(most));
  friction_errors(scene, step_.data());
  StripFactors& f = factors(state);
  if (!by_kept) {
    f.slides.clear();
    friction_rows(scene, state, false, f.friction.prepare(size, most - size), size);
    if (!f.friction.factor()) return false;
    for (const Law& law : laws_) f.slides.push_back(law.slides ? 1 : 0);
    f.force_given = scene.force_given;
  }
  f.friction.solve(step_.data());
  take(scene, state, step_.data(), 1);
  return true;
}

void StripSolver::slide(const StripScene& scene, StripState& state, StripStart start, StripReport& report) {
  // Without friction nothing is left of a solution nearby.
  const bool warm = start != StripStart::geometry && scene.mu > 0;
  if (!warm) std::fill(state.traction.begin(), state.traction.end(), 0.0);
  if (start == StripStart::shares) {
    const std::size_t n = state.pressure.size();
    for (std::size_t i = 0; i < 2 * n; ++i) state.traction[i] *= state.pressure[i % n];
  }
  for (int k = 0; k < 3; ++k)
    if (!scene.force_given[k] || !warm) state.motion[k] = scene.force_given[k] ? 0 : scene.motion[k];
  prepare(scene, state, false);
  report.status = StripStatus::not_converged;
  const bool loads = scene.force_given[0] || scene.force_given[1] || scene.force_given[2];
  slip(state);
  judge(scene, state);
  const double forces =
      std::hypot(scene.force_given[0] ? scene.motion[0] : 0, scene.force_given[1] ? scene.motion[1] : 0);
  if (loads && !(forces < friction_limit_)) {
    report.status = StripStatus::beyond_friction;
    return;
  }
  // Kept factors serve while each step leaves at most rate_of_kept of the residual.
  StripFactors& f = factors(state);
  if (&f == &large_) f.slides.clear();
  double most_kept = start == StripStart::solution ? first_kept : 0, enough = converged;
  while (report.friction_rounds++ < most_rounds) {
    const double residual = judge(scene, state);
    if (!std::isfinite(residual)) return;
    if (residual < enough) {
      keep_slip(state);
      report.status = StripStatus::solved;
      return;
    }
    // Motions that are not known are found from sticking everywhere, first.
    if (loads && !warm && report.friction_rounds == 1)
      for (Law& law : laws_) law = Law{};
    const bool by_kept = residual < most_kept && is_kept(scene, f);
    if (!friction_step(scene, state, by_kept)) return;
    // Steps with kept factors shrink by a ratio, so that they go on to a hundredth of what ends Newton's.
    enough = by_kept ? converged / 100 : converged;
    most_kept = rate_of_kept * residual;
    slip(state);
  }
}

}  // namespace rollcon::strips
