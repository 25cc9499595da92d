/// Computes what somebody asks of a solution: deformed gap, slip velocity, status per node, and the residuals of the
/// laws.

#include "contact/derived.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/index.hpp"

namespace rollcon {
namespace {

// Returns the displacement differences u1 - u2 at points, straight from the integrals.
std::vector<double> displacements(const Solution& s, Derived& d, const std::vector<double>& x,
                                  const std::vector<double>& y) {
  const std::size_t n = at(s.prepared->problem.nodes);
  std::vector<double> t(3 * n), u(3 * x.size());
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t c = 0; c < 3; ++c) t[3 * k + c] = s.iterate.lambda[c][k];
  ++d.computed.applications;
  s.prepared->compliance->apply({x, y}, t.data(), u.data());
  return u;
}

// Computes D (A lambda)_t per unit speed at every node, from displacements.
void convect(const Solution& s, Derived& d, const std::vector<double>& u, std::vector<double> (&image)[2]) {
  const Convection& convection = s.prepared->problem.convection;
  std::vector<double> ahead;
  if (!convection.ahead.empty()) {
    std::vector<double> x = s.prepared->frame.x;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += convection.ahead[k];
    ahead = displacements(s, d, x, s.prepared->frame.y);
  }
  convect(convection, u.data(), ahead.data(), image);
}

// Computes normal displacement and slip per unit speed at every node, not by the rows that the solver used; on large
// lattices by its convolutions, applied afresh, as integrals take a time of n^2 there.
void recompute(const Solution& s, Derived& d, std::vector<double>& normal, std::vector<double> (&slip)[2]) {
  constexpr std::size_t large = 4096;
  const std::size_t n = at(s.prepared->problem.nodes);
  normal.resize(n);
  const Operators& op = *s.prepared->problem.op;
  if (op.all_at_once() && n > large) {
    std::vector<double> image[3];
    for (auto& v : image) v.resize(n);
    op.images({}, {}, {}, s.iterate.lambda, image);
    slip[0] = std::move(image[0]), slip[1] = std::move(image[1]), normal = std::move(image[2]);
    return;
  }
  const std::vector<double> u = displacements(s, d, s.prepared->frame.x, s.prepared->frame.y);
  convect(s, d, u, slip);
  for (std::size_t k = 0; k < n; ++k) normal[k] = u[3 * k + 2];
}

}  // namespace

void Derived::forget() {
  Derived empty;
  empty.slip[0].swap(slip[0]);
  empty.slip[1].swap(slip[1]);
  empty.gap.swap(gap);
  empty.status.swap(status);
  empty.computed = computed;
  *this = std::move(empty);
}

void derive_gap(const Solution& s, double* gap) {
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    it.update_gap(p, static_cast<std::int64_t>(k));
    gap[k] = p.rigid_gap(k, it.motion) - it.image[2][k];
  }
}

void derive_fields(const Solution& s, Derived& d) {
  if (d.fields) return;
  ++d.computed.fields;
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  const std::size_t n = at(p.nodes);
  d.gap.resize(n);
  derive_gap(s, d.gap.data());
  d.status.assign(n, static_cast<std::int32_t>(NodeStatus::open));
  std::vector<double> image[2];
  const bool known = p.op->tangential || p.op->all_at_once() || s.images_known;
  if (!known) convect(s, d, displacements(s, d, s.prepared->frame.x, s.prepared->frame.y), image);
  for (auto& v : d.slip) v.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<std::int64_t>(k);
    if (!p.used[k]) {
      d.status[k] = static_cast<std::int32_t>(NodeStatus::excluded);
      continue;
    }
    if (known) it.update_slip(p, i);
    const double w1 = known ? it.image[0][k] : image[0][k];
    const double w2 = known ? it.image[1][k] : image[1][k];
    const double s1 = p.rigid_slip1(i, it.motion) + w1, s2 = p.rigid_slip2(i, it.motion) + w2;
    d.slip[0][k] = s.prepared->speed * s1;
    d.slip[1][k] = s.prepared->speed * s2;
    if (!(it.lambda[2][k] < 0)) continue;
    FrictionPoint point{s.given.coefficient(p.mu, k),
                        -(it.lambda[2][k] + p.rn[k] * d.gap[k]),
                        it.lambda[0][k],
                        it.lambda[1][k],
                        s1,
                        s2,
                        p.rt[k]};
    p.count_from_touch(k, point);
    d.slip[0][k] = s.prepared->speed * point.s1;
    d.slip[1][k] = s.prepared->speed * point.s2;
    const bool sliding = s.frictionless || p.law->traction(point).sliding;
    d.status[k] = static_cast<std::int32_t>(sliding ? NodeStatus::slip : NodeStatus::stick);
  }
  d.fields = true;
}

void check_laws(const Solution& s, Derived& d) {
  if (d.laws_checked) return;
  ++d.computed.laws;
  derive_fields(s, d);
  const Problem& p = s.prepared->problem;
  const Iterate& it = s.iterate;
  const std::size_t n = at(p.nodes);
  std::vector<double> un, w[2];
  recompute(s, d, un, w);

  double pressure = 0, depth = 0, bound_max = 0, speed_max = 0;
  for (std::size_t k = 0; k < n; ++k) {
    pressure = std::max(pressure, std::abs(it.lambda[2][k]));
    depth = std::max(depth, std::abs(un[k]));
    bound_max = std::max(bound_max, s.given.coefficient(p.mu, k) * std::abs(it.lambda[2][k]));
  }
  std::vector<double> s1(n), s2(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!s.prepared->frame.used[k]) continue;
    const auto i = static_cast<std::int64_t>(k);
    const double c1 = p.rigid_slip1(i, it.motion), c2 = p.rigid_slip2(i, it.motion);
    s1[k] = c1 + w[0][k];
    s2[k] = c2 + w[1][k];
    if (it.lambda[2][k] < 0) speed_max = std::max({speed_max, std::hypot(c1, c2), std::hypot(w[0][k], w[1][k])});
  }
  // Slip is small when it is small against the slip velocities that occur, or when it would change the traction by
  // little of the friction bound (zero creepage has no velocity to compare with).
  const auto relative = [&](double speed, std::size_t k) {
    return std::min(speed / speed_max, p.rt[k] * speed / bound_max);
  };
  double normal = 0, friction = 0, slip = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!s.prepared->frame.used[k]) continue;
    const double ln = it.lambda[2][k];
    const double kn = p.rigid_gap(k, it.motion) - un[k];
    if (pressure > 0) normal = std::max(normal, ln / pressure);
    if (depth > 0) normal = std::max(normal, ln < 0 ? std::abs(kn) / depth : -kn / depth);
    FrictionPoint point{
        s.given.coefficient(p.mu, k), std::max(-ln, 0.0), it.lambda[0][k], it.lambda[1][k], s1[k], s2[k]};
    p.count_from_touch(k, point);
    const FrictionTraction t = p.law->traction(point);
    const double tangential = t.length, bound = t.bound;
    const bool sliding = d.status[k] == static_cast<std::int32_t>(NodeStatus::slip);
    if (bound_max > 0) {
      // A sliding node is at the bound; no other one is beyond it.
      const double excess = tangential - bound;
      friction = std::max(friction, (sliding ? std::abs(excess) : excess) / bound_max);
    }
    if (s.frictionless || !(ln < 0) || !(speed_max > 0) || !(bound > 0)) continue;
    const double speed = std::hypot(point.s1, point.s2);
    if (!sliding) {
      slip = std::max(slip, relative(speed, k));
    } else if (tangential > 0) {  // slip component across and along the traction
      const auto [e1, e2] = p.law->against(point);
      slip = std::max(slip, relative(std::abs(point.s1 * e2 - point.s2 * e1), k));
      slip = std::max(slip, relative(point.s1 * e1 + point.s2 * e2, k));
    }
  }
  const double equilibrium = load_error(p, s.given, Part::full, it.lambda);
  d.laws = {normal, friction, slip, equilibrium};
  d.laws_checked = true;
}

}  // namespace rollcon
