/// Loads that friction cannot carry: refused as soon as pressures tell, and where friction changes
/// the pressures, by those of the same contact with every node sliding against the loads.

#include <algorithm>
#include <cmath>

#include "contact/newton/newton.hpp"
#include "contact/newton/start.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double at_limit = 1 - 1e-12;
// A search over directions, of loads with a spin moment, is for iterations that lead nowhere: those
// that solve a load have fewer steps before them.
constexpr std::int64_t before_search = 4;
constexpr double suspicious = 0.9;  // share under pressures that are not those of the solution
constexpr double enough = 1e-6;     // of pressures under sliding
constexpr std::int64_t iterations = 60;
constexpr int most_turns = 3;       // of the direction of sliding
constexpr double same_turn = 1e-3;  // of that direction
constexpr double far = 1e6;         // slip, in units of the elastic and the given one

}  // namespace

// By what is certain: pressures that were found before friction, or of those that friction changes
// the sum.
bool Newton::beyond_friction(Part part, std::int64_t iteration, double residual_normal) {
  const Problem& p = *problem_;
  if (part == Part::normal || !(p.by_force[xi1] || p.by_force[xi2] || p.by_force[spin]))
    return false;
  const auto& lambda = iterate_->lambda;
  if (part == Part::tangential && !p.op.coupled) {
    if (p.by_force[spin] ? iteration != before_search : iteration != 0) return false;
    if (!p.by_force[spin] && share_of_forces(p, lambda) < at_limit) return false;
    report_.share = share_of_friction(p, lambda);
    return report_.share.together >= at_limit;
  }
  if (!friction_sum_known(p, lambda[2]) || !pressures_settled(p, lambda, residual_normal))
    return false;
  if (share_of_forces(p, lambda) < at_limit) return false;
  report_.share = share_of_friction(p, lambda);
  return true;
}

// After iterations that led nowhere: whether the loads reach those of sliding against them by so
// much more. Ends at the best iterate.
bool Newton::beyond_sliding(double by) {
  const Problem& p = *problem_;
  if (!(p.by_force[xi1] || p.by_force[xi2] || p.by_force[spin]) || goal_ == Part::normal)
    return false;
  // Where a frame is curved, pressures carry a part of the force across the rolling direction.
  if (!p.turn.empty() && p.by_force[xi2]) return false;
  if (goal_ == Part::tangential) {
    // Clear cases were seen before.
    if (by > 0 || !pressures_found_) return false;
    report_.share = share_of_friction(p, iterate_->lambda);
    return report_.share.sliding >= 1 + by;
  }
  const auto& known = std::isfinite(best_.worst) ? best_.lambda : iterate_->lambda;
  if (by > 0 && !(share_of_friction(p, known).together >= suspicious)) return false;
  if (!compared_) {
    compared_ = true;
    slides_ = slide_against_loads();
    return_to_best();
  }
  report_.share = slides_;
  return slides_.sliding >= 1 + by - 10 * enough;
}

// The share of the loads in friction when every node slides in the direction in which that falls
// short of them most, under the pressures of that sliding. 0: not found.
FrictionShare Newton::slide_against_loads() {
  Problem& p = *problem_;
  Iterate& it = *iterate_;
  const std::array<bool, 4> by_force = p.by_force;
  const std::array<double, 4> value = p.value;
  const NewtonReport report = report_;
  const std::int64_t left = iterations_left_;
  iterations_left_ = (most_turns + 1) * iterations;
  continuing_ = true;
  for (const int m : {xi1, xi2, spin}) p.by_force[at(m)] = false;
  start_cold(p, it);
  guess_start(p, it);
  bool known =
      run(Part::normal, enough, iterations, report_.normal_iterations) == Outcome::converged;
  std::array<double, 4> given = value;
  for (const int m : {xi1, xi2, spin})
    if (by_force[at(m)]) given[at(m)] = 0;
  double slip = 0;
  for (std::size_t k = 0; known && k < p.rt.size(); ++k) {
    if (!(it.lambda[2][k] < 0 && p.rt[k] > 0)) continue;
    const auto i = static_cast<std::int64_t>(k);
    slip = std::max({slip, (1 + p.mu[k]) * -it.lambda[2][k] / p.rt[k],
                     std::hypot(p.rigid_slip1(i, given), p.rigid_slip2(i, given))});
  }
  known = known && slip > 0 && std::isfinite(slip);
  FrictionShare share;
  std::array<double, 3> direction{};
  for (int turn = 0; known && turn <= most_turns; ++turn) {
    p.by_force = by_force;
    p.value = value;
    share = share_of_friction(p, it.lambda);
    const double size = std::hypot(share.direction[0], share.direction[1], share.direction[2]);
    known = size > 0 && std::isfinite(size);
    if (!known) break;
    double turned = 0, asked = 0, carried = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      constexpr int motion[] = {xi1, xi2, spin};
      const std::size_t m = at(motion[i]);
      const double a = share.direction[i] / size, unit = motion[i] == spin ? 1 / p.length : 1;
      turned = std::max(turned, std::abs(a - direction[i]));
      direction[i] = a;
      if (!by_force[m]) continue;
      asked += a * unit * value[m];
      carried += a * unit * load_on_body1(p, motion[i], it.lambda).value;
      p.by_force[m] = false;
      p.value[m] = it.motion[m] = -far * slip * a * unit;
    }
    if (turn > 0) share.sliding = carried > 0 ? asked / carried : INFINITY;
    if (turn > 0 && (turned < same_turn || turn == most_turns)) break;
    known = run(goal_, enough, iterations, iterations_of(goal_)) == Outcome::converged;
  }
  continuing_ = false;
  p.by_force = by_force;
  p.value = value;
  report_ = report;
  iterations_left_ = left;
  return known ? share : FrictionShare{};
}

}  // namespace rollcon
