/// Follows, for several tangential loads under friction that falls with the slip speed, the branch of solutions that
/// begins with stick while all loads grow in proportion. It turns back where they are greatest.

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/newton/start.hpp"
#include "contact/newton/strategies/strategies.hpp"
#include "support/index.hpp"
#include "support/small_system.hpp"

namespace rollcon {
namespace {

constexpr double first_step = 0.05;  // fraction of the creepage at which friction saturates
constexpr double least_step = 1e-4;
constexpr double close_enough = 1e-4;  // fraction of the loads
constexpr double rough = 1e-6;         // tolerance of the solves on the way
constexpr double difference = 1e-3;    // fraction of that creepage
constexpr double turned_back = 0.97;   // fraction of the greatest loads: these will not be reached again
constexpr double far = 100;            // multiple of that creepage: all nodes have been sliding for long
constexpr double certainly = 1e-3;     // fraction by which the greatest loads fall short of those wanted
constexpr double likely = 0.95;        // fraction of those wanted: so near it matters what exactly the greatest are
constexpr int most_corrections = 6, most_steps = 100;
constexpr std::int64_t for_others = 40;  // iterations for other fallbacks

/// Holds up to three motions, over those at which friction saturates, then the fraction of the loads.
using Point = std::array<double, 4>;
using Rows = std::array<Point, 4>;

class LoadBranch {
 public:
  LoadBranch(NewtonIteration& newton, double scale) : newton_(newton), s_(newton.solve()), given_(s_.given) {
    const double length = s_.problem->length;
    for (const int m : {xi1, xi2, spin}) {
      if (!given_.by_force[at(m)]) continue;
      motion_[count_] = m;
      unit_[count_] = m == spin ? scale / length : scale;
      per_load_[count_] = m == spin ? 1 / length : 1;
      target_[count_] = given_.value[at(m)] * per_load_[count_];
      ++count_;
    }
    size_ = std::hypot(target_[0], target_[1], target_[2]);
  }
  std::size_t loads() const { return size_ > 0 ? count_ : 0; }
  Outcome run();

 private:
  bool lack(const Point& point, Point& lacks);
  bool find_slope(const Point& point, const Point& lacks);
  bool find_direction(Point& direction);
  bool correct(Point& point, const Point& direction);
  bool begin(Point& point);
  Outcome finish(const Point& before, const Point& after, double part);
  bool all_slide();
  void refuse(double greatest);

  NewtonIteration& newton_;
  Solve& s_;
  Prescribed given_;
  std::array<int, 3> motion_{};
  std::size_t count_ = 0;
  std::array<double, 3> unit_{}, per_load_{}, target_{};
  double size_ = 0;
  Rows slope_{};
  std::vector<double> kept_[3];
  MotionValues kept_motion_{};
  Outcome outcome_ = Outcome::converged;
};

// Finds the loads at a point beyond their fraction of those wanted, over these; false: no solution was found.
bool LoadBranch::lack(const Point& point, Point& lacks) {
  Iterate& it = *s_.iterate;
  for (std::size_t i = 0; i < count_; ++i) {
    given_.by_force[at(motion_[i])] = false;
    given_.value[at(motion_[i])] = it.motion[at(motion_[i])] = point[i] * unit_[i];
  }
  outcome_ =
      newton_.run(s_.goal, given_, {.tolerance = std::max(s_.tolerance, rough), .free_steps = 1, .rehearsal = true});
  if (outcome_ != Outcome::converged) return false;
  lacks = {};
  for (std::size_t i = 0; i < count_; ++i) {
    const double load = load_on_body1(*s_.problem, motion_[i], it.lambda).value * per_load_[i];
    lacks[i] = (load - point[3] * target_[i]) / size_;
    if (!std::isfinite(lacks[i])) return false;
  }
  return true;
}

bool LoadBranch::find_slope(const Point& point, const Point& lacks) {
  for (std::size_t c = 0; c < count_; ++c) {
    Point beside = point, there{};
    beside[c] += difference * std::max(1.0, std::abs(point[c]));
    if (!lack(beside, there)) return false;
    for (std::size_t r = 0; r < count_; ++r) slope_[r][c] = (there[r] - lacks[r]) / (beside[c] - point[c]);
  }
  for (std::size_t r = 0; r < count_; ++r) slope_[r][count_] = -target_[r] / size_;
  return true;
}

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// Finds the direction along the branch, on from the last direction; of length 1.
bool LoadBranch::find_direction(Point& direction) {
  Rows rows = slope_;
  Point side{}, x{}, next{};
  for (std::size_t i = 0; i < count_; ++i) rows[count_][i] = direction[i];
  rows[count_][count_] = direction[3];
  side[count_] = 1;
  if (!solve_small(count_ + 1, rows, side, x)) return false;
  for (std::size_t i = 0; i < count_; ++i) next[i] = x[i];
  next[3] = x[count_];
  const double length = std::sqrt(dot(next, next));
  for (std::size_t i = 0; i < 4; ++i) direction[i] = next[i] / length;
  return std::isfinite(length);
}

// Moves a point to the branch, across the direction.
bool LoadBranch::correct(Point& point, const Point& direction) {
  Point lacks{}, after{};
  if (!lack(point, lacks)) return false;
  bool fresh = false;
  for (int k = 0; k < most_corrections && s_.iterations_left > 0; ++k) {
    const double before = std::sqrt(dot(lacks, lacks));
    if (before <= close_enough) return true;
    Rows rows = slope_;
    Point side{}, x{};
    for (std::size_t i = 0; i < count_; ++i) {
      side[i] = -lacks[i];
      rows[count_][i] = direction[i];
    }
    rows[count_][count_] = direction[3];
    if (!solve_small(count_ + 1, rows, side, x)) return false;
    Point next = point;
    for (std::size_t i = 0; i < count_; ++i) next[i] += x[i];
    next[3] += x[count_];
    if (!lack(next, after)) return false;
    // Broyden's update changes the motions' columns: the loads' is exact.
    double square = 0;
    for (std::size_t c = 0; c < count_; ++c) square += x[c] * x[c];
    if (square > 0)
      for (std::size_t r = 0; r < count_; ++r)
        for (std::size_t c = 0; c < count_; ++c) slope_[r][c] += after[r] * x[c] / square;
    point = next;
    lacks = after;
    const bool slow = std::sqrt(dot(lacks, lacks)) > 0.3 * before;
    if (slow && !fresh) {
      if (!find_slope(point, lacks)) return false;
      fresh = true;
    }
  }
  return std::sqrt(dot(lacks, lacks)) <= close_enough;
}

// Finds the point where the loads are none.
bool LoadBranch::begin(Point& point) {
  const Iterate& it = *s_.iterate;
  Prescribed none = s_.given;
  for (std::size_t i = 0; i < count_; ++i) none.value[at(motion_[i])] = 0;
  outcome_ = fall_from_rest(newton_, none, {.tolerance = std::max(s_.tolerance, rough), .rehearsal = true});
  if (outcome_ != Outcome::converged) return false;
  point = {};
  for (std::size_t i = 0; i < count_; ++i) point[i] = it.motion[at(motion_[i])] / unit_[i];
  return true;
}

// Solves where the loads are met, so far on the way from one point to the next.
Outcome LoadBranch::finish(const Point& before, const Point& after, double part) {
  for (std::size_t i = 0; i < count_; ++i)
    s_.iterate->motion[at(motion_[i])] = unit_[i] * (before[i] + part * (after[i] - before[i]));
  return newton_.run(s_.goal, s_.given, {.free_steps = 2});
}

// Says whether friction only falls from there on. Next to a pole of spin a node may always stick.
bool LoadBranch::all_slide() {
  const LawResidual r = newton_.judge(s_.goal, given_);
  return 20 * (r.contact - r.sliding) <= r.contact;
}

void LoadBranch::refuse(double greatest) {
  FrictionShare& share = s_.report.share;
  share = {};
  for (std::size_t i = 0; i < count_; ++i) {
    if (target_[i] == 0) continue;
    (motion_[i] == spin ? share.by_moment : share.by_force) = true;
  }
  share.before_fall = true;
  share.sliding = share.together = 1 / greatest;
}

Outcome LoadBranch::run() {
  Iterate& it = *s_.iterate;
  Point point{}, lacks{}, direction{0, 0, 0, 1};
  if (!begin(point) || !lack(point, lacks) || !find_slope(point, lacks) || !find_direction(direction)) return outcome_;
  double step = first_step, greatest = 0;
  for (int k = 0; k < most_steps && s_.iterations_left > for_others; ++k) {
    for (int c = 0; c < 3; ++c) kept_[c] = it.lambda[c];
    kept_motion_ = it.motion;
    const Rows slope = slope_;
    Point next = point, onward = direction;
    for (std::size_t i = 0; i < 4; ++i) next[i] += step * direction[i];
    const bool found = correct(next, direction) && find_direction(onward) && dot(onward, direction) >= 0.5;
    // A parabola finds the greatest loads between two points, where they rise no more.
    const bool over = found && next[3] < 1 && direction[3] > 0 && onward[3] < 0;
    const double there = over ? direction[3] / (direction[3] - onward[3]) : 0;
    const double peak = over ? point[3] + 0.5 * step * direction[3] * there : 0;
    const bool vague = over && peak > likely && peak - std::max(point[3], next[3]) > certainly;
    if (!found || (vague && step > 10 * least_step)) {
      if (outcome_ != Outcome::converged && outcome_ != Outcome::not_converged) return outcome_;
      step *= 0.4;
      if (step < least_step) return Outcome::not_converged;
      for (int c = 0; c < 3; ++c) it.lambda[c] = kept_[c];
      it.motion = kept_motion_;
      it.invalidate();
      slope_ = slope;
      continue;
    }
    if (next[3] >= 1) return finish(point, next, (1 - point[3]) / (next[3] - point[3]));
    if (peak > 1 - certainly) return finish(point, next, there);
    greatest = std::max({greatest, next[3], peak});
    point = next;
    direction = onward;
    if (dot(point, point) > far * far || (point[3] < turned_back * greatest && all_slide())) {
      if (!(greatest < 1 - certainly)) return Outcome::not_converged;
      refuse(greatest);
      return Outcome::no_solution;
    }
    step = std::min(1.6 * step, 0.4 * std::max(1.0, std::sqrt(dot(point, point))));
  }
  return Outcome::not_converged;
}

}  // namespace

Outcome follow_before_fall(NewtonIteration& newton) {
  const Solve& s = newton.solve();
  if (!s.given.tangential_load()) return Outcome::not_converged;
  newton.return_to_best();
  const double scale = creep_scale(*s.problem, s.given, *s.iterate, xi1);
  if (!(scale > 0) || !std::isfinite(scale)) return Outcome::not_converged;
  LoadBranch branch(newton, scale);
  return branch.loads() > 0 ? branch.run() : Outcome::not_converged;
}

}  // namespace rollcon
