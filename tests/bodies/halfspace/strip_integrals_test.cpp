/// Closed integrals over strips beside Gauss's rules, and their derivatives beside differences.

#include "bodies/halfspace/strip_integrals.hpp"

#include "linalg/dense.hpp"
#include "support/testing.hpp"

namespace rollcon::strips {
namespace {

constexpr double gauss_point[] = {0.9739065285171717, 0.8650633666889845, 0.6794095682990244, 0.4333953941292472,
                                  0.1488743389816312};
constexpr double gauss_weight[] = {0.0666713443086881, 0.1494513491505806, 0.2190863625159820, 0.2692667193099964,
                                   0.2955242247147529};

std::vector<double> some_geometry(const StripLayout& l) {
  std::vector<double> g(static_cast<std::size_t>(l.geometry));
  for (int k = 0; k < l.rows; ++k) {
    const double w = l.across[k + 1];
    g[k] = 0.3 + 0.2 * w;
    g[l.half_of(k)] = 1.3 * std::sqrt(1 - 0.95 * w * w);
  }
  g[l.centre_of(0)] = 0.1;
  g[l.width_of(0)] = 0.9;
  return g;
}

/// By Gauss's rule on parts of each cell between nodes and rows, about an observer outside.
double by_quadrature(const StripLayout& l, const double* g, const std::vector<double>& p, const StripBodies& b,
                     Displacement what, int kind, double X, double Y) {
  constexpr int parts = 6;
  double sum = 0;
  for (int row = 0; row < l.rows; ++row)
    for (int side = 0; side < 2; ++side)
      for (int j = 0; j < l.counts.along; ++j) {
        const double y0 = g[l.centre_of(0)] + g[l.width_of(0)] * l.across[row + side],
                     y1 = g[l.centre_of(0)] + g[l.width_of(0)] * l.across[row + side + 1];
        const double x0 = g[row] + g[l.half_of(row)] * l.along[j], x1 = g[row] + g[l.half_of(row)] * l.along[j + 1];
        const double left = j > 0 ? p[row * l.nodes_each + j - 1] : 0,
                     right = j < l.nodes_each ? p[row * l.nodes_each + j] : 0;
        for (int q = 0; q < parts * parts * 100; ++q) {
          const int m = q % 10, n = q / 10 % 10, a = q / 100 % parts, c = q / 100 / parts;
          const double gx = (m < 5 ? -1 : 1) * gauss_point[m % 5], gy = (n < 5 ? -1 : 1) * gauss_point[n % 5];
          const double tx = (a + (gx + 1) / 2) / parts, ty = (c + (gy + 1) / 2) / parts;
          const double x = X - x0 - tx * (x1 - x0), y = Y - y0 - ty * (y1 - y0), r = std::hypot(x, y);
          const double normal[] = {b.cn / r, b.ck * x / r / r, b.ck * y / r / r};
          const double slip[] = {b.cn / r + b.cv * x * x / (r * r * r), b.cv * x * y / (r * r * r),
                                 b.cn / r + b.cv * y * y / (r * r * r), -b.ck * x / r / r, -b.ck * y / r / r};
          sum += gauss_weight[m % 5] * gauss_weight[n % 5] / 4 / parts / parts * (x1 - x0) * (y1 - y0) *
                 (left + (right - left) * tx) * (side == 0 ? ty : 1 - ty) *
                 (what == Displacement::slip ? slip : normal)[kind];
        }
      }
  return sum;
}

TEST(strip_integrals, agree_with_quadrature_and_differences) {
  const StripLayout l({8, 12}, 1);
  const std::vector<double> g = some_geometry(l);
  const StripBodies bodies{1.0, 0.4, 0.3};
  std::vector<double> p;
  for (int i = 0; i < l.nodes; ++i) p.push_back(1 + std::sin(1.7 * i));
  double wrong = 0, wrong_rows = 0, wrong_rates = 0, wrong_sets = 0;
  std::vector<double> first;
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    force_instruction_set(set);
    std::vector<double> all;
    for (const Displacement what : {Displacement::normal, Displacement::slip})
      for (const StripPoint& at : {StripPoint{5, 5, 0, 1, 0, -1.7, 0.37}, StripPoint{2, 2, 0, 1, 0, 1.9, -2.1}}) {
        StripIntegrals integrals;
        integrals.lay(l, bodies, g.data());
        for (int k = 0; k < 3; ++k) integrals.set_field(k, p.data());
        const Observation o = integrals.observe(what, true, at, 0);
        double largest = 0;
        for (int k = 0; k < integrals.kinds(what); ++k)
          largest = std::max(largest, std::abs(integrals.displacement(o, k, 0)));
        for (int k = 0; k < integrals.kinds(what); ++k) {
          const double u = integrals.displacement(o, k, 0);
          all.push_back(u / largest);
          if (set == InstructionSet::baseline)
            wrong = std::max(wrong, std::abs(u - by_quadrature(l, g.data(), p, bodies, what, k, l.x(at, g.data()),
                                                               l.y(at, g.data()))) /
                                        largest);
          std::vector<double> row(l.nodes), rates(l.geometry);
          integrals.add_row(o, k, 1, row.data());
          wrong_rows = std::max(wrong_rows, std::abs(dot(row.data(), p.data(), l.nodes) - u) / largest);
          integrals.add_rates(o, k, 0, at, 1, rates.data());
          for (int q = 0; q < l.geometry; q += 3) {
            double difference = 0;
            constexpr double step = 2e-3, weight[] = {0, 45.0 / 60, -9.0 / 60, 1.0 / 60};
            for (int m = -3; m <= 3; ++m) {
              std::vector<double> moved = g;
              moved[q] += m * step;
              StripIntegrals other;
              other.lay(l, bodies, moved.data());
              other.set_field(0, p.data());
              const Observation there = other.observe(what, false, at, 1);
              difference += (m < 0 ? -1 : 1) * weight[std::abs(m)] * other.displacement(there, k, 0) / step;
            }
            wrong_rates = std::max(wrong_rates, std::abs(rates[q] - difference) / largest);
          }
        }
      }
    if (first.empty()) first = all;
    for (std::size_t i = 0; i < all.size(); ++i) wrong_sets = std::max(wrong_sets, std::abs(all[i] - first[i]));
  }
  force_instruction_set(best_instruction_set());
  expect_error("integrals over the largest at the place", wrong, 3e-12);
  expect_error("rows of the matrix", wrong_rows, 1e-13);
  expect_error("derivatives by the geometry", wrong_rates, 1e-8);
  expect_error("instruction sets", wrong_sets, 1e-11);
}

// A uniform pressure has hats that add up to it: the displacement in the middle of a square is known.
TEST(strip_integrals, are_right_inside_of_strips) {
  const StripLayout l({12, 12}, 1);
  std::vector<double> g(static_cast<std::size_t>(l.geometry));
  for (int k = 0; k < l.rows; ++k) g[l.half_of(k)] = 1;
  g[l.width_of(0)] = 1;
  StripIntegrals integrals;
  integrals.lay(l, {1, 0.4, 0}, g.data());
  // A tent of pressure, (1 - |x|)(1 - |y|): nodes lie on its kinks.
  std::vector<double> p;
  for (int i = 0; i < l.nodes; ++i)
    p.push_back((1 - std::abs(l.along[i % l.nodes_each + 1])) * (1 - std::abs(l.across[i / l.nodes_each + 1])));
  integrals.set_field(0, p.data());
  const Observation o = integrals.observe(Displacement::slip, false, StripPoint{5, 5, 0, 1, 0, 0, 0}, 0);
  // Over a triangle in polar coordinates: 8 int_0^(pi/4) int_0^(1/cos) (1 - r cos)(1 - r sin) dr dphi, by Gauss.
  double expected = 0;
  for (int q = 0; q < 10; ++q) {
    const double phi = std::numbers::pi / 8 * (1 + (q < 5 ? -1 : 1) * gauss_point[q % 5]);
    const double c = std::cos(phi), s = std::sin(phi), R = 1 / c;
    expected += 8 * std::numbers::pi / 8 * gauss_weight[q % 5] * (R - (c + s) * R * R / 2 + c * s * R * R * R / 3);
  }
  expect_error("1/r and x^2/r^3 at the top of a tent", integrals.displacement(o, 0, 0) / (1.2 * expected) - 1, 1e-12);
  expect_error("xy/r^3 there", integrals.displacement(o, 1, 0), 1e-13);
}

}  // namespace
}  // namespace rollcon::strips
