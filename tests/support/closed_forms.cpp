#include "support/closed_forms.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace rollcon::closed_forms {
namespace {

constexpr double pi = std::numbers::pi;

double positive_root(double x) {
  return std::sqrt(std::max(x, 0.0));
}

/// Holds A_small / A_large of an ellipse with (short/long axis)^2 = m1, which is (K-E)/(E/m1 - K), and the two factors
/// of A_small (with alpha^3 2 pi E*/(3P)) and of the approach.
struct Shape {
  double curvature_ratio, curvature_factor, k;
};
Shape shape(double m1) {
  const EllipticIntegrals e = elliptic_integrals(m1);
  const double m = 1 - m1;
  const double s = e.k_minus_e_over_k;
  // Both (K - E)/m and (E/m1 - K)/m tend to pi/4 as m -> 0.
  const double small = m < 1e-12 ? pi / 4 : e.k * s / m;
  const double large = m < 1e-12 ? pi / 4 : e.k * (m - s) / (m * m1);
  return {small / large, small, e.k};
}

double shape_of_curvatures(double ratio) {
  double low = std::log(1e-14), high = 0;  // bounds of log m1
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (shape(std::exp(middle)).curvature_ratio < ratio ? low : high) = middle;
  }
  return std::exp(0.5 * (low + high));
}

std::string data_path(const std::string& file) {
  return std::string(ROLLCON_TEST_DATA) + "/" + file;
}

}  // namespace

double effective_modulus(const Elastic& body1, const Elastic& body2) {
  return 1 / (1 / effective_modulus(body1) + 1 / effective_modulus(body2));
}

double effective_modulus(const Elastic& body) {
  return 2 * body.shear / (1 - body.poisson);
}

EllipticIntegrals elliptic_integrals(double m1) {
  double a = 1, g = std::sqrt(m1), c2 = 1 - m1, sum = 0.5 * c2, power = 0.5;
  while (c2 > 1e-28 * a * a) {  // quadratic convergence: the next c2 is below round-off
    const double c = 0.5 * (a - g);
    const double mean = 0.5 * (a + g);
    g = std::sqrt(a * g);
    a = mean;
    c2 = c * c;
    power *= 2;
    sum += power * c2;
  }
  EllipticIntegrals result;
  result.k = pi / (2 * a);
  result.k_minus_e_over_k = sum;
  result.e = result.k * (1 - sum);
  return result;
}

double Hertz::pressure(double x, double y) const {
  return p0 * positive_root(1 - x * x / (a * a) - y * y / (b * b));
}

Hertz hertz_from_load(double A, double B, double e_star, double load) {
  const double small = std::min(A, B), large = std::max(A, B);
  const double m1 = shape_of_curvatures(small / large);
  const Shape s = shape(m1);
  const double longer = std::cbrt(3 * load * s.curvature_factor / (2 * pi * e_star * small));
  const double shorter = longer * std::sqrt(m1);
  Hertz h{.A = A, .B = B, .a = A <= B ? longer : shorter, .b = A <= B ? shorter : longer};
  h.load = load;
  h.p0 = 3 * load / (2 * pi * h.a * h.b);
  h.approach = 3 * load * s.k / (2 * pi * longer * e_star);
  return h;
}

Hertz hertz_from_approach(double A, double B, double e_star, double approach) {
  const double unit = hertz_from_load(A, B, e_star, 1).approach;  // the approach goes with load^(2/3)
  return hertz_from_load(A, B, e_star, std::pow(approach / unit, 1.5));
}

Hertz hertz_from_axes(double a, double b, double p0, double e_star) {
  const double longer = std::max(a, b), shorter = std::min(a, b);
  const Shape s = shape(shorter * shorter / (longer * longer));
  const double load = 2 * pi * a * b * p0 / 3;
  const double small = 3 * load * s.curvature_factor / (2 * pi * e_star * std::pow(longer, 3));
  const double large = small / s.curvature_ratio;
  return {.A = a >= b ? small : large,
          .B = a >= b ? large : small,
          .a = a,
          .b = b,
          .p0 = p0,
          .load = load,
          .approach = 3 * load * s.k / (2 * pi * longer * e_star)};
}

double HertzLine::pressure(double x) const {
  return p0 * positive_root(1 - x * x / (a * a));
}

double HertzLine::gap(double x) const {
  const double t = std::abs(x) / a;
  return t <= 1 ? 0 : p0 * a / e_star * (t * std::sqrt(t * t - 1) - std::acosh(t));
}

HertzLine hertz_line_from_load(double radius, double e_star, double load) {
  const double a = std::sqrt(4 * load * radius / (pi * e_star));
  return {radius, a, 2 * load / (pi * a), load, e_star};
}

HertzLine hertz_line_from_width(double radius, double e_star, double a) {
  return hertz_line_from_load(radius, e_star, pi * e_star * a * a / (4 * radius));
}

double Carter::stick_half_length() const {
  return std::max(0.0, hertz.a - std::abs(xi) * hertz.radius / mu);
}

double Carter::force_ratio() const {
  const double s = stick_half_length() / hertz.a;
  return (xi > 0 ? -1 : 1) * (1 - s * s);
}

double Carter::traction(double x) const {
  const double stick = stick_half_length(), centre = hertz.a - stick;
  const double q =
      positive_root(hertz.a * hertz.a - x * x) - positive_root(stick * stick - (x - centre) * (x - centre));
  return (xi > 0 ? -1 : 1) * mu * hertz.p0 / hertz.a * q;
}

std::vector<std::vector<std::string>> read_table(const std::string& file) {
  std::ifstream in(data_path(file));
  if (!in) throw std::runtime_error("cannot read " + data_path(file));
  std::vector<std::vector<std::string>> rows;
  bool heading = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (std::exchange(heading, false)) continue;
    std::vector<std::string> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    rows.push_back(row);
  }
  return rows;
}

Kalker kalker_table(double a_over_b, double nu) {
  const int column = nu == 0 ? 0 : nu == 0.25 ? 1 : nu == 0.5 ? 2 : -1;
  if (column < 0) throw std::invalid_argument("kalker_table: nu must be 0, 0.25 or 0.5");
  for (const auto& row : read_table("kalker.csv")) {
    const double value = std::stod(row[1]);
    const double ratio = row[0] == "a/b" ? value : 1 / value;
    if (std::abs(ratio - a_over_b) > 1e-9 * ratio) continue;
    auto cell = [&](int k) { return std::stod(row[static_cast<std::size_t>(2 + 3 * k + column)]); };
    return {cell(0), cell(1), cell(2), cell(3)};
  }
  throw std::invalid_argument("kalker_table: this a/b is not in the table");
}

std::vector<CreepPoint> creep_curve() {
  std::vector<CreepPoint> points;
  for (const auto& row : read_table("creep_curve.csv")) points.push_back({std::stod(row[0]), std::stod(row[1])});
  return points;
}

std::vector<BentallJohnson> bentall_johnson() {
  std::vector<BentallJohnson> points;
  for (const auto& r : read_table("bentall_johnson.csv"))
    points.push_back({std::stod(r[0]), std::stod(r[1]), std::stod(r[2]), std::stod(r[3])});
  return points;
}

double bentall_johnson_vanishing(const Elastic& body1, const Elastic& body2, double a, double radius) {
  // The strip |x| < x0 carries half the load: (2/pi)(x0 sqrt(1 - x0^2) + asin x0) = 1/2 (x0 in units of a).
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    (x * std::sqrt(1 - x * x) + std::asin(x) < pi / 4 ? low : high) = x;
  }
  const double p0 = effective_modulus(body1, body2) * a / (2 * radius);
  auto coupling = [](const Elastic& e) { return (1 - 2 * e.poisson) / (4 * pi * e.shear); };
  // The slip s = V (xi + 2 pi ck p) vanishes at x0.
  return -2 * pi * (coupling(body1) - coupling(body2)) * p0 * std::sqrt(1 - low * low);
}

double no_slip_free_rolling(const Elastic& body1, const Elastic& body2, double load, double radius) {
  auto coupling = [](const Elastic& e) { return (1 - 2 * e.poisson) / (2 * e.shear); };
  const double e_star = effective_modulus(body1, body2);
  const double beta = 0.5 * e_star * (coupling(body1) - coupling(body2));
  const double eta = std::log((1 + beta) / (1 - beta)) / (2 * pi);
  const double a = std::sqrt(4 * load * radius / (pi * e_star * (1 + 4 * eta * eta)));
  return -2 * eta * a / radius;
}

double steady_rolling(const std::string& which_case, const std::string& quantity) {
  for (const auto& row : read_table("steady_rolling_limits.csv"))
    if (row[0] == which_case && row[1] == quantity) return std::stod(row[2]);
  throw std::invalid_argument("steady_rolling: no entry " + which_case + " " + quantity);
}

std::map<int, double> steady_rolling_by_size(const std::string& which_case, const std::string& quantity) {
  std::map<int, double> found;
  for (const auto& row : read_table("steady_rolling_limits.csv"))
    if (row[0] == which_case && row[1].starts_with(quantity + "_"))
      found[std::stoi(row[1].substr(quantity.size() + 1))] = std::stod(row[2]);
  return found;
}

}  // namespace rollcon::closed_forms
