#include "procedures/condensed.hpp"

#include <algorithm>
#include <cmath>

#include "support/clock.hpp"
#include "support/index.hpp"

namespace rollcon {

void blend(Point& z, const Point& next, double alpha) {
  const auto mix = [alpha](std::vector<double>& from, const std::vector<double>& to) {
    for (std::size_t k = 0; k < from.size(); ++k)
      from[k] = alpha == 1 ? to[k] : from[k] + alpha * (to[k] - from[k]);
  };
  for (int c = 0; c < 3; ++c) mix(z.lambda[c], next.lambda[c]);
  for (int c = 0; c < 2; ++c) mix(z.slip[c], next.slip[c]), mix(z.shift[c], next.shift[c]);
  mix(z.depth, next.depth);
  mix(z.inner, next.inner);
  for (std::size_t m = 0; m < 4; ++m)
    z.motion[m] =
        alpha == 1 ? next.motion[m] : z.motion[m] + alpha * (next.motion[m] - z.motion[m]);
}

CondensedSystem::CondensedSystem(const Problem& problem, const Frame& frame,
                                 const Compliance& compliance, LinearSolver& linear)
    : problem_(problem), linear_(linear), estimated_(problem, frame, compliance) {}

void CondensedSystem::take_active(const Step& step) {
  active_.clear();
  for (std::size_t k = 0; k < step.state.size(); ++k)
    if (step.state[k] == PairState::stick || step.state[k] == PairState::slip)
      active_.push_back(static_cast<std::int32_t>(k));
}

bool CondensedSystem::solve(const Step& step, const Point& z, double eta, Point& next) {
  take_active(step);
  next = z;
  for (auto& component : next.lambda) std::fill(component.begin(), component.end(), 0.0);
  const bool solved =
      step.estimated ? solve_estimated(step, z, eta, next) : solve_slip(step, z, eta, next);
  if (solved) update(next);
  return solved;
}

bool CondensedSystem::solve_slip(const Step& step, const Point& z, double eta, Point& next) {
  const Problem& p = problem_;
  const Part part = step.tangential ? Part::full : Part::normal;
  system_.gather(p, p, part, active_, z.lambda, !gathered_);
  gathered_ = true;
  std::array<double, 4> known = z.motion;
  for (std::size_t m = 0; m < 4; ++m) known[m] = p.by_force[m] ? 0 : p.value[m];
  const std::size_t na = active_.size();
  for (auto& v : known_) v.assign(na, 0.0);
  for (std::size_t a = 0; a < na; ++a) {
    const std::int64_t i = active_[a];
    known_[2][a] = p.rigid_gap(at(i), known[approach]);
    if (!step.tangential) continue;
    system_.law(static_cast<std::int64_t>(a)) = step.law[at(i)];
    known_[0][a] = p.rigid_slip1(i, known);
    known_[1][a] = p.rigid_slip2(i, known);
  }
  system_.right_side(known_[2], known_[0], known_[1], b_);
  const auto n = at(system_.size());
  unknowns_ = system_.size();
  jx_.resize(n);
  system_.start(z.lambda, z.motion, x_);
  system_.apply(x_.data(), jx_.data());
  for (std::size_t i = 0; i < n; ++i) b_[i] -= jx_[i];
  if (!linear_.solve(system_, p.nodes, b_, eta, correction_)) return false;
  for (std::size_t i = 0; i < n; ++i) x_[i] += correction_[i];
  for (int r = 0; r < system_.components(); ++r)
    for (std::size_t a = 0; a < na; ++a)
      next.lambda[system_.component(r)][at(active_[a])] = x_[static_cast<std::size_t>(r) * na + a];
  for (int m = 0; m < 4; ++m)
    if (p.by_force[at(m)] && (step.tangential || m == approach))
      next.motion[at(m)] = system_.motion(p, m, x_.data());
  return true;
}

bool CondensedSystem::solve_estimated(const Step& step, const Point& z, double eta, Point& next) {
  const Stopwatch watch(seconds_);
  estimated_.gather(step, active_);
  unknowns_ = estimated_.size();
  const auto n = at(unknowns_);
  estimated_.right_side(step, z, b_);
  estimated_.start(z, x_);
  jx_.resize(n);
  estimated_.apply(x_.data(), jx_.data());
  for (std::size_t i = 0; i < n; ++i) b_[i] -= jx_[i];
  if (!estimated_.solve(b_, eta, linear_, correction_)) return false;
  for (std::size_t i = 0; i < n; ++i) x_[i] += correction_[i];
  estimated_.scatter(step, x_, next);
  return true;
}

void CondensedSystem::update(Point& z) {
  const Problem& p = problem_;
  const auto product = [&](int r, std::vector<double>& to) {
    to.assign(at(p.nodes), 0.0);
    for (int c = 0; c < 3; ++c)
      if (!p.op.block[r][c].empty())
        multiply(p.op.block[r][c].data(), p.nodes, p.nodes, z.lambda[c].data(), 1, to.data());
  };
  product(2, z.depth);
  if (p.op.tangential)
    for (int r = 0; r < 2; ++r) product(r, z.slip[r]);
  if (!z.shift[0].empty()) estimated_.shift(z);
}

StepCounters CondensedSystem::counters() const {
  StepCounters c;
  c.unknowns = unknowns_;
  c.nonzeros = unknowns_ * unknowns_;
  c.factorizations = linear_.factorizations + estimated_.factorizations;
  c.iterations = linear_.iterations + estimated_.iterations;
  c.seconds = linear_.seconds + seconds_;
  c.bytes = system_.bytes() + estimated_.bytes();
  return c;
}

}  // namespace rollcon
