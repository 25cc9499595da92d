/// Finds several prescribed tangential loads from the outside: given motions converge where given forces get stuck.
/// There are few unknowns, so a Newton iteration with differences does.

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "support/small_system.hpp"

namespace rollcon {
namespace {

constexpr int most_evaluations = 150;
constexpr int most_halvings = 8;
constexpr double difference = 1e-3;  // fraction of the motions or of the creepage where friction saturates
constexpr double longest = 4;        // longest step, in these units
constexpr double farthest = 100;     // farthest start, over the creepage where friction saturates
constexpr double good = 0.3;         // factor on the error above which differences are taken anew

using Few = std::array<double, 3>;
using FewRows = std::array<Few, 3>;

double size_of(const Few& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// Updates by Broyden's formula: the slope also explains the step from x to next.
void update(std::size_t count, const Few& x, const Few& next, const Few& before, const Few& after, FewRows& slope) {
  double square = 0;
  for (std::size_t c = 0; c < count; ++c) square += (next[c] - x[c]) * (next[c] - x[c]);
  for (std::size_t r = 0; r < count; ++r) {
    double foretold = before[r];
    for (std::size_t c = 0; c < count; ++c) foretold += slope[r][c] * (next[c] - x[c]);
    for (std::size_t c = 0; c < count; ++c) slope[r][c] += (after[r] - foretold) * (next[c] - x[c]) / square;
  }
}

/// Holds the search's loads and the motions that belong to them; spin counts as the creepage at a frame's length.
class CreepSearch {
 public:
  explicit CreepSearch(NewtonIteration& newton)
      : newton_(newton), s_(newton.solve()), given_(s_.given), for_others_(s_.iterations_left / 2) {
    for (const int m : {xi1, xi2, spin})
      if (given_.by_force[static_cast<std::size_t>(m)]) motion_[count_++] = static_cast<std::size_t>(m);
  }
  std::size_t loads() const { return count_; }
  /// Runs the search; scale: the creepage at which friction saturates.
  Outcome run(double scale);

 private:
  bool excess(const Few& at, Few& error);
  bool find_slope(double reach);
  bool step(double reach);
  void start_anew();

  NewtonIteration& newton_;
  Solve& s_;
  Prescribed given_;
  std::int64_t for_others_;  ///< iterations for the fallbacks after this one
  std::array<std::size_t, 3> motion_{};
  std::size_t count_ = 0;
  Few unit_{}, target_{}, x_{}, error_{};
  FewRows slope_{};
  bool slope_known_ = false;
  Outcome outcome_ = Outcome::converged;
  int evaluations_ = 0;
  double carried_ = 0;  ///< terms of the loads
  std::vector<double> kept_[3];
};

// Starts without tangential tractions, and with new pressures where these depend on them.
void CreepSearch::start_anew() {
  Iterate& it = *s_.iterate;
  if (s_.goal == Part::full) {
    it.clear_tractions();
    guess_start(*s_.problem, given_, it);
    return;
  }
  for (int c = 0; c < 2; ++c) std::fill(it.lambda[c].begin(), it.lambda[c].end(), 0.0);
  std::fill(it.slip_valid.begin(), it.slip_valid.end(), std::uint8_t{0});
}

// Finds loads beyond those wanted. Returns false if none were found, or they are no numbers.
bool CreepSearch::excess(const Few& at, Few& error) {
  Iterate& it = *s_.iterate;
  for (std::size_t i = 0; i < count_; ++i) given_.value[motion_[i]] = it.motion[motion_[i]] = at[i] * unit_[i];
  outcome_ = newton_.run(s_.goal, given_, {.free_steps = 1, .rehearsal = true});
  ++evaluations_;
  if (outcome_ == Outcome::not_converged && !kept_[0].empty() && s_.iterations_left > 0) {
    // A motion that is too far counts as bad as can be, and the tractions go back.
    for (int c = 0; c < 3; ++c) it.lambda[c] = kept_[c];
    it.invalidate();
    outcome_ = Outcome::converged;
    error = {INFINITY, 0, 0};
    return true;
  }
  if (outcome_ != Outcome::converged) return false;
  error = {};
  carried_ = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const LoadSum load = load_on_body1(*s_.problem, static_cast<int>(motion_[i]), it.lambda);
    error[i] = load.value * unit_[i] - target_[i];
    carried_ = std::max(carried_, load.magnitude * unit_[i]);
  }
  return std::isfinite(size_of(error));
}

bool CreepSearch::find_slope(double reach) {
  for (std::size_t c = 0; c < count_; ++c) {
    Few beside = x_, change{};
    beside[c] += difference * reach;
    if (!excess(beside, change)) return false;
    for (std::size_t r = 0; r < count_; ++r) slope_[r][c] = (change[r] - error_[r]) / (beside[c] - x_[c]);
  }
  return true;
}

// Takes a step; returns false if nothing leads on.
bool CreepSearch::step(double reach) {
  Few move{}, wanted{};
  for (std::size_t i = 0; i < count_; ++i) wanted[i] = -error_[i];
  if (!solve_small(count_, slope_, wanted, move)) return false;
  double part = std::min(1.0, longest * reach / size_of(move));
  Few next{}, after{};
  bool better = false;
  for (int k = 0; !better && k < most_halvings; ++k, part /= 2) {
    for (std::size_t i = 0; i < count_; ++i) next[i] = x_[i] + part * move[i];
    if (!excess(next, after)) return false;
    better = size_of(after) < (1 - 0.1 * part) * size_of(error_);
  }
  if (!better) {
    const bool again = slope_known_;  // true: differences are taken anew
    slope_known_ = false;
    return again;
  }
  update(count_, x_, next, error_, after, slope_);
  slope_known_ = size_of(after) < good * size_of(error_);
  x_ = next;
  error_ = after;
  return true;
}

Outcome CreepSearch::run(double scale) {
  Iterate& it = *s_.iterate;
  for (std::size_t i = 0; i < count_; ++i) {
    unit_[i] = motion_[i] == spin ? 1 / s_.problem->length : 1;
    target_[i] = given_.value[motion_[i]] * unit_[i];
    x_[i] = it.motion[motion_[i]] / unit_[i];
    given_.by_force[motion_[i]] = false;
  }
  if (!(size_of(x_) < farthest * scale)) x_ = {};
  bool there = excess(x_, error_);
  if (outcome_ == Outcome::not_converged && s_.iterations_left > 0) {
    x_ = {};
    start_anew();
    there = excess(x_, error_);
  }
  while (there && size_of(error_) > s_.tolerance * carried_ && evaluations_ < most_evaluations &&
         s_.iterations_left > for_others_) {
    const double reach = std::max(scale, size_of(x_));
    for (int c = 0; c < 3; ++c) kept_[c] = it.lambda[c];
    there = (slope_known_ || find_slope(reach)) && step(reach);
  }
  if (outcome_ != Outcome::converged) return outcome_;
  // The iterate is that of the last motion tried.
  for (std::size_t i = 0; i < count_; ++i) it.motion[motion_[i]] = x_[i] * unit_[i];
  return newton_.run(s_.goal, s_.given, {.free_steps = 2});
}

}  // namespace

Outcome search_creep(NewtonIteration& newton) {
  CreepSearch search(newton);
  if (search.loads() < 2) return Outcome::not_converged;
  newton.return_to_best();
  const Solve& s = newton.solve();
  const double scale = creep_scale(*s.problem, s.given, *s.iterate, xi1);
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;
  return search.run(scale);
}

}  // namespace rollcon
