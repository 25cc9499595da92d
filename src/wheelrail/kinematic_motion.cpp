#include "wheelrail/kinematic_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/error.hpp"

namespace rollcon {
namespace {

/// Holds the difference on one side of the middle, in panels outwards, linear over each; its integral is the potential
/// of the motion.
class Slope {
 public:
  struct Point {
    double y, d, potential;
  };

  /// Begins at the middle; sign: that of the direction.
  Slope(const std::function<double(double)>& difference, double middle, double sign, double amplitude)
      : difference_(difference), sign_(sign), amplitude_(amplitude) {
    point_.push_back({middle, difference(middle), 0});
  }

  double reached() const { return std::abs(point_.back().y - point_.front().y); }
  double greatest() const { return greatest_; }

  /// Adds one more panel, divided where the difference is not linear.
  void extend() {
    constexpr int panels = 64;
    const double y = point_.front().y + sign_ * amplitude_ / panels * (1 + static_cast<double>(panels_++));
    add(y, difference_(y), 0);
  }

  /// Tells where the potential reaches this energy first, and the time to there from the middle, at unit e r.
  struct Turn {
    double y, time;
  };
  Turn turn_at(double energy) const {
    double time = 0, before = std::sqrt(2 * energy);
    for (std::size_t i = 0; i + 1 < point_.size(); ++i) {
      const Point &a = point_[i], &b = point_[i + 1];
      const double stiffness = (b.d - a.d) / (b.y - a.y);
      const double left = energy - b.potential;
      if (left > 0) {
        const double after = std::sqrt(2 * left);
        time += time_of(stiffness, std::abs(b.y - a.y), before + after);
        before = after;
        continue;
      }
      const double force = sign_ * a.d;  // force back to the middle
      const double root = std::sqrt(std::max(force * force + 2 * stiffness * (energy - a.potential), 0.0));
      const double way = std::min(2 * (energy - a.potential) / (force + root), std::abs(b.y - a.y));
      return {a.y + sign_ * way, time + time_of(stiffness, way, before)};
    }
    return {point_.back().y, time};
  }

 private:
  /// Returns the time over a way on which the restoring force grows linearly, from the sum of the speeds at both ends.
  static double time_of(double stiffness, double way, double speeds) {
    if (!(way > 0)) return 0;
    const double t = way / speeds, x = std::abs(stiffness) * t * t;
    constexpr double little = 1e-8;
    if (x < little) return 2 * t * (1 - stiffness * t * t / 3);
    const double root = std::sqrt(std::abs(stiffness));
    return 2 / root * (stiffness > 0 ? std::atan(root * t) : std::atanh(std::min(root * t, 1 - 1e-15)));
  }
  void add(double y, double d, int depth) {
    constexpr int deepest = 18;
    constexpr double linear = 3e-5;
    const Point& a = point_.back();
    const double middle = 0.5 * (a.y + y);
    if (depth < deepest) {
      const double between = difference_(middle), scale = std::max({std::abs(a.d), std::abs(d), std::abs(between)});
      if (depth == 0 || std::abs(between - 0.5 * (a.d + d)) > linear * scale) {
        add(middle, between, depth + 1);
        add(y, d, depth + 1);
        return;
      }
    }
    point_.push_back({y, d, a.potential + 0.5 * (a.d + d) * (y - a.y)});
    greatest_ = std::max(greatest_, point_.back().potential);
  }

  const std::function<double(double)>& difference_;
  double sign_, amplitude_, greatest_ = 0;
  int panels_ = 0;
  std::vector<Point> point_;
};

/// Finds where the difference vanishes, near 0, negative on its left.
double find_middle(const std::function<double(double)>& difference, double amplitude) {
  constexpr double far = 4, step = 1.0 / 32, rounding = 1e-12;
  const double first = difference(0);
  if (std::abs(first) <= rounding * amplitude) return 0;
  const double direction = first > 0 ? -1 : 1;
  double inner = 0, outer = 0;
  do {
    inner = outer;
    outer += direction * step * amplitude;
    if (std::abs(outer) > far * amplitude)
      fail(Status::err_argument,
           "the rolling-radius difference is %g with the wheelset in the middle, and keeps its sign up to y = %g: the "
           "wheelset never runs straight on",
           first, outer);
  } while (difference(outer) * first > 0);
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double y = 0.5 * (inner + outer);
    (difference(y) * first > 0 ? inner : outer) = y;
  }
  return 0.5 * (inner + outer);
}

}  // namespace

double KinematicMotion::wavelength() const {
  return 2 * std::numbers::pi / std::sqrt(2 * conicity);
}

KinematicMotion kinematic_motion(const std::function<double(double)>& difference, double amplitude) {
  KinematicMotion motion;
  motion.middle = find_middle(difference, amplitude);
  std::array<Slope, 2> side{Slope(difference, motion.middle, -1, amplitude),
                            Slope(difference, motion.middle, 1, amplitude)};
  const auto width = [&](double energy) { return side[1].turn_at(energy).y - side[0].turn_at(energy).y; };
  const auto least = [&] { return std::min(side[0].greatest(), side[1].greatest()); };
  constexpr double farthest = 4;
  while (!(least() > 0 && width(least()) >= 2 * amplitude)) {
    Slope& weaker = side[0].greatest() < side[1].greatest() ? side[0] : side[1];
    if (weaker.reached() > farthest * amplitude)
      fail(Status::err_argument,
           "amplitude is %g; allowed: such that the rolling-radius difference brings the wheelset back, which it does "
           "not from y = %g on",
           amplitude, motion.middle + (&weaker == side.data() ? -1 : 1) * weaker.reached());
    weaker.extend();
  }
  double low = 0, high = least();
  constexpr int halvings = 100;
  for (int i = 0; i < halvings && low < high; ++i) {
    const double energy = 0.5 * (low + high);
    (width(energy) < 2 * amplitude ? low : high) = energy;
  }
  const Slope::Turn left = side[0].turn_at(high), right = side[1].turn_at(high);
  motion.low = left.y;
  motion.high = right.y;
  const double half_period = left.time + right.time;
  motion.conicity = std::numbers::pi * std::numbers::pi / (2 * half_period * half_period);
  return motion;
}

}  // namespace rollcon
