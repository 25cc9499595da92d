#include "framing/strips/strip_bridge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "framing/strips/field_sum.hpp"
#include "framing/strips/strip_results.hpp"
#include "linalg/blas_threads.hpp"

namespace rollcon::strips {
namespace {

// Heights of the neighbours' bumps are parts of the wall. Rows across a neck that is filled less are hard to find, and
// a side of a neck that is dug out more may lose contact.
constexpr double heights[] = {-1.1, -0.55, 0.18, 0.36};

/// Returns the weight of a neighbour in the cubic through all of them, taken where there is no bump.
constexpr double weight(std::size_t which) {
  double w = 1;
  for (std::size_t i = 0; i < std::size(heights); ++i)
    if (i != which) w *= -heights[i] / (heights[which] - heights[i]);
  return w;
}
constexpr double weights[] = {weight(0), weight(1), weight(2), weight(3)};
constexpr int samples = 120;

void add(StripTotals& to, double w, const StripTotals& t) {
  to.load += w * t.load;
  to.approach += w * t.approach;
  for (int k = 0; k < 3; ++k) {
    to.force[k] += w * t.force[k];
    to.motion[k] += w * t.motion[k];
  }
  to.pressed = to.pressed + w * t.pressed;
}

/// Moves to where the gap is stationary, along x and y in turn (or along a line alone), by secants of its slope.
Vec2 stationary(const PlaneField& gap, Vec2 at, double size, int directions, const Vec2 (&direction)[2]) {
  for (int round = 0; round < 12; ++round)
    for (int d = 0; d < directions; ++d) {
      const double step = 1e-4 * size;
      const Vec2 e = direction[d], beside[2] = {at - step * e, at + step * e};
      double value[2];
      Vec2 slope[2];
      gap.at(beside, value, slope);
      const double a = dot(slope[0], e), b = dot(slope[1], e);
      if (a == b) continue;
      const double by = -(a + b) / 2 / ((b - a) / (2 * step));
      at = at + std::clamp(by, -0.1 * size, 0.1 * size) * e;
    }
  return at;
}

/// Returns the neck between two places: the largest gap on the line between the least gaps near both.
Neck neck_between(const PlaneField& gap, Vec2 first, Vec2 second) {
  const double distance = length(second - first), size = distance / 4;
  const Vec2 axes[2] = {{1, 0}, {0, 1}};
  const Vec2 a = stationary(gap, first, size, 2, axes), b = stationary(gap, second, size, 2, axes);
  Neck neck;
  if (length(a - first) > distance / 2 || length(b - second) > distance / 2) return neck;
  std::vector<Vec2> line;
  for (int i = 0; i <= samples; ++i) line.push_back(a + (static_cast<double>(i) / samples) * (b - a));
  std::vector<double> value(line.size());
  gap.at(line, value.data(), nullptr);
  const auto top = static_cast<std::size_t>(std::max_element(value.begin(), value.end()) - value.begin());
  if (top == 0 || top + 1 == value.size()) return neck;
  const Vec2 along[2] = {(1 / length(b - a)) * (b - a), {}};
  neck.place = stationary(gap, line[top], length(b - a) / samples * 4, 1, along);
  neck.radius = 0.63 * length(b - a);
  double there = 0;
  gap.at({&neck.place, 1}, &there, nullptr);
  neck.wall = std::max(there - std::max(value.front(), value.back()), 0.0);
  return neck;
}

/// Finds places where the undeformed gap is least, of the contact's two halves across a valley or of two parts.
bool halves(const StripState& state, Vec2& first, Vec2& second) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  const auto row_load = [&](int row) {
    double sum = 0;
    for (int i = 0; i < l.nodes_each; ++i)
      sum += l.unit_weight[row * l.nodes_each + i] * state.pressure[row * l.nodes_each + i];
    return sum * g[l.half_of(row)] * g[l.width_of(l.part_of(row))];
  };
  const auto mean = [&](int from, int to) {
    double load = 0;
    Vec2 at{};
    for (int row = from; row < to; ++row) {
      const double q = row_load(row);
      load += q;
      at = at + q * Vec2{g[row], l.y(l.node[row * l.nodes_each], g)};
    }
    return (1 / load) * at;
  };
  if (l.parts > 2) return false;
  int cut = l.rows_each;
  if (l.parts == 1) {
    double least = 1;
    for (int row = 1; row + 1 < l.rows; ++row) {
      double left = 0, right = 0;
      for (int other = 0; other < l.rows; ++other)
        (other < row ? left : right) = std::max(other < row ? left : right, row_load(other) / g[l.half_of(other)]);
      const double valley = row_load(row) / g[l.half_of(row)] / std::min(left, right);
      if (valley < least) least = valley, cut = row;
    }
    if (cut == l.rows_each) return false;
  }
  first = mean(0, cut);
  second = mean(l.parts == 1 ? cut + 1 : cut, l.rows);
  return true;
}

/// Gives the rates of gaps whose bumps move with the neck: the rate of the gap and a difference of two bumps.
class NeckRate {
 public:
  void set(const StripScene& scene, const PlaneField& rate, const StripSolution& solution) {
    bump_[0].gap = &rate;
    bump_[1].gap = &bump_[0];
    const Neck& neck = solution.neck;
    Vec2 first, second;
    if (!halves(solution.neighbour[2], first, second)) return;
    double at_neck = 0, at_first = 0, at_second = 0;
    rate.at({&neck.place, 1}, &at_neck, nullptr);
    rate.at({&first, 1}, &at_first, nullptr);
    rate.at({&second, 1}, &at_second, nullptr);
    const double most = std::max(std::abs(at_neck - at_first), std::abs(at_neck - at_second));
    if (!(most > 0)) return;
    constexpr double little = 1e-3;
    const double step = little * neck.wall / most;
    for (const int k : {0, 1}) {
      FieldSum moved;
      moved.field[0] = scene.gap;
      moved.field[1] = &rate;
      moved.factor[1] = k == 0 ? step : -step;
      bump_[k].neck = neck_between(moved, first, second);
      if (!(bump_[k].neck.wall > 0)) return;
    }
    factor_[0] = 0.5 / step;
    factor_[1] = -factor_[0];
  }
  /// Returns the rate for a bump whose height is this part of the wall.
  const PlaneField& of(double height) {
    for (const int k : {0, 1}) bump_[k].height = factor_[k] * height * bump_[k].neck.wall;
    return bump_[1];
  }

 private:
  BridgedGap bump_[2];
  double factor_[2] = {};
};

}  // namespace

void BridgedGap::at(std::span<const Vec2> point, double* value, Vec2* slope) const {
  gap->at(point, value, slope);
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Vec2 d = (1 / neck.radius) * (point[i] - neck.place);
    const double inside = 1 - dot(d, d);
    if (!(inside > 0)) continue;
    value[i] += height * inside * inside * inside;
    if (slope) slope[i] = slope[i] - (6 * height * inside * inside / neck.radius) * d;
  }
}

// Goes on from the state for one height of the bump, a part of the wall, to that for another.
bool StripContact::change_bump(const StripScene& scene, BridgedGap& gap, StripState& state, double from, double to,
                               int steps) {
  for (int step = 1; step <= steps; ++step) {
    gap.height = (from + (to - from) * step / steps) * gap.neck.wall;
    if (finder_.solver().solve(scene, state, StripStart::solution).status != StripStatus::solved) return false;
  }
  return true;
}

bool StripContact::bridge(const StripScene& scene, const Rectangle& box, StripCounts counts, StripSolution& solution,
                          bool warm, bool patient) {
  BridgedGap gap;
  gap.gap = scene.gap;
  gap.neck = solution.neck;
  StripScene other = scene;
  other.gap = &gap;
  const double wall = solution.neck.wall;
  const auto find_at = [&](double height, StripState& state, bool near) {
    gap.height = height * wall;
    return finder_.find(other, box, counts, state, near, patient).status == StripStatus::solved;
  };
  const auto find = [&](std::size_t i, bool near) { return find_at(heights[i], solution.neighbour[i], near); };
  const auto reach = [&](std::size_t i, std::size_t from, int steps) {
    solution.neighbour[i] = solution.neighbour[from];
    return change_bump(other, gap, solution.neighbour[i], heights[from], heights[i], steps);
  };
  // Necks that are filled up or dug out more are found more easily.
  const auto find_beyond = [&](std::size_t i) {
    for (const double more : heights[i] < 0 ? std::array{2.0, 4.0} : std::array{1.4, 2.0})
      if (find_at(more * heights[i], solution.neighbour[i], false) &&
          change_bump(other, gap, solution.neighbour[i], more * heights[i], heights[i], 10))
        return true;
    return false;
  };
  // One neighbour of either sign is found by itself, the other one from it.
  constexpr int steps = 5;
  for (const auto& [far, near] : {std::pair<std::size_t, std::size_t>{0, 1}, {3, 2}}) {
    const bool first = find(far, warm) || ((far == 0 || patient) && find_beyond(far)), both = warm && find(near, true);
    if (both && first) continue;
    if (first ? reach(near, far, 1) || reach(near, far, steps) || find(near, false)
              : (both || find(near, false)) && (reach(far, near, 1) || reach(far, near, steps)))
      continue;
    return false;
  }
  return true;
}

StripReport StripContact::solve(const StripScene& scene, const Rectangle& box, StripCounts counts,
                                StripSolution& solution, bool warm, bool patient) {
  const BlasThreads blas(1);  // several are slower for systems of this size
  if (warm && solution.share < 1 && solve_near_neck(scene, box, counts, solution, patient)) return {};
  StripReport report = finder_.find(scene, box, counts, solution.strips, warm && solution.share > 0, false);
  const auto ended = [&] {
    return report.status == StripStatus::no_contact || report.status == StripStatus::beyond_friction;
  };
  if (ended()) return report;
  if (report.status != StripStatus::solved && finder_.scattered()) return {StripStatus::unfit};
  // Necks explain most starts that lead nowhere; where there is none, all others are tried.
  bool necked = find_neck(scene, report, solution);
  if (report.status != StripStatus::solved && !necked && patient) {
    report = finder_.find(scene, box, counts, solution.strips, false);
    if (ended()) return report;
    necked = find_neck(scene, report, solution);
  }
  if (solution.share == 1) return report;
  if (necked && bridge(scene, box, counts, solution, false, patient)) {
    if (solution.share == 0) start_from_neighbours(scene, solution);
    return {};
  }
  if (!patient) return {StripStatus::unfit};
  if (report.status != StripStatus::solved) report = finder_.find(scene, box, counts, solution.strips, false);
  solution.share = 1;
  return report;
}

// Goes on from a solution with a neck: no other start is tried. Returns false where that leads nowhere, or past necks.
bool StripContact::solve_near_neck(const StripScene& scene, const Rectangle& box, StripCounts counts,
                                   StripSolution& solution, bool patient) {
  Vec2 first, second;
  if (!halves(solution.neighbour[1], first, second) && !halves(solution.neighbour[2], first, second)) return false;
  solution.neck = neck_between(*scene.gap, first, second);
  if (!(solution.neck.wall > 0 && bridge(scene, box, counts, solution, true, patient))) return false;
  if (solution.share > 0) {
    const bool found =
        finder_.solver().solve(scene, solution.strips, StripStart::solution).status == StripStatus::solved;
    solution.share = found ? trust(solution.strips).share() : 0;
  }
  if (solution.share == 0) start_from_neighbours(scene, solution);
  return solution.share < 1;
}

// Strips that are not found from the probe may be from the neighbours.
void StripContact::start_from_neighbours(const StripScene& scene, StripSolution& solution) {
  BridgedGap gap;
  gap.gap = scene.gap;
  gap.neck = solution.neck;
  StripScene other = scene;
  other.gap = &gap;
  for (const int steps : {1, 5})
    for (const std::size_t i : {1, 2}) {
      solution.strips = solution.neighbour[i];
      if (change_bump(other, gap, solution.strips, heights[i], 0, steps))
        solution.share = trust(solution.strips).share();
      if (solution.share > 0) return;
    }
}

// Finds the weight of the strips, and the neck if they are not all. Returns false where there is none.
bool StripContact::find_neck(const StripScene& scene, const StripReport& report, StripSolution& solution) const {
  const bool solved = report.status == StripStatus::solved;
  solution.share = solved ? trust(solution.strips).share() : 0;
  if (solution.share == 1) return false;
  // Halves of the contact come from the strips or from the probe.
  Vec2 first, second;
  const bool found = solved ? halves(solution.strips, first, second) : finder_.probe().halves(first, second);
  solution.neck = found ? neck_between(*scene.gap, first, second) : Neck{};
  return solution.neck.wall > 0;
}

StripTotals StripContact::totals(const StripSolution& solution) {
  StripTotals total;
  if (solution.share > 0) add(total, solution.share, StripSolver::totals(solution.strips));
  if (solution.share < 1)
    for (std::size_t i = 0; i < solution.neighbour.size(); ++i)
      add(total, (1 - solution.share) * weights[i], StripSolver::totals(solution.neighbour[i]));
  return total;
}

bool StripContact::rates(const StripScene& scene, const StripSolution& solution,
                         std::span<const StripParameter> parameter, std::span<StripTotals> rate) {
  StripSolver& solver = finder_.solver();
  if (solution.share == 1) return finder_.rates(scene, solution.strips, parameter, rate);
  std::fill(rate.begin(), rate.end(), StripTotals{});
  part_rates_.resize(parameter.size());
  BridgedGap gap;
  gap.gap = scene.gap;
  gap.neck = solution.neck;
  StripScene other = scene;
  other.gap = &gap;
  StripTotals bridged;
  std::vector<NeckRate> moving(parameter.size());
  for (std::size_t k = 0; k < parameter.size(); ++k)
    if (parameter[k].gap) moving[k].set(scene, *parameter[k].gap, solution);
  std::vector<StripParameter> with_neck(parameter.begin(), parameter.end());
  for (std::size_t i = 0; i < solution.neighbour.size(); ++i) {
    gap.height = heights[i] * solution.neck.wall;
    for (std::size_t k = 0; k < parameter.size(); ++k)
      if (parameter[k].gap) with_neck[k].gap = &moving[k].of(heights[i]);
    if (!solver.rates(other, solution.neighbour[i], with_neck, part_rates_)) return false;
    for (std::size_t k = 0; k < parameter.size(); ++k) add(rate[k], (1 - solution.share) * weights[i], part_rates_[k]);
    add(bridged, weights[i], StripSolver::totals(solution.neighbour[i]));
  }
  if (!(solution.share > 0)) return true;
  share_rates_.resize(parameter.size());
  if (!solver.rates(scene, solution.strips, parameter, part_rates_, share_rates_)) return false;
  const StripTotals strips = StripSolver::totals(solution.strips);
  for (std::size_t k = 0; k < parameter.size(); ++k) {
    add(rate[k], solution.share, part_rates_[k]);
    add(rate[k], share_rates_[k], strips);
    add(rate[k], -share_rates_[k], bridged);
  }
  return true;
}

}  // namespace rollcon::strips
