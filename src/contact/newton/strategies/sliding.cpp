/// Finds whether friction can carry the loads where it changes the pressures, by those of the same contact with every
/// node sliding against the loads.

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t iterations = 60;
constexpr int most_turns = 3;       // changes of the direction of sliding
constexpr double same_turn = 1e-3;  // change of that direction
constexpr double far = 1e6;         // slip, in units of the elastic and the given one
constexpr RunSettings rehearsal{.tolerance = sliding_tolerance, .max_iterations = iterations, .rehearsal = true};

// Returns slip beside which that of tractions and of the given motions is small; 0: not known.
double great_slip(const Solve& s) {
  const Problem& p = *s.problem;
  MotionValues given = s.given.value;
  for (const int m : {xi1, xi2, spin})
    if (s.given.by_force[at(m)]) given[at(m)] = 0;
  double slip = 0;
  for (std::size_t k = 0; k < p.rt.size(); ++k) {
    const double pressure = -s.iterate->lambda[2][k];
    if (!(pressure > 0 && p.rt[k] > 0)) continue;
    const auto i = static_cast<std::int64_t>(k);
    slip = std::max({slip, (1 + s.given.coefficient(p.mu, k)) * pressure / p.rt[k],
                     std::hypot(p.rigid_slip1(i, given), p.rigid_slip2(i, given))});
  }
  return std::isfinite(slip) ? far * slip : 0;
}

FrictionShare slide(NewtonIteration& newton) {
  constexpr int motions[] = {xi1, xi2, spin};
  Solve& s = newton.solve();
  const Problem& p = *s.problem;
  Iterate& it = *s.iterate;
  Prescribed given = s.given;
  for (const int m : motions) given.by_force[at(m)] = false;
  given.falling = 0;  // beyond what friction carries at great speed there may be solutions at a lesser one
  start_cold(p, given, it);
  guess_start(p, given, it);
  if (newton.run(Part::normal, given, rehearsal) != Outcome::converged) return {};
  const double slip = great_slip(s);
  if (!(slip > 0)) return {};
  std::array<double, 3> direction{};
  for (int turn = 0;; ++turn) {
    FrictionShare share = share_of_friction(p, s.given, it.lambda);
    const double size = std::hypot(share.direction[0], share.direction[1], share.direction[2]);
    if (!(size > 0) || !std::isfinite(size)) return {};
    double turned = 0, asked = 0, carried = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t m = at(motions[i]);
      const double a = share.direction[i] / size, unit = motions[i] == spin ? 1 / p.length : 1;
      turned = std::max(turned, std::abs(a - direction[i]));
      direction[i] = a;
      if (!s.given.by_force[m]) continue;
      asked += a * unit * s.given.value[m];
      carried += a * unit * load_on_body1(p, motions[i], it.lambda).value;
      given.value[m] = it.motion[m] = -slip * a * unit;
    }
    if (turn > 0) share.sliding = carried > 0 ? asked / carried : INFINITY;
    if (turn > 0 && (turned < same_turn || turn == most_turns)) return share;
    if (newton.run(s.goal, given, rehearsal) != Outcome::converged) return {};
  }
}

}  // namespace

FrictionShare slide_against_loads(NewtonIteration& newton) {
  Solve& s = newton.solve();
  const NewtonReport report = s.report;
  const std::int64_t left = s.iterations_left;
  s.iterations_left = (most_turns + 1) * iterations;
  const FrictionShare share = slide(newton);
  s.report = report;
  s.iterations_left = left;
  return share;
}

}  // namespace rollcon
