/// Several prescribed tangential loads, found from the outside: given motions converge where given
/// forces get stuck. Few unknowns, so a Newton iteration with differences does.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"

namespace rollcon {
namespace {

constexpr int most_evaluations = 150;
constexpr int most_halvings = 8;
constexpr double difference = 1e-3;  // of the motions or of the creepage where friction saturates
constexpr double longest = 4;        // step, likewise
constexpr double farthest = 100;     // start, of where friction saturates
constexpr double good = 0.3;         // factor on the error above which differences are taken anew

using Few = std::array<double, 3>;
using FewRows = std::array<Few, 3>;

double size_of(const Few& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// x of a x = b for the leading count unknowns, elimination with pivots; false: singular.
bool solve_few(std::size_t count, FewRows a, Few b, Few& x) {
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < count; ++r)
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    if (!(std::abs(a[pivot][i]) > 0)) return false;
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t r = i + 1; r < count; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < count; ++c) a[r][c] -= factor * a[i][c];
      b[r] -= factor * b[i];
    }
  }
  x = {};
  for (std::size_t i = count; i-- > 0;) {
    double sum = b[i];
    for (std::size_t c = i + 1; c < count; ++c) sum -= a[i][c] * x[c];
    x[i] = sum / a[i][i];
  }
  return std::isfinite(size_of(x));
}

// Broyden's update: the slope that also explains the step from x to next.
void update(std::size_t count, const Few& x, const Few& next, const Few& before, const Few& after,
            FewRows& slope) {
  double square = 0;
  for (std::size_t c = 0; c < count; ++c) square += (next[c] - x[c]) * (next[c] - x[c]);
  for (std::size_t r = 0; r < count; ++r) {
    double foretold = before[r];
    for (std::size_t c = 0; c < count; ++c) foretold += slope[r][c] * (next[c] - x[c]);
    for (std::size_t c = 0; c < count; ++c)
      slope[r][c] += (after[r] - foretold) * (next[c] - x[c]) / square;
  }
}

// No tangential tractions; where pressures depend on them a new guess of those too, else those that
// were found.
void start_anew(Solve& s, const Prescribed& given) {
  Iterate& it = *s.iterate;
  if (s.goal == Part::full) {
    it.clear_tractions();
    guess_start(*s.problem, given, it);
    return;
  }
  for (int c = 0; c < 2; ++c) std::fill(it.lambda[c].begin(), it.lambda[c].end(), 0.0);
  std::fill(it.slip_valid.begin(), it.slip_valid.end(), std::uint8_t{0});
}

}  // namespace

Outcome search_creep(NewtonIteration& newton) {
  Solve& s = newton.solve();
  const Problem& p = *s.problem;
  Iterate& it = *s.iterate;
  std::array<std::size_t, 3> motion{};
  std::size_t count = 0;
  for (const int m : {xi1, xi2, spin})
    if (s.given.by_force[static_cast<std::size_t>(m)])
      motion[count++] = static_cast<std::size_t>(m);
  if (count < 2) return Outcome::not_converged;
  newton.return_to_best();
  const double scale = creep_scale(p, s.given, it, xi1);
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;

  Prescribed given = s.given;
  Few unit{}, target{}, x{};  // spin counts as the creepage at a frame's length
  for (std::size_t i = 0; i < count; ++i) {
    unit[i] = motion[i] == spin ? 1 / p.length : 1;
    target[i] = given.value[motion[i]] * unit[i];
    x[i] = it.motion[motion[i]] / unit[i];
    given.by_force[motion[i]] = false;
  }
  const std::int64_t for_others = s.iterations_left / 2;  // fallbacks after this one
  Outcome outcome = Outcome::converged;
  int evaluations = 0;
  double carried = 0;  // terms of the loads
  std::vector<double> kept[3];
  // Loads beyond those wanted.
  const auto excess = [&](const Few& at, Few& error) {
    for (std::size_t i = 0; i < count; ++i)
      given.value[motion[i]] = it.motion[motion[i]] = at[i] * unit[i];
    outcome = newton.run(s.goal, given, {.free_steps = 1, .rehearsal = true});
    ++evaluations;
    if (outcome == Outcome::not_converged && !kept[0].empty() && s.iterations_left > 0) {
      // Too far: as bad as can be, and back.
      for (int c = 0; c < 3; ++c) it.lambda[c] = kept[c];
      it.invalidate();
      outcome = Outcome::converged;
      error = {INFINITY, 0, 0};
      return true;
    }
    if (outcome != Outcome::converged) return false;
    error = {};
    carried = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const LoadSum load = load_on_body1(p, static_cast<int>(motion[i]), it.lambda);
      error[i] = load.value * unit[i] - target[i];
      carried = std::max(carried, load.magnitude * unit[i]);
    }
    return std::isfinite(size_of(error));
  };

  if (!(size_of(x) < farthest * scale)) x = {};
  Few error{};
  bool there = excess(x, error);
  if (outcome == Outcome::not_converged && s.iterations_left > 0) {
    x = {};
    start_anew(s, given);
    there = excess(x, error);
  }
  FewRows slope{};
  bool known = false;
  while (there && size_of(error) > s.tolerance * carried && evaluations < most_evaluations &&
         s.iterations_left > for_others) {
    const double reach = std::max(scale, size_of(x));
    for (int c = 0; c < 3; ++c) kept[c] = it.lambda[c];
    if (!known) {
      for (std::size_t c = 0; there && c < count; ++c) {
        Few beside = x, change{};
        beside[c] += difference * reach;
        there = excess(beside, change);
        for (std::size_t r = 0; r < count; ++r)
          slope[r][c] = (change[r] - error[r]) / (beside[c] - x[c]);
      }
      if (!there) break;
    }
    Few step{}, wanted{};
    for (std::size_t i = 0; i < count; ++i) wanted[i] = -error[i];
    if (!solve_few(count, slope, wanted, step)) break;
    double part = std::min(1.0, longest * reach / size_of(step));
    Few next{}, after{};
    bool better = false;
    for (int k = 0; there && !better && k < most_halvings; ++k, part /= 2) {
      for (std::size_t i = 0; i < count; ++i) next[i] = x[i] + part * step[i];
      there = excess(next, after);
      better = there && size_of(after) < (1 - 0.1 * part) * size_of(error);
    }
    if (!better) {
      if (!there || !known) break;
      known = false;
      continue;
    }
    update(count, x, next, error, after, slope);
    known = size_of(after) < good * size_of(error);
    x = next;
    error = after;
  }
  if (outcome != Outcome::converged) return outcome;
  // The iterate is that of the last motion tried.
  for (std::size_t i = 0; i < count; ++i) it.motion[motion[i]] = x[i] * unit[i];
  return newton.run(s.goal, s.given, {.free_steps = 2});
}

}  // namespace rollcon
