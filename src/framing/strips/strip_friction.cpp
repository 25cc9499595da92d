#include <algorithm>
#include <cmath>

#include "framing/strips/strip_contact.hpp"

namespace rollcon::strips {
namespace {

constexpr int most_rounds = 60;
constexpr double converged = 1e-11;  // residual of the laws over the largest bound

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
  // Which kind belongs to which field, for slip along x and along y.
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
      const Vec2 slope = slip_[d].slope[i];
      const double spin = state.motion[2];
      l.add_motion(l.slip_place[i], slope[0] + (d == 1 ? spin : 0), slope[1] - (d == 0 ? spin : 0), row);
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

double StripSolver::judge(const StripScene& scene, const StripState& state, const double* scale_of) {
  // The projections' residuals over the largest bound; laws_ are those of the next step.
  const StripLayout& l = state.layout;
  laws_.resize(static_cast<std::size_t>(l.nodes));
  double worst = 0, largest = 0;
  for (int i = 0; i < l.nodes; ++i) {
    const double t1 = state.traction[i], t2 = state.traction[l.nodes + i], r = scale_of[i];
    const double a1 = t1 - r * slip_now_[i], a2 = t2 - r * slip_now_[l.nodes + i], length = std::hypot(a1, a2);
    Law& law = laws_[i];
    law.slides = !(length < bound_[i]);
    law.share = law.slides && length > 0 ? bound_[i] / length : 1;
    law.e = length > 0 ? Vec2{a1 / length, a2 / length} : Vec2{1, 0};
    worst = std::max(worst, std::hypot(t1 - law.share * a1, t2 - law.share * a2));
    largest = std::max(largest, bound_[i]);
  }
  double loads = 0;
  if (scene.force_given[0] || scene.force_given[1] || scene.force_given[2]) {
    const StripTotals t = totals(scene, state);
    const double limit = largest_force(state);
    const double arm = std::sqrt(limit > 0 ? largest_moment_ / limit * largest_moment_ / limit : 0);
    for (int k = 0; k < 3; ++k)
      if (scene.force_given[k])
        loads = std::max(loads, std::abs(t.force[k] - scene.motion[k]) / (limit * (k == 2 ? arm : 1)));
  }
  return std::max(largest > 0 ? worst / largest : 0, loads);
}

}  // namespace rollcon::strips
