#include "contact/results/outcome_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "contact/results/doubts.hpp"
#include "contact/scene/geometry.hpp"

namespace rollcon {
namespace {

/// Names the cause of contact at the rim, one of three that the caller can tell apart only by this text.
const char* cause_of_rim_contact(const Solution& s) {
  const std::vector<double> gap = s.prepared->problem.undeformed_gaps();
  if (is_turned(gap, s.prepared->frame.rim))
    return "the gap is least at the rim and greatest inside: a gap is positive where the bodies "
           "are apart, has it the wrong sign?";
  bool all_around = true;
  for (std::size_t k = 0; k < gap.size(); ++k)
    all_around = all_around && !(s.prepared->frame.used[k] && s.prepared->frame.rim[k] && s.iterate.lambda[2][k] >= 0);
  if (all_around)
    return "all of the rim is in contact: enlarge the frame, unless its coordinates, the gap, the "
           "loads and Young's modulus are not all in the same units";
  return "enlarge the frame";
}

std::string share_text(double share) {
  if (!(share < 1e6)) return "infinite";
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", share);
  return text;
}

std::string times(double share) {
  if (!(share < 1e6)) return "beyond";
  return share < 1.00005 ? "all of" : share_text(share) + " times";
}

Line not_converged(const Solution& s) {
  const NewtonReport& r = s.report;
  const std::vector<double>& mu = s.prepared->problem.mu;
  const bool strong = !mu.empty() && *std::max_element(mu.begin(), mu.end()) >= 1;
  return line_of(
      "not converged after %lld iterations and %lld fallbacks: residuals %.1e normal, %.1e "
      "tangential, %.1e of the loads%s; the best iterate is kept",
      static_cast<long long>(r.normal_iterations + r.tangential_iterations + r.full_iterations),
      static_cast<long long>(r.fallbacks), r.residual_normal, r.residual_tangential, r.residual_load,
      s.prepared->problem.op->coupled && strong
          ? " (with friction of 1 and more between unlike bodies there may be several solutions or "
            "none)"
          : "");
}

}  // namespace

std::string describe_beyond_friction(const FrictionShare& share) {
  const std::string all = times(share.sliding);
  if (share.before_fall)
    return std::string("the prescribed ") +
           (share.by_moment && share.by_force ? "tangential force and spin moment together are "
            : share.by_moment                 ? "spin moment is "
                                              : "tangential force is ") +
           all + " the greatest on the branch that begins with stick (friction falls with the slip speed)";
  if (!share.by_moment)
    return "the prescribed tangential force is " + all + " what friction can carry (|Ft| must be less than mu Fn)";
  if (!share.by_force)
    return "the prescribed spin moment is " + all +
           " what friction can carry (that of all nodes sliding around the origin)";
  return "the prescribed tangential force and spin moment together are " + all +
         " what friction can carry (alone the force is " + share_text(share.force) + " of it, the moment " +
         share_text(share.moment) + ")";
}

Line describe_outcome(const Solution& s) {
  switch (s.report.outcome) {
    case Outcome::not_converged:
      return not_converged(s);
    case Outcome::cancelled:
      return {"cancelled; the best iterate is kept"};
    case Outcome::no_contact:
      return {"the bodies do not touch"};
    case Outcome::no_solution:
      return line_of("%s: there is no steady solution", describe_beyond_friction(s.report.share).c_str());
    case Outcome::converged:
      break;
  }
  if (const std::int64_t rim = nodes_at_rim(s); rim > 0)
    return line_of("contact reaches the rim of the frame at %lld node(s), approach %.6g: %s",
                   static_cast<long long>(rim), s.given.approach_of(s.iterate.motion, s.prepared->problem.datum),
                   cause_of_rim_contact(s));
  if (const Line deep = describe_too_deep(s); *deep.text) return deep;
  return line_of("converged, residuals %.1e normal, %.1e tangential", s.report.residual_normal,
                 s.report.residual_tangential);
}

}  // namespace rollcon
