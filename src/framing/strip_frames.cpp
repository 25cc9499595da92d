#include "framing/strip_frames.hpp"

#include <cmath>

#include "framing/strips/strip_results.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {

using namespace strips;

Rates rates_of(const StripTotals& t) {
  Rates r;
  r.force = {t.force[0], t.force[1], -t.load};
  r.moment = {-t.pressed[1], t.pressed[0], t.force[2]};
  r.motion[xi1] = t.motion[0];
  r.motion[xi2] = t.motion[1];
  r.motion[spin] = t.motion[2];
  r.motion[approach] = t.approach;
  return r;
}

StripReport StripFrames::fit(Solver& on, const Rectangle& box, StripCounts counts) {
  givens_.read(on, box);
  const StripReport report = contact_.solve(givens_.scene(), box, counts, solution_, warm_);
  warm_ = report.status == StripStatus::solved;
  if (warm_) totals_ = StripContact::totals(solution_);
  return report;
}

bool StripFrames::within_bodies() const {
  const StripState& s = solution_.strips;
  for (const StripPoint& p : s.layout.observers)
    if (!givens_.both_at({s.layout.x(p, s.geometry.data()), s.layout.y(p, s.geometry.data())})) return false;
  return true;
}

Status StripFrames::show(Solver& on) {
  // Where strips do not fit, a neighbour without a neck shows what the contact is like.
  const StripState& from = solution_.share > 0 ? solution_.strips : solution_.neighbour[1];
  on.scene.set_strips(from.layout, from.geometry);
  Iterate& it = on.start();
  const std::vector<std::int32_t>& node = on.scene.strips()->node;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::size_t k = at(node[i]);
    it.lambda[2][k] = -from.pressure[i];
    for (std::size_t c = 0; c < 2; ++c) it.lambda[c][k] = by_law() ? 0 : from.traction[c * node.size() + i];
  }
  it.motion[xi1] = from.motion[0];
  it.motion[xi2] = from.motion[1];
  it.motion[spin] = from.motion[2];
  it.motion[approach] = from.approach - on.solution().prepared->problem.datum;
  const Status status = on.solve();
  if (!is_answer(status)) return status;
  if (solution_.share > 0) {
    shown_ = from;
    for (std::size_t i = 0; i < node.size(); ++i) shown_.pressure[i] = -it.lambda[2][at(node[i])];
    on.derived().largest_pressure = largest_pressure(shown_).pressure;
  }
  if (by_law()) return status;
  if (solution_.share < 1) {
    const Rates all = rates_of(totals_);
    Extrapolated results;
    results.force = all.force;
    results.moment = all.moment;
    results.motion = all.motion;
    for (std::size_t k = 0; k < it.lambda[2].size(); ++k)
      if (it.lambda[2][k] < 0) results.area += on.solution().prepared->problem.cell_area[k];
    on.derived().extrapolated = results;
  }
  on.follow(*this);
  return status;
}

bool StripFrames::rates(Parameter parameter, Rates& found) {
  StripParameter by;
  switch (parameter) {
    case Parameter::longitudinal:
      by.motion[0] = 1;
      break;
    case Parameter::lateral:
      by.motion[1] = 1;
      break;
    case Parameter::spin:
      by.motion[2] = 1;
      break;
    case Parameter::normal:
      by.value = 1;
      break;
    case Parameter::friction:
      by.mu = givens_.scene().mu;
      break;
    default:
      return false;
  }
  StripTotals rate;
  if (!contact_.rates(givens_.scene(), solution_, {&by, 1}, {&rate, 1}))
    fail(Status::err_singular, "the linearised system of the contact on strips has no solution");
  found = rates_of(rate);
  return true;
}

}  // namespace rollcon
