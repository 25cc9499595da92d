/// Refuses gaps and creepages so large that no arithmetic is left for them.

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "contact/solution.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr double largest = 1e305;           // sums of some and their hypotenuse stay below 1.8e308
constexpr double largest_pressure = 1e150;  // the sum of squares of residuals stays below, too

long long named(const Solution& s, std::size_t k) {
  return static_cast<long long>(k) + s.prepared->frame.mesh.index_base;
}

}  // namespace

// Checks augmented tractions, which are tractions less a scale times gap or slip: that product must be a number, and so
// must the slip velocity, which is a result.
void refuse_overflow(const Solution& s) {
  const Problem& p = s.prepared->problem;
  MotionValues motion{};
  for (std::size_t m = 0; m < motion_count; ++m)
    if (!s.given.by_force[m]) motion[m] = s.given.value[m];
  if (s.given.by_force[approach]) motion[approach] = -p.datum;  // no approach: the gap as given
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!s.prepared->frame.used[k]) continue;
    const double gap = p.rigid_gap(k, motion), scale = std::max(1.0, p.rn[k]);
    // Under a load gaps count from the least one. Nodes that are never to touch may have any gap, but the monolithic
    // system counts it among its residuals.
    const double least = s.given.by_force[approach] ? -DBL_MAX : -largest_pressure / scale,
                 most = s.procedure.monolithic ? largest_pressure / scale : DBL_MAX;
    if (!(gap >= least && gap <= most && p.gap[k] <= most))
      fail(Status::err_argument,
           "the gap of node %lld (counting from %d), less the prescribed approach, is %g, and %g "
           "more than the least gap; allowed: %g to %g",
           named(s, k), s.prepared->frame.mesh.index_base, gap, p.gap[k], least, most);
  }
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!s.prepared->frame.used[k]) continue;
    const auto i = static_cast<std::int64_t>(k);
    const double most = largest / std::max({1.0, s.prepared->speed, p.rt[k]});
    const double slip1 = std::abs(p.rigid_slip1(i, motion)), slip2 = std::abs(p.rigid_slip2(i, motion));
    if (!(slip1 <= most && slip2 <= most))
      fail(Status::err_argument,
           "creepages, spin, velocities and creep field let node %lld (counting from %d) slip by %g of the "
           "speed; allowed: up to %g",
           named(s, k), s.prepared->frame.mesh.index_base, std::max(slip1, slip2), most);
  }
}

}  // namespace rollcon
