/// Guards every success: what was found keeps every law and carries every prescribed load, whichever part was solved
/// last and whatever fallbacks did on the way.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/newton/newton.hpp"

namespace rollcon {
namespace {

constexpr double slack = 10;  // images made anew have another rounding

}  // namespace

// Checks the whole. The tangential problem of equal bodies stands on pressures that were found before it: they are to
// be those still, or are judged again. The part solved last was judged when it ended, by what was prescribed then;
// after fallbacks, which prescribe other things for a while, all is judged by what is asked.
bool Newton::holds() {
  Solve& s = solve_;
  const Iterate& it = *s.iterate;
  for (std::size_t m = 0; m < motion_count; ++m)
    if (!s.given.by_force[m] && it.motion[m] != s.given.value[m]) return false;
  const std::vector<double>& pressures = it.lambda[2];
  bool as_judged = s.report.fallbacks == 0;
  for (const std::size_t m : {approach, tilt1, tilt2}) as_judged = as_judged && it.motion[m] == judged_motion_[m];
  as_judged = as_judged && judged_.size() == pressures.size() &&
              std::memcmp(judged_.data(), pressures.data(), pressures.size() * sizeof(double)) == 0;
  if (s.goal == Part::tangential && !as_judged) {
    const LawResidual normal = iteration_.judge(Part::normal, s.given);
    s.report.residual_normal = normal.normal;
    s.report.residual_load = std::max(s.report.residual_load, normal.load);
    if (!std::isfinite(normal.merit) || !normal.within(Part::normal, slack * s.tolerance)) return false;
  }
  if (s.report.fallbacks == 0) return true;
  const LawResidual last = iteration_.evaluate(s.goal, s.given);
  if (s.goal != Part::tangential) s.report.residual_normal = last.normal;
  if (s.goal != Part::normal) s.report.residual_tangential = last.tangential;
  s.report.residual_load = std::max(s.report.residual_load, last.load);
  return last.within(s.goal, slack * s.tolerance);
}

// Lets a converged part pass as a solution if the guard does. Else what it stood on is found anew, for whatever is
// tried next, and nothing returns to it.
Outcome Newton::guarded(Outcome outcome) {
  if (outcome != Outcome::converged) return outcome;
  Solve& s = solve_;
  if (holds()) {
    if (s.goal == Part::normal || !friction_overdrawn(*s.problem, s.given, s.iterate->lambda)) return outcome;
    s.report.share = share_of_friction(*s.problem, s.given, s.iterate->lambda);
    return Outcome::no_solution;
  }
  ++s.report.refuted;
  iteration_.forget_best();
  begin_cold();
  if (s.goal == Part::tangential && s.iterations_left > 0)
    pressures_found_ = iteration_.run(Part::normal, s.given) == Outcome::converged;
  const LawResidual now = iteration_.evaluate(s.goal, s.given);
  if (s.goal != Part::tangential) s.report.residual_normal = now.normal;
  if (s.goal != Part::normal) s.report.residual_tangential = now.tangential;
  s.report.residual_load = now.load;
  return Outcome::not_converged;
}

}  // namespace rollcon
