#include "support/strip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace rollcon::scenes {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int quadrature_points = 64;

/// Integrates p(s) f(s) over |s| < a by Gauss-Chebyshev of the second kind.
template <class F>
double integrate_pressure(const closed_forms::HertzLine& h, F f) {
  double sum = 0;
  for (int k = 1; k <= quadrature_points; ++k) {
    const double angle = pi * k / (quadrature_points + 1);
    sum += std::sin(angle) * std::sin(angle) * f(h.a * std::cos(angle));
  }
  return sum * pi / (quadrature_points + 1) * h.a * h.p0;
}

/// Integrates p(s) ln|x - s| over |s| < a.
double log_potential(const closed_forms::HertzLine& h, double x) {
  const double t = std::abs(x) / h.a;
  double value = t * t - 0.5 - std::numbers::ln2 + std::log(h.a);
  if (t > 1) value += std::acosh(t) - t * std::sqrt(t * t - 1);
  return h.p0 * h.a * pi / 2 * value;
}

double trapezoid(const std::vector<double>& x, const std::vector<double>& f) {
  double sum = 0;
  for (std::size_t k = 1; k < x.size(); ++k) sum += 0.5 * (x[k] - x[k - 1]) * (f[k] + f[k - 1]);
  return sum;
}

}  // namespace

double Strip::displacement(double x, double y) const {
  // The inner integral along y is asinh(l/|t|) = ln(l + sqrt(l^2 + t^2)) - ln|t| on either side.
  double u = 0;
  for (double l : {half_length - y, half_length + y}) {
    if (l <= 0) continue;
    u += integrate_pressure(hertz, [&](double s) { return std::log(l + std::hypot(l, x - s)); }) -
         log_potential(hertz, x);
  }
  return u / (pi * hertz.e_star);
}

std::vector<double> Strip::gap(const std::vector<double>& x, const std::vector<double>& y) const {
  const double centre = approach();
  std::vector<double> h(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) h[k] = centre - displacement(x[k], y[k]) + hertz.gap(x[k]);
  return h;
}

std::vector<double> Strip::end_slip(const std::vector<double>& x, const std::vector<double>& y, double coupling) const {
  std::vector<double> c(2 * x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double above = half_length - y[k], below = half_length + y[k];
    double along = 0;
    for (double l : {above, below})
      along += l <= 0 ? pi * hertz.pressure(x[k])
                      : integrate_pressure(hertz, [&](double s) { return l / (l * l + (x[k] - s) * (x[k] - s)); });
    double across = 0;
    if (above > 0 && below > 0)
      across = integrate_pressure(hertz, [&](double s) {
        const double t = x[k] - s;
        return t / (below * below + t * t) - t / (above * above + t * t);
      });
    c[2 * k] = coupling * along;
    c[2 * k + 1] = -coupling * across;
  }
  return c;
}

std::vector<double> strip_lines(double half_length, double a) {
  std::vector<double> y = {0, 0.2 * half_length};
  for (double from_end : {3.5, 1.5, 0.5, 0.0}) y.push_back(half_length - from_end * a);
  std::vector<double> lines;
  for (std::size_t k = y.size(); k-- > 1;) lines.push_back(-y[k]);
  lines.insert(lines.end(), y.begin(), y.end());
  return lines;
}

double Section::load() const {
  return trapezoid(x, pressure);
}
double Section::force() const {
  return trapezoid(x, traction);
}
double Section::lateral_force() const {
  return trapezoid(x, lateral);
}

Section middle_section(const Solution& s) {
  const double extent = *std::max_element(s.y.begin(), s.y.end());
  std::vector<std::size_t> node;
  for (std::size_t k = 0; k < s.nodes(); ++k)
    if (std::abs(s.y[k]) < 1e-9 * extent) node.push_back(k);
  std::sort(node.begin(), node.end(), [&](auto i, auto j) { return s.x[i] < s.x[j]; });
  Section section;
  for (std::size_t k : node) {
    section.x.push_back(s.x[k]);
    section.pressure.push_back(s.pressure[k]);
    section.traction.push_back(s.traction[k][0]);
    section.lateral.push_back(s.traction[k][1]);
  }
  return section;
}

}  // namespace rollcon::scenes
