/// Tells what a finished solve is worth: its status, and whether the frame was large enough.

#include <algorithm>
#include <cmath>

#include "contact/estimate/few_nodes.hpp"
#include "contact/results/doubts.hpp"
#include "contact/results/outcome_text.hpp"
#include "contact/solution.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {

// Counts nodes where a frame of strips that ends at the contact's edge cuts the contact off. Pressures of a frame that
// fits fall to a half or less over the last two cells of a strip; else they rise, or the bodies overlap beside it.
static std::int64_t nodes_cut_off(const Solution& s) {
  // The ellipse of Hertz is where the contact ends, which friction of unlike bodies moves a little; strips are fitted.
  if (s.prepared->placed || s.prepared->frame.strips) return 0;
  // Frames that fit overlap by up to 0.07 on 6 x 4 strips, 0.014 on 12 x 8: hats are 0 on the outline.
  constexpr double overlap = 0.1;  // fraction of the approach
  constexpr double rise = 0.9, least = 0.25;
  const Problem& p = s.prepared->problem;
  const std::vector<double>& normal = s.iterate.lambda[2];
  // The approach beyond first touch: gaps count from the least of them.
  const double depth = s.iterate.motion[approach];
  const double largest = -*std::min_element(normal.begin(), normal.end());
  const auto n = static_cast<std::ptrdiff_t>(p.used.size());
  std::int64_t count = 0;
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    if (p.used[at(k)]) continue;
    // Only rows tell the gap there.
    bool cut = p.op->normal && p.rigid_gap(at(k), s.iterate.motion) - s.iterate.image[2][at(k)] < -overlap * depth;
    // Nodes follow each other along a strip; the next strip starts after the last one.
    const std::vector<double>&x = s.prepared->frame.x, &y = s.prepared->frame.y;
    for (const std::ptrdiff_t step : {-1, 1}) {
      const std::ptrdiff_t next = k + step, second = k + 2 * step;
      if (second < 0 || second >= n || !p.used[at(next)] || !p.used[at(second)]) continue;
      if (std::abs(y[at(next)] - y[at(k)]) > 1e-6 * std::abs(x[at(next)] - x[at(k)])) continue;
      cut = cut || (-normal[at(next)] > least * largest && normal[at(next)] < rise * normal[at(second)]);
    }
    count += cut;
  }
  return count;
}

std::int64_t nodes_at_rim(const Solution& s) {
  const std::uint8_t* rim = s.prepared->frame.rim.data();
  const double* normal = s.iterate.lambda[2].data();
  std::int64_t count = 0;
  if (s.prepared->ends_at_edge) return nodes_cut_off(s);
  for (std::size_t k = 0; k < s.prepared->frame.rim.size(); ++k)
    count += static_cast<std::int64_t>(rim[k] != 0) & static_cast<std::int64_t>(normal[k] < 0);
  return count;
}

void refuse_tangential_loads(const Prescribed& given) {
  for (const int m : {xi1, xi2, spin})
    if (given.by_force[static_cast<std::size_t>(m)] && given.value[static_cast<std::size_t>(m)] != 0)
      fail(Status::err_load,
           "a tangential force or spin moment is prescribed but the friction coefficient is 0 "
           "at every node: there is no steady solution");
}

void refuse_load_beside_frame(const Solution& s) {
  const Prescribed& given = s.given;
  const Frame& frame = s.prepared->frame;
  const double load = given.value[approach];
  if (!given.by_force[approach] || !(load > 0) || frame.curved()) return;
  const auto require_within = [&](const char* name, Motion m, double place, const std::vector<double>& of) {
    double least = INFINITY, most = -INFINITY;
    for (std::size_t k = 0; k < of.size(); ++k)
      if (frame.used[k]) least = std::min(least, of[k]), most = std::max(most, of[k]);
    if (given.by_force[m] && !(place >= least && place <= most))
      fail(Status::err_load, "normal load and moments act at %s = %g; nodes that may touch have %g to %g", name, place,
           least, most);
  };
  require_within("x", tilt2, given.value[tilt2] / load, frame.x);
  require_within("y", tilt1, -given.value[tilt1] / load, frame.y);
}

Status status_of(const Solution& s) {
  switch (s.report.outcome) {
    case Outcome::no_solution:
      fail(Status::err_load, "%s: there is no %ssolution", describe_beyond_friction(s.report.share).c_str(),
           s.prepared->step == StepKind::steady ? "steady " : "");
    case Outcome::cancelled:
      return Status::cancelled;
    case Outcome::not_converged:
      return Status::not_converged;
    case Outcome::no_contact:
      return Status::no_contact;
    case Outcome::converged:
      break;
  }
  if (too_few_nodes(s)) return Status::coarse;
  if (nodes_at_rim(s) > 0) return Status::rim_contact;
  return *describe_too_deep(s).text ? Status::too_deep : Status::ok;
}

}  // namespace rollcon
