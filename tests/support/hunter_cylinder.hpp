#pragma once
/// Provides the closed form of a rigid cylinder that rolls without friction on a half-plane of one relaxation time
/// (Hunter 1961), by quadrature of its integrals.
///
/// With p the pressure, f the creep ratio and L the distance rolled in a creep time, q = (1 + f) p - L p' is the
/// pressure on an elastic half-plane of the glassy modulus under the parabola of a cylinder shifted by L: a quadratic
/// polynomial over the root of the distances from both edges. The edges follow from p = 0 at the trailing one, and from
/// the slope of the surface at the leading one, which is what the surface ahead of it leaves.

#include <array>
#include <cmath>
#include <numbers>

#include "mesh/quadrature.hpp"

namespace rollcon {

class HunterCylinder {
 public:
  /// Takes the load per length, the glassy E*, the radius, the creep ratio and the creep time times the speed.
  HunterCylinder(double load, double modulus, double radius, double ratio, double length)
      : load_(load), modulus_(modulus), radius_(radius), ratio_(ratio), length_(length), half_(0), middle_(0) {
    half_ = std::sqrt(4 * load * radius * (1 + ratio / 2) / (std::numbers::pi * modulus));
    middle_ = 0.1 * half_;
    for (int i = 0; i < 60; ++i) {
      const std::array<double, 2> r = residual();
      const double step = 1e-6 * half_;
      half_ += step;
      const std::array<double, 2> by_half = residual();
      half_ -= step, middle_ += step;
      const std::array<double, 2> by_middle = residual();
      middle_ -= step;
      const double a = (by_half[0] - r[0]) / step, b = (by_middle[0] - r[0]) / step, c = (by_half[1] - r[1]) / step,
                   d = (by_middle[1] - r[1]) / step, det = a * d - b * c;
      double dh = -(d * r[0] - b * r[1]) / det, dm = -(a * r[1] - c * r[0]) / det;
      const double most = 0.2 * half_ / std::max(std::hypot(dh, dm), 1e-300);
      if (most < 1) dh *= most, dm *= most;
      half_ += dh, middle_ += dm;
      if (std::hypot(dh, dm) < 1e-12 * half_) break;
    }
  }
  double leading_edge() const { return middle_ + half_; }
  double trailing_edge() const { return middle_ - half_; }
  double pressure(double x) const {
    const double t = x - middle_;
    if (!(std::abs(t) < half_)) return 0;
    const double from = std::asin(t / half_), to = std::numbers::pi / 2;
    return panels(from, to, [&](double angle) {
      const double at = half_ * std::sin(angle);
      return std::exp(-(1 + ratio_) * (at - t) / length_) / length_ * polynomial(at);
    });
  }
  double largest_pressure() const {
    double largest = 0;
    for (double s = -0.999; s < 1; s += 0.001) largest = std::max(largest, pressure(middle_ + s * half_));
    return largest;
  }
  /// Returns the moment of the pressure about the cylinder's middle, per length.
  double moment() const {
    return panels(0, std::numbers::pi, [&](double angle) {
      const double x = middle_ + half_ * std::cos(angle);
      return pressure(x) * x * half_ * std::sin(angle);
    });
  }

 private:
  template <class F>
  static double panels(double from, double to, const F& f) {
    static const LineRule rule = gauss_legendre(20);
    constexpr int count = 40;
    double sum = 0;
    for (int k = 0; k < count; ++k) {
      const double h = (to - from) / count, low = from + k * h;
      for (std::size_t q = 0; q < rule.x.size(); ++q) sum += 0.5 * h * rule.w[q] * f(low + 0.5 * h * (1 + rule.x[q]));
    }
    return sum;
  }
  /// Returns the polynomial of q at t from the middle.
  double polynomial(double t) const {
    const double unit = -modulus_ / (2 * radius_);
    const double constant = (1 + ratio_) * load_ / std::numbers::pi - unit * half_ * half_ / 2;
    return unit * t * t + unit * (middle_ - length_) * t + constant;
  }
  std::array<double, 2> residual() const {
    const double pi = std::numbers::pi, unit = -modulus_ / (2 * radius_);
    const double trailing = panels(-pi / 2, pi / 2, [&](double angle) {
      const double at = half_ * std::sin(angle);
      return std::exp(-(1 + ratio_) * (at + half_) / length_) * polynomial(at);
    });
    const double furthest = std::acosh(1 + 45 * length_ / half_);
    const double ahead = panels(0, furthest, [&](double u) {
      const double t = half_ * std::cosh(u), root = half_ * std::sinh(u);
      return std::exp(-(t - half_) / length_) / length_ *
             (polynomial(t) - (unit * t + unit * (middle_ - length_)) * root);
    });
    return {trailing, -2 / modulus_ * ahead + (middle_ + half_) / radius_};
  }

  double load_, modulus_, radius_, ratio_, length_, half_, middle_;
};

}  // namespace rollcon
