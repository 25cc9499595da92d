/// Compares profiles in closed form with the formulas that define them, and tests what is said of wrong parameters.

#include "geometry/profile_shapes.hpp"

#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double pi = std::numbers::pi;

ProfileCurve shape(const char* name, std::vector<double> parameter) {
  return profile_of_shape(name, parameter);
}

double only_z(const ProfileCurve& curve, double y) {
  const std::vector<double> s = curve.at_y(y);
  EXPECT_EQ(s.size(), 1U) << "y " << y;
  return s.empty() ? NAN : curve.at(s.front()).x[1];
}

/// Points along the curve obey f(y, z) = 0.
template <class F>
double worst(const ProfileCurve& curve, double y_from, double y_to, F f) {
  double error = 0;
  constexpr int points = 997;
  for (int i = 0; i <= points; ++i) {
    const Vec2 x = curve.at(curve.length() * i / points).x;
    if (x[0] < y_from || x[0] > y_to) continue;
    error = std::max(error, std::abs(f(x[0], x[1])));
  }
  return error;
}

void expect_refused(const char* name, std::vector<double> parameter, const std::string& text) {
  try {
    shape(name, std::move(parameter));
    ADD_FAILURE() << "taken: " << text;
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_argument);
    EXPECT_NE(std::string(e.what()).find(text), std::string::npos) << e.what();
  }
}

TEST(profile_shapes, arc_line_and_cone) {
  for (const double radius : {40.0, -40.0}) {
    const ProfileCurve arc = shape("arc", {radius, 12});
    expect_error("arc: length over its closed form",
                 relative(arc.length(), 2 * std::abs(radius) * std::asin(12 / std::abs(radius))), 1e-14);
    expect_error("arc: distance from its centre",
                 worst(arc, -12, 12, [&](double y, double z) { return std::hypot(y, z + radius) / 40 - 1; }), 1e-14);
    expect_error("arc: curvature", arc.at(0.3 * arc.length()).curvature() * radius + 1, 1e-14);
    expect_error("arc: its middle", std::hypot(arc.at(arc.length() / 2).x[0], arc.at(arc.length() / 2).x[1]), 1e-13);
  }
  const ProfileCurve cone = shape("line", {20, 0.05});
  expect_error("cone: z", worst(cone, -20, 20, [](double y, double z) { return z - 0.05 * y; }), 1e-14);
  const ProfileCurve half = shape("arc", {7, 7});
  expect_error("half circle: end", length(half.at(half.length()).x - Vec2{7, -7}), 1e-14);
}

// A cone of half-angle 30 degrees has a ball of radius 2 as its tip.
TEST(profile_shapes, chain_of_arcs_is_a_rounded_cone) {
  const double a = pi / 6, radius = 2, flank = 10;
  const ProfileCurve tip = shape("arcs", {0, 0, pi / 2 - a, flank, 0, radius * (pi - 2 * a), -1 / radius, flank, 0});
  const Vec2 from = tip.at(0).x, to = tip.at(tip.length()).x;
  expect_error("chain: ends at one height", to[1] - from[1], 1e-13);
  const double mid = (from[0] + to[0]) / 2, centre = flank * std::cos(a) - radius * std::sin(a);
  expect_error("chain: the tip", length(tip.at(tip.length() / 2).x - Vec2{mid, centre + radius}), 1e-13);
  expect_error("chain: length", tip.length() - (2 * flank + radius * (pi - 2 * a)), 1e-13);
}

// Lundberg's profile has k = 1, Johns and Gohar's a little less. Edges go on from it without a kink.
TEST(profile_shapes, rollers_are_logarithmic_with_round_edges) {
  constexpr double half = 5, relief = 3.5e-3, edge = 0.4;
  for (const double k : {1.0, 0.994, 0.3, 0.0})
    for (const double r : {0.0, edge}) {
      const ProfileCurve roller = shape("roller", {half, relief, k, r});
      const double steep = k > 0 ? -relief + std::sqrt(relief * relief + half * half / k) : half;
      const double end = std::min(half, steep), slope = 2 * relief * k * end / (half * half - k * end * end);
      const std::string name = "roller, k " + std::to_string(k) + ", edge " + std::to_string(r);
      expect_error(
          name + ": z over the relief",
          worst(roller, -end, end,
                [&](double y, double z) { return (z - relief * std::log1p(-k * y * y / (half * half))) / relief; }),
          1e-7);
      const double sine = std::sin(std::atan(slope)), z_end = relief * std::log1p(-k * end * end / (half * half));
      const double down = z_end - r * std::cos(std::atan(slope));
      for (const double side : {-1.0, 1.0}) {
        const Vec2 last = roller.at(side < 0 ? 0 : roller.length()).x;
        expect_error(name + ": end", length(last - Vec2{side * (end + r * (1 - sine)), down}), 1e-11);
        expect_error(name + ": edge",
                     worst(roller, side * end - (side < 0 ? 1 : 0), side * end + (side > 0 ? 1 : 0),
                           [&](double y, double z) {
                             return r > 0 ? std::hypot(y - side * (end - r * sine), z - down) - r : 0;
                           }),
                     1e-11);
      }
    }
  expect_refused("roller", {0, 1e-3, 1, 0}, "half_width, parameter 1 of \"roller\", is 0; allowed: > 0");
  expect_refused("roller", {5, -1e-3, 1, 0}, "relief, parameter 2 of \"roller\", is -0.001; allowed: >= 0");
  expect_refused("roller", {5, 1e-3, 1.1, 0}, "k, parameter 3 of \"roller\", is 1.1; allowed: 0 to 1");
  expect_refused("roller", {5, 1e-3, 1, -1}, "edge_radius, parameter 4 of \"roller\", is -1; allowed: >= 0");
}

TEST(profile_shapes, s1002_is_its_table) {
  const ProfileCurve wheel = shape("s1002", {1});
  // The formulas follow Horner's rule in another order than the library's, and square roots.
  const auto tread = [](double s) {
    return -3.358537058e-2 * s + 1.565681624e-3 * s * s - 2.810427944e-5 * std::pow(s, 3) +
           5.844240864e-8 * std::pow(s, 4) - 1.562379023e-8 * std::pow(s, 5) + 5.309217349e-15 * std::pow(s, 6) -
           5.957839843e-12 * std::pow(s, 7) + 2.646656573e-13 * std::pow(s, 8);
  };
  const auto root = [](double s) {
    return -4.320221063e3 - 1.038384026e3 * s - 1.065501873e2 * s * s - 6.051367875 * std::pow(s, 3) -
           2.054332446e-1 * std::pow(s, 4) - 4.169739389e-3 * std::pow(s, 5) - 4.687195829e-5 * std::pow(s, 6) -
           2.252755540e-7 * std::pow(s, 7);
  };
  const auto error = [&](double from, double to, auto z) {
    double most = 0;
    for (int i = 0; i < 100; ++i) {
      const double y = from + (to - from) * (i + 0.37) / 100;
      const std::vector<double> s = wheel.at_y(y);
      double least = INFINITY;
      for (const double k : s) least = std::min(least, std::abs(wheel.at(k).x[1] - z(y)));
      most = std::max(most, least);
    }
    return most;
  };
  expect_error("S1002 tread, mm", error(-26, 32.15796, tread), 1e-9);
  // The table's pieces leave steps of 4e-5 mm at y = -26 and 1.2e-4 mm at -35, by which the others are moved.
  constexpr double step = 4e-5, steps = 1.2e-4;
  expect_error("S1002 root, mm", error(-35, -26, root), step);
  expect_error("S1002 end, mm", error(32.15796, 60, [](double s) { return 1.364323640 - 0.066666667 * s; }), 1e-9);
  const auto below = [](double c, double z, double r) {
    return [=](double s) { return z - std::sqrt(r * r - (s - c) * (s - c)); };
  };
  const auto above = [](double c, double z, double r) {
    return [=](double s) { return z + std::sqrt(r * r - (s - c) * (s - c)); };
  };
  expect_error("S1002 R13, mm", error(-38.426669071, -35, below(-26.210665, 16.446, 13)), steps);
  expect_error("S1002 flank, mm",
               error(-39.764473993, -38.426669071, [](double s) { return -93.576667419 - 2.747477419 * s; }), steps);
  expect_error("S1002 R20, mm", error(-49.662510381, -39.764473993, above(-58.558326413, 8.834924130, 20)), steps);
  expect_error("S1002 R12, mm", error(-62.764705882, -49.662510381, above(-55, 16, 12)), steps);
  expect_error("S1002 R20.5, mm", error(-70, -62.764705882, above(-49.5, 9.519259302, 20.5)), steps);
  // Slope and curvature of the tread come from differences of the table's formula.
  for (const double y : {-20.0, 0.0, 25.0}) {
    const double s = wheel.at_y(y).front(), h = 1e-3;
    const double d1 = (tread(y + h) - tread(y - h)) / (2 * h),
                 d2 = (tread(y + h) - 2 * tread(y) + tread(y - h)) / (h * h);
    const ProfilePoint p = wheel.at(s);
    expect_error("S1002: slope", p.tangent()[1] / p.tangent()[0] - d1, 1e-8);
    expect_error("S1002: curvature, 1/mm", p.curvature() - d2 / std::pow(1 + d1 * d1, 1.5), 1e-6);
  }
  const ProfileCurve metres = shape("s1002", {1e-3});
  expect_error("S1002 in metres", 1e3 * only_z(metres, 0.01) - only_z(wheel, 10), 1e-12);
}

TEST(profile_shapes, rail_60e1_is_its_circles) {
  const ProfileCurve rail = shape("60e1", {1});
  // The benchmark's circles leave steps of 6e-6 mm at y = 10.5 and 4e-5 mm at 26, by which the outer ones are moved.
  constexpr double step = 7e-6, steps = 5e-5;
  const auto circle = [](double y, double z, double r) {
    return [=](double a, double b) { return std::hypot(std::abs(a) - y, b - z) - r; };
  };
  expect_error("60E1 R300, mm", worst(rail, -10.5, 10.5, circle(0, 300, 300)), 1e-11);
  expect_error("60E1 R80 right, mm", worst(rail, 10.51, 25.98, circle(7.7, 80.134785, 80)), step);
  expect_error("60E1 R80 left, mm", worst(rail, -25.98, -10.51, circle(7.7, 80.134785, 80)), step);
  expect_error("60E1 R13, mm", worst(rail, 26, 35.99, circle(23.016218, 14.908963, 13)), steps);
  const auto side = [](double y, double z) { return std::abs(y) - 36.0 - (z - 14.25977) / 20; };
  expect_error("60E1 side of slope 1 in 20, mm", worst(rail, 36.02, 40, side), 2e-4);
  expect_error("60E1 top, mm", only_z(rail, 0), 1e-12);
}

TEST(profile_shapes, pieces_join) {
  for (const char* name : {"s1002", "60e1"}) {
    const ProfileCurve curve = shape(name, {1});
    double gap = 0;
    for (std::size_t i = 0; i + 1 < curve.pieces().size(); ++i)
      gap = std::max(gap, length(curve.at(i, curve.pieces()[i].length).x - curve.pieces()[i + 1].start));
    expect_error(std::string(name) + ": joints, mm", gap, 1e-13);
  }
}

TEST(profile_shapes, wrong_parameters_are_told) {
  expect_refused("S1002", {1}, "shape is \"S1002\"; allowed: line, arc, arcs, roller, s1002, 60e1");
  expect_refused("s1002", {}, "shape \"s1002\" was given 0 parameter(s); allowed: unit");
  expect_refused("s1002", {0}, "unit, parameter 1 of the shape, is 0; allowed: > 0");
  expect_refused("line", {-1, 0}, "half_width, parameter 1 of \"line\", is -1; allowed: > 0");
  expect_refused("arc", {0, 1}, "radius, parameter 1 of \"arc\", is 0");
  expect_refused("arc", {2, 3}, "half_width, parameter 2 of \"arc\", is 3; allowed: > 0, at most the radius, 2");
  expect_refused("arcs", {0, 0, 0, 1}, "was given 4 parameter(s)");
  expect_refused("arcs", {0, 0, 0, 0, 1}, "length, parameter 4 of \"arcs\" (counting from 1), is 0");
  expect_refused("arcs", {0, 0, 0, 4, 1}, "turn by 4; allowed: at most a half circle each");
  expect_refused("line", {1e40, 0}, "parameter 1 (counting from 1) of shape \"line\" is 1e+40");
}

}  // namespace
}  // namespace rollcon
