#include <algorithm>
#include <cmath>
#include <limits>

#include "framing/strips/strip_contact.hpp"
#include "framing/strips/strip_results.hpp"
#include "linalg/dense.hpp"

namespace rollcon::strips {
namespace {

constexpr int most_rounds = 25;
constexpr double longest_step = 0.3, last_step = 3e-7;
constexpr double solved = 1e-9, rounded = 1e-7;  // residuals, over the largest bound

}  // namespace

void StripSolver::total_slopes(const StripState& state, int which, double* slope, double* u, double* v) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  for (int i = 0; i < l.nodes; ++i) {
    const int row = i / l.nodes_each, half = l.half_of(row), width = l.width_of(l.part_of(row));
    const double w = l.unit_weight[i] * g[half] * g[width], x = l.x(l.centroid[i], g), y = l.y(l.centroid[i], g);
    const double p = state.pressure[i], t1 = state.traction[i], t2 = state.traction[l.nodes + i];
    // These are the integrand, its slopes by place, and its slopes by p, t1 and t2.
    double f = 0, fx = 0, fy = 0, fp = 0, f1 = 0, f2 = 0;
    switch (which) {
      case 0:
        f = t1, f1 = 1;
        break;
      case 1:
        f = t2, f2 = 1;
        break;
      case 2:
        f = x * t2 - y * t1, fx = t2, fy = -t1, f1 = -y, f2 = x;
        break;
      case 3:
        f = p, fp = 1;
        break;
      case 4:
        f = x * p, fx = p, fp = x;
        break;
      default:
        f = y * p, fy = p, fp = y;
    }
    slope[i] += w * fp;
    u[i] = w * f1;
    v[i] = w * f2;
    slope[l.nodes + half] += w * f / g[half];
    slope[l.nodes + width] += w * f / g[width];
    l.add_motion(l.centroid[i], w * fx, w * fy, slope + l.nodes);
  }
}

// Linearises all equations at the state: normal rows, then friction's; columns are in the order of friction_rows.
void StripSolver::linearise(const StripScene& scene, const StripState& state) {
  const StripLayout& l = state.layout;
  const int loads = scene.force_given[0] + scene.force_given[1] + scene.force_given[2];
  normal_size_ = l.nodes + l.geometry + 1;
  friction_size_ = reduced_size() + loads;
  const int size = normal_size_ + friction_size_;
  // Room for any states of the nodes.
  const auto most = static_cast<std::size_t>(normal_size_ + 2 * l.nodes + 3);
  matrix_.resize(most * most);
  all_right_.resize(most);
  normal_rows(scene, state, Rows::all, matrix_.data(), normal_size_, size, all_right_.data());
  load_errors(scene, state);
  friction_rows(scene, state, true, matrix_.data() + static_cast<std::ptrdiff_t>(normal_size_) * size, size);
  friction_errors(scene, all_right_.data() + normal_size_);
}

bool StripSolver::factor_all() {
  const int n = normal_size_, m = friction_size_, size = n + m;
  const auto block = [&](Lu<double>& lu, int from, int count) {
    double* to = lu.prepare(count, static_cast<int>(all_right_.size()) - size);
    for (int i = 0; i < count; ++i)
      std::copy_n(matrix_.data() + static_cast<std::ptrdiff_t>(from + i) * size + from, count,
                  to + static_cast<std::ptrdiff_t>(i) * count);
    return lu.factor();
  };
  // Pressures that do not depend on friction are solved for alone.
  if (integrals_.coupled()) return block(lu_, 0, size);
  return block(lu_, 0, n) && block(lu_friction_, n, m);
}

void StripSolver::solve_all(double* right) const {
  const int n = normal_size_, size = n + friction_size_;
  lu_.solve(right);
  if (integrals_.coupled()) return;
  for (int i = n; i < size; ++i) right[i] -= dot(matrix_.data() + static_cast<std::ptrdiff_t>(i) * size, right, n);
  lu_friction_.solve(right + n);
}

void StripSolver::prepare(const StripScene& scene, const StripState& state, bool rates) {
  const StripLayout& l = state.layout;
  integrals_.lay(l, scene.bodies, state.geometry.data());
  set_fields(state);
  slip_rows(scene, state, rates);
  bounds(scene, state);
  slip(state);
}

// Finds pressures and tractions of unlike bodies by Newton's steps for all unknowns at once.
StripReport StripSolver::couple(const StripScene& scene, StripState& state, StripReport report) {
  double change = 1, before = std::numeric_limits<double>::infinity();
  report.status = StripStatus::not_converged;
  for (int k = 0; k < 3; ++k)
    if (!scene.force_given[k]) state.motion[k] = scene.motion[k];
  for (int round = 0; round < most_rounds; ++round) {
    prepare(scene, state, true);
    const double residual = judge(scene, state);
    if (!std::isfinite(residual)) return report;
    // Rounding alone is left of residuals that a small step no longer shortens.
    if (change < last_step && (residual < solved || (residual < rounded && residual > 0.1 * before))) {
      keep_slip(state);
      report.status = StripStatus::solved;
      return report;
    }
    before = residual;
    put_on_bounds(state);
    set_fields(state);
    slip(state);
    linearise(scene, state);
    if (!factor_all()) return report;
    solve_all(all_right_.data());
    const double longest = normal_size(state, all_right_.data());
    const double share = longest > longest_step ? longest_step / longest : 1;
    change = std::max(longest, normal_step(scene, state, all_right_.data(), share));
    take(scene, state, all_right_.data() + normal_size_, share);
    ++report.normal_rounds;
    ++report.friction_rounds;
  }
  return report;
}

StripReport StripSolver::solve(const StripScene& scene, StripState& state, StripStart start) {
  StripReport report;
  // Without friction pressures displace the bodies along the surface to no effect.
  const bool coupled = scene.bodies.ck != 0 && scene.mu > 0;
  if (!(scene.mu > 0)) std::fill(state.traction.begin(), state.traction.end(), 0.0);
  if (start != StripStart::solution || !coupled) {
    // Tractions over pressures are no tractions yet.
    if (start == StripStart::shares) {
      shares_ = state.traction;
      std::fill(state.traction.begin(), state.traction.end(), 0.0);
    }
    report = press(scene, state, start);
    if (start == StripStart::shares) state.traction = shares_;
    if (report.status == StripStatus::solved) slide(scene, state, start, report);
    if (report.status != StripStatus::solved) return report;
  }
  return coupled ? couple(scene, state, report) : report;
}

// Computes rates of all residuals by a parameter, with the unknowns held: bound_rates_ has rates of the friction
// bounds, and traction_rates_ the tractions that nodes on their bounds follow them with.
void StripSolver::explicit_rates(const StripScene& scene, const StripState& state, const StripParameter& p,
                                 double* right) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  const int n = l.nodes, edges = n + l.geometry;
  sample(p.gap, l.observers, l, g, gap_);
  std::copy_n(gap_.value.data(), edges, right);
  right[edges] = scene.by_load ? -scene.bodies.cn * p.value / g[l.width_of(0)] : -p.value;
  sample(p.friction, l.node, l, g, creep_rates_[0]);
  double *t1 = traction_rates_.data(), *t2 = t1 + n;
  for (int i = 0; i < n; ++i) {
    bound_rates_[i] =
        state.pressure[i] * (p.mu * (scene.friction ? friction_.value[i] : 1) + scene.mu * creep_rates_[0].value[i]);
    t1[i] = laws_[i].slides ? bound_rates_[i] * laws_[i].along[0] : 0;
    t2[i] = laws_[i].slides ? bound_rates_[i] * laws_[i].along[1] : 0;
  }
  if (integrals_.coupled() && (p.mu != 0 || p.friction)) {
    integrals_.set_field(1, t1);
    integrals_.set_field(2, t2);
    for (int i = 0; i < edges; ++i) {
      const Observation o = integrals_.observe(Displacement::normal, false, l.observers[i], 0);
      right[i] += integrals_.displacement(o, 1, 1) + integrals_.displacement(o, 2, 2);
    }
  }
  for (int d = 0; d < 2; ++d) sample(p.slip[d], l.slip_place, l, g, creep_rates_[d]);
  std::array<double, 3> motion{};
  for (int k = 0; k < 3; ++k) motion[k] = scene.force_given[k] ? 0 : p.motion[k];
  double* to = right + normal_size_;
  for (int i = 0; i < n; ++i) {
    const Law& law = laws_[i];
    const Vec2 place = slip_[0].point[i];
    const auto row = static_cast<std::ptrdiff_t>(i) * n;
    const double *a = compliance_[0].data() + row, *b = compliance_[1].data() + row, *c = compliance_[2].data() + row;
    const double s1 = creep_rates_[0].value[i] + motion[0] - motion[2] * place[1] + dot(a, t1, n) + dot(b, t2, n),
                 s2 = creep_rates_[1].value[i] + motion[1] + motion[2] * place[0] + dot(b, t1, n) + dot(c, t2, n);
    if (law.slides) {
      *to++ = law.share * scale_[i] * (s2 * law.along[0] - s1 * law.along[1]);
    } else {
      *to++ = scale_[i] * s1;
      *to++ = scale_[i] * s2;
    }
  }
  for (int k = 0; k < 3; ++k)
    if (scene.force_given[k]) {
      const double* slope = all_slopes_.data() + static_cast<std::ptrdiff_t>(k) * (edges + 2 * n) + edges;
      *to++ = dot(slope, t1, n) + dot(slope + n, t2, n) - p.motion[k];
    }
}

// Computes rates of the totals from those of the unknowns.
StripTotals StripSolver::total_rates(const StripScene& scene, const StripState& state, const StripParameter& p,
                                     double* dz) {
  const StripLayout& l = state.layout;
  const int n = l.nodes, edges = n + l.geometry;
  double *t1 = traction_rates_.data(), *t2 = t1 + n;
  for (int i = 0; i < n; ++i) dz[i] /= scene.bodies.cn;
  const double *reduced = dz + normal_size_, *dg = dz + n;
  for (int i = 0; i < n; ++i) {
    const Law& law = laws_[i];
    if (!law.slides) {
      t1[i] = *reduced++;
      t2[i] = *reduced++;
      continue;
    }
    double bound = bound_rates_[i] + scene.mu * (scene.friction ? friction_.value[i] : 1) * dz[i];
    if (scene.friction)
      bound += scene.mu * state.pressure[i] *
               (friction_.slope[i][0] * l.x(l.node[i], dg) + friction_.slope[i][1] * l.y(l.node[i], dg));
    t1[i] = bound * law.along[0] - *reduced * law.along[1];
    t2[i] = bound * law.along[1] + *reduced++ * law.along[0];
  }
  double total[6];
  for (int k = 0; k < 6; ++k) {
    const double* slope = all_slopes_.data() + static_cast<std::ptrdiff_t>(k) * (edges + 2 * n);
    total[k] = dot(slope, dz, edges) + dot(slope + edges, t1, n) + dot(slope + edges + n, t2, n);
  }
  StripTotals rate{total[3], dz[edges], {total[0], total[1], total[2]}, {}, {total[4], total[5]}};
  for (int k = 0; k < 3; ++k) rate.motion[k] = scene.force_given[k] ? *reduced++ : p.motion[k];
  return rate;
}

bool StripSolver::rates(const StripScene& scene, const StripState& state, std::span<const StripParameter> parameter,
                        std::span<StripTotals> rate, std::span<double> share_rate) {
  const StripLayout& l = state.layout;
  const int n = l.nodes, edges = n + l.geometry;
  prepare(scene, state, true);
  judge(scene, state);
  linearise(scene, state);
  if (!factor_all()) return false;
  bound_rates_.resize(static_cast<std::size_t>(n));
  traction_rates_.resize(2 * static_cast<std::size_t>(n));
  all_slopes_.assign(6 * static_cast<std::size_t>(edges + 2 * n), 0);
  for (int k = 0; k < 6; ++k) {
    double* slope = all_slopes_.data() + static_cast<std::ptrdiff_t>(k) * (edges + 2 * n);
    total_slopes(state, k, slope, slope + edges, slope + edges + n);
  }
  for (std::size_t i = 0; i < parameter.size(); ++i) {
    explicit_rates(scene, state, parameter[i], all_right_.data());
    solve_all(all_right_.data());
    for (double& d : all_right_) d = -d;
    rate[i] = total_rates(scene, state, parameter[i], all_right_.data());
    if (share_rate.empty()) continue;
    // Takes differences along the change of pressures and geometry.
    double size = 0, value[2];
    for (int k = 0; k < l.geometry; ++k) size = std::max(size, std::abs(all_right_[n + k]));
    const double step = size > 0 ? 1e-5 * state.geometry[l.width_of(0)] / size : 0;
    for (const int side : {0, 1}) {
      beside_ = state;
      const double by = side == 0 ? -step : step;
      for (int k = 0; k < n; ++k) beside_.pressure[k] += by * all_right_[k];
      for (int k = 0; k < l.geometry; ++k) beside_.geometry[k] += by * all_right_[n + k];
      value[side] = trust(beside_).share();
    }
    share_rate[i] = step > 0 ? (value[1] - value[0]) / (2 * step) : 0;
  }
  return true;
}

}  // namespace rollcon::strips
