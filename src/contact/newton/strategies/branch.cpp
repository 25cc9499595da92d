/// Finds prescribed tangential loads from the outside: given motions converge where given forces get stuck, and there
/// are few of them. Damped steps by differences try the whole way at once. Then, and first of all under friction that
/// falls with the slip speed, the branch of solutions that begins with stick is followed while all loads change in
/// proportion, past the greatest loads on it.

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
constexpr double difference = 1e-3;    // fraction of the motions or of that creepage
constexpr double still = 1e-7;         // fraction of a load's terms: it did not change
constexpr double turned_back = 0.97;   // fraction of the greatest loads: these will not be reached again
constexpr double far = 100;            // multiple of that creepage: all nodes have been sliding for long
constexpr double certainly = 1e-3;     // fraction by which the greatest loads fall short of those wanted
constexpr double likely = 0.95;        // fraction of those wanted: so near it matters what exactly the greatest are
constexpr double longest = 4;          // length of a correction, over the motions or that creepage
constexpr double good = 0.3;           // factor on what the loads lack above which differences are taken anew
constexpr int most_steps = 100;
constexpr std::int64_t for_others = 40;  // iterations for other fallbacks

/// Holds the fraction of the loads, then up to three motions over those at which friction saturates.
using Point = std::array<double, 4>;
using Rows = std::array<Point, 4>;

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

double size_of(const Point& v) {
  return std::sqrt(dot(v, v));
}

double reach(const Point& v) {
  return std::max(1.0, std::hypot(v[1], v[2], v[3]));
}

/// Limits how a point is moved to the branch.
struct Limits {
  int corrections, halvings;
  std::int64_t iterations_left;
};

class LoadBranch {
 public:
  explicit LoadBranch(NewtonIteration& newton) : newton_(newton), s_(newton.solve()), given_(s_.given) {
    for (const int m : {xi1, xi2, spin}) {
      if (!given_.by_force[at(m)]) continue;
      given_.by_force[at(m)] = false;
      motion_[count_] = at(m);
      unit_[count_] = m == spin ? 1 / s_.problem->length : 1;
      target_[count_] = given_.value[at(m)] * unit_[count_];
      ++count_;
    }
  }
  Outcome run();

 private:
  struct State {
    std::vector<double> lambda[3];
    MotionValues motion{};
  };

  State state() const;
  void go_back(const State& state);
  bool lack(const Point& point, Point& lacks);
  bool find_slope(const Point& point, const Point& lacks);
  bool find_direction(Point& direction) const;
  bool correct(Point& point, const Point& direction, const Limits& limits);
  double slip_of_others() const;
  bool begin(Point& point);
  bool begin_at_rest(Point& point);
  Outcome finish(const Point& before, const Point& after, double part);
  Outcome follow(Point point);
  bool all_slide();
  void refuse(double greatest);

  NewtonIteration& newton_;
  Solve& s_;
  Prescribed given_;
  std::array<std::size_t, 3> motion_{};
  std::size_t count_ = 0;
  std::array<double, 3> unit_{}, start_{}, target_{};
  double scale_ = 1;  ///< creepage at which friction saturates
  double size_ = 1;   ///< size of the change of the loads
  double terms_ = 0;  ///< size of the loads' terms, over that
  Rows slope_{};
  State kept_;  ///< where lack() goes back to; empty: nowhere
  Outcome outcome_ = Outcome::converged;
};

LoadBranch::State LoadBranch::state() const {
  const Iterate& it = *s_.iterate;
  return {{it.lambda[0], it.lambda[1], it.lambda[2]}, it.motion};
}

void LoadBranch::go_back(const State& state) {
  Iterate& it = *s_.iterate;
  for (int c = 0; c < 3; ++c) it.lambda[c] = state.lambda[c];
  it.motion = state.motion;
  it.invalidate();
}

// Finds the loads at a point beyond their fraction of those wanted, over the change of the loads. A motion that is too
// far counts as bad as can be, and the tractions go back. Returns false if nothing leads on.
bool LoadBranch::lack(const Point& point, Point& lacks) {
  Iterate& it = *s_.iterate;
  for (std::size_t i = 0; i < count_; ++i)
    given_.value[motion_[i]] = it.motion[motion_[i]] = point[1 + i] * scale_ * unit_[i];
  outcome_ =
      newton_.run(s_.goal, given_, {.tolerance = std::max(s_.tolerance, rough), .free_steps = 1, .rehearsal = true});
  lacks = {};
  if (outcome_ == Outcome::not_converged && !kept_.lambda[0].empty() && s_.iterations_left > 0) {
    go_back(kept_);
    outcome_ = Outcome::converged;
    lacks[0] = INFINITY;
    return true;
  }
  if (outcome_ != Outcome::converged) return false;
  terms_ = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const LoadSum load = load_on_body1(*s_.problem, static_cast<int>(motion_[i]), it.lambda);
    lacks[i] = (load.value * unit_[i] - start_[i] - point[0] * (target_[i] - start_[i])) / size_;
    terms_ = std::max(terms_, load.magnitude * unit_[i] / size_);
  }
  return std::isfinite(size_of(lacks));
}

// Takes differences, wider ones where all nodes slide and small ones change nothing.
bool LoadBranch::find_slope(const Point& point, const Point& lacks) {
  for (std::size_t r = 0; r < count_; ++r) slope_[r][0] = -(target_[r] - start_[r]) / size_;
  for (std::size_t c = 1; c <= count_; ++c)
    for (double width = difference * reach(point), change = 0; !(change > still * terms_); width *= 32) {
      Point beside = point, there{};
      beside[c] += width;
      if (!(width < far * reach(point)) || !lack(beside, there) || !std::isfinite(there[0])) return false;
      change = 0;
      for (std::size_t r = 0; r < count_; ++r) {
        slope_[r][c] = (there[r] - lacks[r]) / (beside[c] - point[c]);
        change = std::max(change, std::abs(there[r] - lacks[r]));
      }
    }
  return true;
}

// Finds the direction along the branch, on from the last direction; of length 1.
bool LoadBranch::find_direction(Point& direction) const {
  Rows rows = slope_;
  Point side{}, next{};
  rows[count_] = direction;
  side[count_] = 1;
  if (!solve_small(count_ + 1, rows, side, next)) return false;
  const double length = size_of(next);
  for (std::size_t i = 0; i < 4; ++i) direction[i] = next[i] / length;
  return std::isfinite(length);
}

// Moves a point to the branch, across the direction.
bool LoadBranch::correct(Point& point, const Point& direction, const Limits& limits) {
  Point lacks{};
  if (!lack(point, lacks)) return false;
  bool fresh = false;
  for (int k = 0;; ++k) {
    const double before = size_of(lacks);
    if (before <= close_enough * std::max(1.0, terms_)) return true;
    if (!std::isfinite(before) || k == limits.corrections || s_.iterations_left <= limits.iterations_left) return false;
    kept_ = state();
    Rows rows = slope_;
    Point side{}, x{}, next{}, after{};
    for (std::size_t r = 0; r < count_; ++r) side[r] = -lacks[r];
    rows[count_] = direction;
    if (!solve_small(count_ + 1, rows, side, x)) return false;
    double part = std::min(1.0, longest * reach(point) / size_of(x));
    bool better = false;
    for (int halving = 0; !better && halving <= limits.halvings; ++halving) {
      if (halving > 0) part /= 2;
      for (std::size_t i = 0; i < 4; ++i) next[i] = point[i] + part * x[i];
      if (!lack(next, after)) return false;
      better = size_of(after) < (1 - 0.1 * part) * before;
    }
    if (better) {
      // Broyden's update changes the motions' columns: the loads' is exact.
      const double square = part * (x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
      for (std::size_t r = 0; r < count_ && square > 0; ++r)
        for (std::size_t c = 1; c <= count_; ++c) slope_[r][c] += (after[r] - (1 - part) * lacks[r]) * x[c] / square;
      point = next;
      lacks = after;
      fresh = false;
      if (size_of(lacks) <= good * before) continue;
    } else {
      if (fresh) return false;
      go_back(kept_);
    }
    if (!find_slope(point, lacks)) return false;
    fresh = true;
  }
}

// Returns the greatest slip of the motions that are given from the first, as a creepage: more of the others than that
// turns it.
double LoadBranch::slip_of_others() const {
  const Problem& p = *s_.problem;
  MotionValues others = given_.value;
  for (std::size_t i = 0; i < count_; ++i) others[motion_[i]] = 0;
  double slip = 0;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    const auto i = static_cast<std::int64_t>(k);
    if (s_.iterate->lambda[2][k] < 0)
      slip = std::max(slip, std::hypot(p.rigid_slip1(i, others), p.rigid_slip2(i, others)));
  }
  return slip / p.motion_scale;
}

// Begins at motions, from the tractions at hand: the loads there are the first.
bool LoadBranch::begin(Point& point) {
  Point lacks{};
  start_ = {};
  size_ = scale_ = 1;
  kept_ = {};
  if (!lack(point, lacks)) return false;
  scale_ = std::max(creep_scale(*s_.problem, given_, *s_.iterate, xi1), slip_of_others());
  if (!(scale_ > 0) || !std::isfinite(scale_)) return false;
  for (std::size_t i = 0; i < count_; ++i) start_[i] = lacks[i], point[1 + i] /= scale_;
  size_ = std::hypot(target_[0] - start_[0], target_[1] - start_[1], target_[2] - start_[2]);
  return size_ > 0 && size_of(point) < far && find_slope(point, {});
}

bool LoadBranch::begin_at_rest(Point& point) {
  point = {};
  for (std::size_t i = 0; i < count_; ++i) given_.value[motion_[i]] = 0;
  outcome_ = fall_from_rest(newton_, given_, {.tolerance = std::max(s_.tolerance, rough), .rehearsal = true});
  return outcome_ == Outcome::converged && begin(point);
}

// Solves where the loads are met, so far on the way from one point to the next.
Outcome LoadBranch::finish(const Point& before, const Point& after, double part) {
  for (std::size_t i = 0; i < count_; ++i)
    s_.iterate->motion[motion_[i]] = scale_ * unit_[i] * (before[1 + i] + part * (after[1 + i] - before[1 + i]));
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
  double asked = 0, carried = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (target_[i] == 0) continue;
    (motion_[i] == spin ? share.by_moment : share.by_force) = true;
    asked += target_[i] * target_[i];
    carried += target_[i] * (start_[i] + greatest * (target_[i] - start_[i]));
  }
  share.before_fall = true;
  share.sliding = share.together = carried > 0 ? asked / carried : INFINITY;
}

Outcome LoadBranch::run() {
  Point point{};
  const auto stuck = [&] { return outcome_ == Outcome::converged ? Outcome::not_converged : outcome_; };
  if (!s_.problem->law->falls()) {
    const std::int64_t half = s_.iterations_left / 2;
    for (std::size_t i = 0; i < count_; ++i) point[1 + i] = s_.iterate->motion[motion_[i]] / unit_[i];
    if (begin(point) || (stuck() == Outcome::not_converged && begin_at_rest(point))) {
      point[0] = 1;
      correct(point, {1, 0, 0, 0}, {60, 8, half});
      // Newton's step may take over from where the search came to a halt, too.
      if (outcome_ == Outcome::converged) outcome_ = finish(point, point, 1);
      if (outcome_ == Outcome::converged) return outcome_;
    }
    if (stuck() != Outcome::not_converged) return outcome_;
  }
  return begin_at_rest(point) ? follow(point) : stuck();
}

Outcome LoadBranch::follow(Point point) {
  Point direction{1, 0, 0, 0};
  if (!find_direction(direction)) return Outcome::not_converged;
  double step = first_step, greatest = 0;
  for (int k = 0; k < most_steps && s_.iterations_left > for_others; ++k) {
    const State before = kept_ = state();
    const Rows slope = slope_;
    Point next = point, onward = direction;
    for (std::size_t i = 0; i < 4; ++i) next[i] += step * direction[i];
    const bool found =
        correct(next, direction, {6, 1, for_others}) && find_direction(onward) && dot(onward, direction) >= 0.5;
    // A parabola finds the greatest loads between two points, where they rise no more.
    const bool over = found && next[0] < 1 && direction[0] > 0 && onward[0] < 0;
    const double there = over ? direction[0] / (direction[0] - onward[0]) : 0;
    const double peak = over ? point[0] + 0.5 * step * direction[0] * there : 0;
    // Where the branch has a kink instead, they are below where its tangents meet.
    const double meet = (next[0] - point[0] - step * onward[0]) / (direction[0] - onward[0]);
    const double most = point[0] + direction[0] * meet;
    const bool vague = over && peak > likely && most - std::max(point[0], next[0]) > certainly;
    if (!found || (vague && step > 10 * least_step)) {
      if (outcome_ != Outcome::converged && outcome_ != Outcome::not_converged) return outcome_;
      step *= 0.4;
      if (step < least_step) return Outcome::not_converged;
      go_back(before);
      slope_ = slope;
      continue;
    }
    if (next[0] >= 1) return finish(point, next, (1 - point[0]) / (next[0] - point[0]));
    if (peak > 1 - certainly) return finish(point, next, there);
    greatest = std::max({greatest, next[0], peak});
    const double rise = next[0] - point[0];
    point = next;
    direction = onward;
    if (size_of(point) > far || (point[0] < turned_back * greatest && all_slide())) {
      // Loads that have hardly changed since the start say nothing, and those that still rise may be reached.
      const bool known = greatest > certainly && greatest < 1 - certainly && rise < certainly;
      if (!s_.problem->law->falls() || !known) return Outcome::not_converged;
      refuse(greatest);
      return Outcome::no_solution;
    }
    step = std::min(1.6 * step, 0.4 * std::max(1.0, size_of(point)));
  }
  return Outcome::not_converged;
}

}  // namespace

Outcome follow_loads(NewtonIteration& newton) {
  newton.return_to_best();
  return LoadBranch(newton).run();
}

}  // namespace rollcon
