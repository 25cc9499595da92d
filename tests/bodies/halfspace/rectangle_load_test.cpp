// Compares Love's rectangle under uniform and bilinear loads with closed forms.

#include "bodies/halfspace/brute_force.hpp"
#include "bodies/halfspace/halfspace.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Returns log(a + r) where a may be close to -r = -sqrt(a^2 + b^2).
double log_sum(double a, double b) {
  const double r = std::hypot(a, b);
  return a >= 0 ? std::log(a + r) : 2 * std::log(std::abs(b)) - std::log(r - a);
}

/// Returns second antiderivatives in u and v of 1/r, u^2/r^3, uv/r^3, u/r^2, v/r^2.
double antiderivative(int kernel, double u, double v) {
  const double r = std::hypot(u, v);
  const double lu = v == 0 ? 0 : v * log_sum(u, v), lv = u == 0 ? 0 : u * log_sum(v, u);
  const double log_r = r == 0 ? 0 : std::log(r);
  switch (kernel) {
    case 0:
      return lu + lv;
    case 1:
      return lu;
    case 2:
      return -r;
    case 3:
      return v * log_r + (u == 0 ? 0 : u * std::atan(v / u));
    default:
      return u * log_r + (v == 0 ? 0 : v * std::atan(u / v));
  }
}

/// Integrates a kernel of d = observer - source over the rectangle [x0,x1] x [y0,y1].
double rectangle(int kernel, double x0, double x1, double y0, double y1, double px, double py) {
  const double a = px - x1, b = px - x0, c = py - y1, d = py - y0;
  return antiderivative(kernel, b, d) - antiderivative(kernel, a, d) - antiderivative(kernel, b, c) +
         antiderivative(kernel, a, c);
}

brute_force::Element rectangle_element(double x0, double x1, double y0, double y1) {
  return {ElementType::quad4, {x0, x1, x1, x0}, {y0, y0, y1, y1}};
}

TEST(rectangle_load, uniform_load_matches_love) {
  double worst[2] = {0, 0};
  for (const double side : {1.0, 0.01}) {  // square, and 1 : 100
    const auto element = rectangle_element(-0.5, 0.5, -0.5 * side, 0.5 * side);
    const double points[][2] = {{0, 0},      {0.5, 0.5}, {0.21, -0.34},     {0.5, 0.1},  {0.7, 0.2},
                                {-0.2, 0.9}, {3, 4},     {0.5 + 1e-7, 0.3}, {-40, 12.0}, {1e4, -7e3}};
    for (const auto& point : points) {
      const double px = point[0], py = side * point[1];
      const double tolerance[] = {1e-6, 1e-9};
      for (std::size_t k = 0; k < 2; ++k) {
        const auto value = brute_force::from_library(element, px, py, tolerance[k]);
        // Differences of antiderivatives lose digits with the square of the distance.
        const double distance = std::hypot(px, py), lost = 1e-16 * distance * distance / side;
        const double scale = rectangle(0, -0.5, 0.5, -0.5 * side, 0.5 * side, px, py);
        for (std::size_t j = 0; j < 5; ++j) {
          double sum = 0;
          for (std::size_t i = 0; i < 4; ++i) sum += value[j][i];
          const double exact = rectangle(static_cast<int>(j), -0.5, 0.5, -0.5 * side, 0.5 * side, px, py);
          if (lost < 1e-10) worst[k] = std::max(worst[k], std::abs(sum - exact) / scale);
          if (lost > 1e-10 && j == 0) worst[k] = std::max(worst[k], std::abs(sum * distance / side - 1) - 1 / distance);
        }
      }
    }
  }
  std::printf("uniform rectangle: error %.1e (bound 1e-6), %.1e (bound 1e-9)\n", worst[0], worst[1]);
  EXPECT_LE(worst[0], 1e-6);
  EXPECT_LE(worst[1], 1e-9);
}

TEST(rectangle_load, bilinear_load_matches_closed_form) {
  // The integrands u/r, v/r and uv/r have the antiderivatives (v r + u^2 log(v + r))/2, that with u and v exchanged,
  // and r^3/3; a corner's shape function is bilinear in u and v.
  const auto element = rectangle_element(0, 1.4, 0, 0.6);
  double worst = 0;
  for (const auto& [px, py] : {std::pair{0.0, 0.0}, {0.7, 0.3}, {1.4, 0.2}, {2.0, -0.4}, {0.3, 0.7}}) {
    auto f = [](double u, double v) {
      const double r = std::hypot(u, v);
      return (v * r + (u == 0 ? 0 : u * u * log_sum(v, u))) / 2;
    };
    auto difference = [&, x = px, y = py](auto g) {
      return g(x, y) - g(x - 1.4, y) - g(x, y - 0.6) + g(x - 1.4, y - 0.6);
    };
    const double one = rectangle(0, 0, 1.4, 0, 0.6, px, py);
    const double u = difference(f), v = difference([&](double a, double b) { return f(b, a); });
    const double uv = difference([](double a, double b) { return std::pow(std::hypot(a, b), 3) / 3; });
    const auto value = brute_force::from_library(element, px, py, 1e-9);
    // The shape functions have x = px - u, y = py - v.
    for (std::size_t i = 0; i < 4; ++i) {
      const double sx = i == 1 || i == 2 ? 1 : -1, sy = i >= 2 ? 1 : -1;
      const double ax = sx > 0 ? px / 1.4 : 1 - px / 1.4, bx = -sx / 1.4;  // ax + bx u
      const double ay = sy > 0 ? py / 0.6 : 1 - py / 0.6, by = -sy / 0.6;
      const double exact = ax * ay * one + bx * ay * u + ax * by * v + bx * by * uv;
      worst = std::max(worst, std::abs(value[0][i] - exact) / one);
    }
  }
  std::printf("bilinear rectangle: error %.1e (bound 1e-9)\n", worst);
  EXPECT_LE(worst, 1e-9);
}

TEST(rectangle_load, unit_square_matches_contact_reference) {
  // A unit square with G = 1, nu = 0.28 under unit pressures along x and n has these u_x and u_n at the centre.
  const Frame frame = brute_force::frame_of(rectangle_element(-0.5, 0.5, -0.5, 0.5));
  const auto compliance = make_halfspace_compliance(frame, halfspace_constants(2.56, 0.28, 1), 1e-9, 1);
  const double x[] = {0}, y[] = {0};
  double t[12], u[3];
  for (int i = 0; i < 12; ++i) t[i] = i % 3 == 1 ? 0 : 1;
  compliance->apply({x, y}, t, u);
  const double closed_n = (1 - 0.28) / (2 * std::numbers::pi) * 4 * std::asinh(1.0);
  const double closed_x = (1 - 0.28 / 2) / (2 * std::numbers::pi) * 4 * std::asinh(1.0);
  std::printf("unit square: u_n %.6f (table .403982), u_x %.6f (table .482073, closed form %.6f)\n", u[2], u[0],
              closed_x);
  EXPECT_NEAR(u[2], closed_n, 1e-9);
  EXPECT_NEAR(u[0], closed_x, 1e-9);
  EXPECT_NEAR(u[2], 0.403982, 1.5e-5);
  EXPECT_NEAR(u[0], 0.482073, 6e-4);  // the table (a program on grids) is 1e-3 low
  EXPECT_NEAR(u[1], 0, 1e-15);
}

TEST(rectangle_load, normal_force_pulls_surface_points_towards_it) {
  // A compressive force P on body 1, t_n = -P, moves the surface by u_r = -(1 - 2 nu) P / (4 pi G r).
  const Frame frame = brute_force::frame_of(rectangle_element(-0.5, 0.5, -0.5, 0.5));
  const auto compliance = make_halfspace_compliance(frame, halfspace_constants(2.6, 0.3, 1), 1e-9, 1);
  const double x[] = {1000}, y[] = {0};
  const double t[12] = {0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1};
  double u[3];
  compliance->apply({x, y}, t, u);
  const double radial = -(1 - 0.6) / (4 * std::numbers::pi * 1000);
  const double normal = -(1 - 0.3) / (2 * std::numbers::pi * 1000);
  std::printf("point force: u_r %.6e (%.6e), u_n %.6e (%.6e), relative bound 1e-6\n", u[0], radial, u[2], normal);
  EXPECT_NEAR(u[0] / radial, 1, 1e-6);
  EXPECT_NEAR(u[2] / normal, 1, 1e-6);
}

}  // namespace
}  // namespace rollcon
