#pragma once
/// Finds where a function of y and z vanishes along a profile.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/profile_curve.hpp"

namespace rollcon {

/// Finds the root of a function whose values at both ends differ in sign, by Newton's steps, halved where they leave
/// the bracket or shrink it too little.
template <class Value, class Slope>
double bracketed_root(double a, double b, double value_a, Value value, Slope slope) {
  const double smallest = 1e-16 * std::max(std::abs(a), std::abs(b));
  double u = (a + b) / 2, last = b - a;
  for (int i = 0; i < 200 && b - a > smallest; ++i) {
    const double f = value(u);
    if (f == 0) return u;
    ((f < 0) == (value_a < 0) ? a : b) = u;
    const double step = -f / slope(u), next = u + step;
    const bool good = next > a && next < b && std::abs(step) < last / 2;
    const double taken = good ? next : (a + b) / 2;
    last = std::abs(taken - u);
    u = taken;
    if (good && last <= smallest) break;
  }
  return u;
}

/// Calls visit(point, piece, parameter) at each crossing in the order of arc length, perhaps twice at those on a joint
/// of two intervals. Two crossings of one interval are found by the extremum between them. The function has f.value(x),
/// f.slope(x, d), its derivative in direction d, f.range(box), bounds of its values, and f.inside(x), which is positive
/// where it is defined.
template <class Function, class Visit>
class Crossings {
 public:
  Crossings(const ProfileCurve& curve, const Function& f, Visit& visit) : curve_(curve), f_(f), visit_(visit) {}

  void find() {
    const std::vector<ProfileInterval>& part = curve_.intervals();
    for (std::size_t k = 0; k < part.size(); ++k) {
      if (k % ProfileCurve::block == 0 && passed_by(part[k], curve_.blocks()[k / ProfileCurve::block]))
        k += ProfileCurve::block - 1;
      else if (!passed_by(part[k], part[k].box))
        look(part[k]);
    }
  }

 private:
  /// The function has one sign over the box, which begins with this interval.
  bool passed_by(const ProfileInterval& part, const ProfileBox& box) {
    const auto [low, high] = f_.range(box);
    const double side = low > 0 ? 1 : high < 0 ? -1 : 0;
    if (side == 0) return false;
    piece_ = part.piece;
    meet_joint(part.from, side);
    before_ = side;
    return true;
  }
  /// Pieces meet within rounding, or what a published profile was rounded to.
  void meet_joint(double u, double first) {
    if (before_ * first < 0 && f_.inside(at(u).x) > 0) meet(u);
  }
  ProfilePoint at(double u) const { return curve_.at(piece_, u); }
  double value(double u) const { return f_.value(at(u).x); }
  double slope(double u) const {
    const ProfilePoint p = at(u);
    return f_.slope(p.x, p.d1);
  }
  void meet(double u) { visit_(at(u), piece_, u); }
  void meet(double a, double b, double value_a) {
    meet(bracketed_root(
        a, b, value_a, [&](double u) { return value(u); }, [&](double u) { return slope(u); }));
  }

  void look(const ProfileInterval& part) {
    piece_ = part.piece;
    const bool from_inside = f_.inside(at(part.from).x) > 0, to_inside = f_.inside(at(part.to).x) > 0;
    double from = part.from, to = part.to;
    if (from_inside != to_inside) {
      double in = from_inside ? from : to, out = from_inside ? to : from;
      for (int i = 0; i < 60; ++i) (f_.inside(at((in + out) / 2).x) > 0 ? in : out) = (in + out) / 2;
      (from_inside ? to : from) = in;
    }
    const double first = value(from), last = value(to);
    meet_joint(part.from, first);
    before_ = to_inside ? last : 0;
    if (from_inside || to_inside) look_between(from, to, first, last);
  }

  void look_between(double from, double to, double first, double last) {
    if (first == 0) meet(from);
    if (first * last < 0) meet(from, to, first);
    const double sign = first > 0 ? 1 : -1;
    if (first * last > 0 && sign * slope(from) < 0 && sign * slope(to) > 0) {
      double a = from, b = to;
      for (int i = 0; i < 60 && sign * value((a + b) / 2) > 0; ++i)
        (sign * slope((a + b) / 2) < 0 ? a : b) = (a + b) / 2;
      const double middle = (a + b) / 2, turned = value(middle);
      if (turned == 0) meet(middle);
      if (sign * turned < 0) {
        meet(from, middle, first);
        meet(middle, to, turned);
      }
    }
    if (last == 0) meet(to);
  }

  const ProfileCurve& curve_;
  const Function& f_;
  Visit& visit_;
  std::size_t piece_ = 0;
  double before_ = 0;  ///< value at the end of the interval before, of which the sign counts; 0: unknown
};

template <class Function, class Visit>
void for_each_crossing(const ProfileCurve& curve, const Function& f, Visit visit) {
  Crossings<Function, Visit>(curve, f, visit).find();
}

}  // namespace rollcon
