/// Finds one prescribed load from the outside: given motions converge where given forces get stuck, and a tangential
/// load falls as its motion grows, the normal one grows with the approach.

#include <algorithm>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int most_evaluations = 120;
constexpr int most_doublings = 40;     // every node slides long before that
constexpr double close_enough = 1e-4;  // fraction of the load's terms, where Newton's step takes over

/// Evaluates a load of the part as a function of its motion m, by solves with that given.
class LoadOfMotion {
 public:
  LoadOfMotion(NewtonIteration& newton, int m, Part part, double tolerance)
      : newton_(newton),
        s_(newton.solve()),
        given_(s_.given),
        m_(m),
        part_(part),
        tolerance_(tolerance),
        target_(s_.given.value[at(m)]) {
    given_.by_force[at(m)] = false;
  }

  Outcome outcome = Outcome::converged;
  int evaluations = 0;

  /// Returns what the load lacks (approach) or exceeds (creepages) at a given motion, which falls as that grows.
  double excess(double motion) {
    Iterate& it = *s_.iterate;
    given_.value[at(m_)] = it.motion[at(m_)] = motion;
    outcome = newton_.run(part_, given_, {.tolerance = std::max(tolerance_, 1e-7), .free_steps = 1, .rehearsal = true});
    ++evaluations;
    if (m_ == approach && outcome == Outcome::no_contact) {
      outcome = Outcome::converged;
      guess_start(*s_.problem, given_, it);
    }
    const double load = load_on_body1(*s_.problem, m_, it.lambda).value;
    return m_ == approach ? target_ - load : load - target_;
  }
  /// Closes in from the excesses at two motions, above 0 at `low` and not at `high`, to where the load is met.
  Outcome close_in(double low, double at_low, double high, double at_high);

 private:
  NewtonIteration& newton_;
  Solve& s_;
  Prescribed given_;
  int m_;
  Part part_;
  double tolerance_, target_;
};

Outcome LoadOfMotion::close_in(double low, double at_low, double high, double at_high) {
  int side = 0;
  while (outcome == Outcome::converged && evaluations < most_evaluations) {
    const double limit = close_enough * load_on_body1(*s_.problem, m_, s_.iterate->lambda).magnitude;
    if (std::min(std::abs(at_low), std::abs(at_high)) <= limit) break;
    // Regula falsi with halved weight of the end that stays (Illinois) closes in, bisection where it stalls.
    double next = (low * at_high - high * at_low) / (at_high - at_low);
    const double least = std::min(low, high), greatest = std::max(low, high);
    if (!(next > least && next < greatest) || evaluations % 4 == 0) next = 0.5 * (low + high);
    if (!(next > least && next < greatest)) break;
    const double value = excess(next);
    if (value > 0) {
      low = next, at_low = value;
      if (side == 1) at_high /= 2;
      side = 1;
    } else {
      high = next, at_high = value;
      if (side == -1) at_low /= 2;
      side = -1;
    }
  }
  if (outcome != Outcome::converged) return outcome;
  return newton_.run(part_, s_.given, {.tolerance = tolerance_, .free_steps = 2});
}

// Brackets motion m of the part, from `from` on in steps of `scale`.
Outcome bracket(NewtonIteration& newton, int m, Part part, double from, double scale, double tolerance) {
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;
  LoadOfMotion load(newton, m, part, tolerance);
  double low = from, high = low, step = scale;
  double at_low = load.excess(low), at_high = at_low;
  while (load.outcome == Outcome::converged && at_low * at_high > 0 && load.evaluations < most_doublings) {
    if (at_low > 0)
      low = high, at_low = at_high, at_high = load.excess(high += step);
    else
      high = low, at_high = at_low, at_low = load.excess(low -= step);
    step *= 2;
  }
  if (load.outcome != Outcome::converged) return load.outcome;
  if (at_low * at_high > 0) return Outcome::not_converged;
  return load.close_in(low, at_low, high, at_high);
}

/// Returns the one tangential load that is prescribed; -1: none, or several, which have no bracket.
int single_load(const Prescribed& given) {
  int m = -1;
  for (const int candidate : {xi1, xi2, spin})
    if (given.by_force[at(candidate)]) {
      if (m >= 0) return -1;
      m = candidate;
    }
  return m;
}

}  // namespace

Outcome bracket_creep(NewtonIteration& newton) {
  Solve& s = newton.solve();
  const int m = single_load(s.given);
  if (m < 0) return Outcome::not_converged;
  newton.return_to_best();
  return bracket(newton, m, s.goal, s.iterate->motion[at(m)], creep_scale(*s.problem, s.given, *s.iterate, m),
                 s.tolerance);
}

// Goes from stick outwards in steps that double: the first motion whose load is enough ends a bracket. Where none is,
// the greatest load is sought between the neighbours of the best one.
Outcome bracket_before_fall(NewtonIteration& newton) {
  constexpr int steps = 26;
  constexpr double first = 1.0 / 64;  // fraction of the creepage at which friction saturates
  constexpr int searches = 14;        // golden section
  constexpr double certainly = 1e-3;  // fraction of the load by which the greatest falls short
  Solve& s = newton.solve();
  const int m = single_load(s.given);
  if (m < 0) return Outcome::not_converged;
  newton.return_to_best();
  Iterate& it = *s.iterate;
  const double scale = creep_scale(*s.problem, s.given, it, m);
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;
  for (int c = 0; c < 2; ++c) std::fill(it.lambda[c].begin(), it.lambda[c].end(), 0.0);
  it.invalidate();
  LoadOfMotion load(newton, m, s.goal, s.tolerance);
  double motion[steps + 1] = {}, excess[steps + 1] = {};
  int best = 0;
  // The sign is that of the excess at no motion; excess times sign falls where the load grows.
  double sign = 0;
  const auto enough = [&](double e) { return e * sign <= 0; };
  for (int i = 0; i <= steps; ++i) {
    if (i > 0) motion[i] = sign * scale * first * std::pow(2, i - 1);
    excess[i] = load.excess(motion[i]);
    if (load.outcome != Outcome::converged) return load.outcome;
    if (i == 0) sign = excess[0] > 0 ? 1 : -1;
    if (enough(excess[i]))
      return sign > 0 ? load.close_in(motion[std::max(0, i - 1)], excess[std::max(0, i - 1)], motion[i], excess[i])
                      : load.close_in(motion[i], excess[i], motion[std::max(0, i - 1)], excess[std::max(0, i - 1)]);
    if (sign * excess[i] < sign * excess[best]) best = i;
  }
  if (best == steps) return Outcome::not_converged;  // the load grows on and on
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double a = motion[std::max(0, best - 1)], b = motion[std::min(steps, best + 1)], least = sign * excess[best];
  double c = b - golden * (b - a), d = a + golden * (b - a), at_c = 0, at_d = 0;
  bool know_c = false, know_d = false;
  for (int k = 0; k < searches; ++k) {
    for (const bool left : {true, false}) {
      if (left ? know_c : know_d) continue;
      const double x = left ? c : d, e = load.excess(x);
      if (load.outcome != Outcome::converged) return load.outcome;
      if (enough(e)) {
        const double from = motion[std::max(0, best - 1)], at_from = load.excess(from);
        if (load.outcome != Outcome::converged) return load.outcome;
        return sign > 0 ? load.close_in(from, at_from, x, e) : load.close_in(x, e, from, at_from);
      }
      (left ? at_c : at_d) = sign * e;
      (left ? know_c : know_d) = true;
      least = std::min(least, sign * e);
    }
    if (at_c < at_d)
      b = d, d = c, at_d = at_c, c = b - golden * (b - a), know_c = false;
    else
      a = c, c = d, at_c = at_d, d = a + golden * (b - a), know_d = false;
  }
  const double asked = -sign * s.given.value[at(m)], greatest = asked - least;
  if (!(asked > 0 && greatest > 0 && asked > (1 + certainly) * greatest)) return Outcome::not_converged;
  FrictionShare& share = s.report.share;
  share = {};
  share.by_force = m != spin;
  share.by_moment = m == spin;
  share.before_fall = true;
  share.sliding = share.together = asked / greatest;
  return Outcome::no_solution;
}

Outcome bracket_approach(NewtonIteration& newton, double tolerance) {
  Solve& s = newton.solve();
  if (!s.given.by_force[approach]) return Outcome::not_converged;
  start_cold(*s.problem, s.given, *s.iterate);
  const GuessedContact guess = guess_contact(*s.problem, s.given, s.iterate->motion);
  if (!(guess.low < INFINITY)) return Outcome::not_converged;
  return bracket(newton, approach, Part::normal, guess.low, guess.half, tolerance);
}

}  // namespace rollcon
