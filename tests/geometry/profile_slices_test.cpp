/// Tests profiles that vary: derivatives, order of the splines, features that begin, and surfaces beside closed forms.

#include "geometry/profile_slices.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/profile_shapes.hpp"
#include "geometry/sliced_surface.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using Curve = std::shared_ptr<const ProfileCurve>;

Curve arcs(std::vector<double> parameter) {
  return std::make_shared<const ProfileCurve>(profile_of_shape("arcs", parameter));
}

/// Makes an arc of radius r whose top is at (0, z), from -0.6 to 0.6 radian.
Curve crown(double r, double z) {
  const double half = 0.6;
  return arcs({-r * std::sin(half), z + r * (1 - std::cos(half)), -half, 2 * r * half, 1 / r});
}

/// Takes slices of a circle across that is moved along another.
std::vector<ProfileSlice> slices(double along, double across, double step, int count) {
  std::vector<ProfileSlice> all;
  for (int i = -count; i <= count; ++i) {
    const double u = i * step;
    all.push_back({u, crown(across, along - std::sqrt(along * along - u * u)), {}});
  }
  return all;
}

TEST(profile_slices, derivatives_are_those_of_the_points) {
  std::mt19937 random(5);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const ProfileSlices s(slices(300, 80, 20, 4), {{0.3, 50, 0.4}}, false, 0);
  const double last = s.sheets()[0].last(), du = 1e-4, dv = 1e-4;
  double first = 0, second = 0;
  for (int i = 0; i < 200; ++i) {
    const double u = between(-79, 79), v = std::floor(between(0, last)) + between(0.01, 0.99);
    const SlicePoint p = s.at(0, u, v), a = s.at(0, u - du, v), b = s.at(0, u + du, v), c = s.at(0, u, v - dv),
                     d = s.at(0, u, v + dv);
    for (std::size_t k = 0; k < 2; ++k) {
      first = std::max(
          {first, std::abs(p.u[k] - (b.x[k] - a.x[k]) / (2 * du)), std::abs(p.v[k] - (d.x[k] - c.x[k]) / (2 * dv))});
      second = std::max({second, std::abs(p.uu[k] - (b.u[k] - a.u[k]) / (2 * du)),
                         std::abs(p.uv[k] - (d.u[k] - c.u[k]) / (2 * dv)),
                         std::abs(p.vv[k] - (d.v[k] - c.v[k]) / (2 * dv))});
    }
  }
  expect_error("first derivatives", first, 1e-7);
  expect_error("second derivatives", second, 1e-6);
}

TEST(profile_slices, splines_are_of_fourth_order) {
  const double radius = 300;
  double before = 0;
  for (const double step : {40.0, 20.0, 10.0}) {
    const ProfileSlices s(slices(radius, 80, step, static_cast<int>(160 / step)), {}, false, 0);
    double off = 0;
    for (double u = -70; u <= 70; u += 3.3) {
      const SlicePoint p = s.at(0, u, s.sheets()[0].last() / 2);
      off = std::max(off, std::abs(p.x[1] - radius + std::sqrt(radius * radius - u * u)));
    }
    if (before > 0) expect_order("splines along", std::log2(before / off), 3.7);
    before = off;
  }
}

// One circle moved along another is a surface with a closed form.
TEST(sliced_surface, meets_lines_where_a_moved_circle_is) {
  const double along = 300, across = 80;
  std::mt19937 random(7);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto slice =
      std::make_shared<const ProfileSlices>(slices(along, across, 5, 20), std::vector<ProfileWave>{}, false, 0);
  const SlicedSurface surface(slice, {false, {1, 2, 3}, {1, 0, 0}, {0, 0, 1}, 0});
  double off = 0, hinted = 0;
  SurfaceHint hint;
  for (int i = 0; i < 300; ++i) {
    const double u = between(-60, 60), y = between(-30, 30);
    Vec3 direction{between(-0.2, 0.2), between(-0.3, 0.3), 1};
    direction = (1 / length(direction)) * direction;
    const double z = across - std::sqrt(across * across - y * y) + along - std::sqrt(along * along - u * u);
    const Vec3 met{1 + u, 2 + y, 3 + z};
    const double t = between(-1, 1);
    const auto found = surface.distance(met - t * direction, direction, {0, 0, 0});
    const auto near = surface.distance_near(met - t * direction, direction, {0, 0, 0}, hint);
    ASSERT_TRUE(found && near) << i;
    off = std::max(off, std::abs(*found - t));
    hinted = std::max(hinted, std::abs(*near - *found));
    EXPECT_LT(length(surface.nearest(met) - met), 1e-5) << i;
  }
  expect_error("distance along lines, of 300", off, 1e-5);
  expect_error("distance from a hint", hinted, 1e-9);
  EXPECT_FALSE(surface.distance({0, 200, 0}, {0, 0, 1}, {0, 0, 0}));
}

TEST(sliced_surface, equal_slices_round_an_axis_are_the_revolved_profile) {
  const Curve curve = crown(500, 0);
  std::vector<ProfileSlice> all;
  for (const double u : {-3.0, -1.2, 0.1, 0.7, 2.9}) all.push_back({u, curve, {}});
  const double turn = 2 * std::numbers::pi;
  const auto slice = std::make_shared<const ProfileSlices>(all, std::vector<ProfileWave>{}, false, turn);
  const SlicedSurface surface(slice, {true, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 460});
  double off = 0;
  for (double angle = -7; angle < 7; angle += 0.37)
    for (const double y : {-200.0, 3.0, 150.0}) {
      const double r = 460 + 500 - std::sqrt(500.0 * 500 - y * y);
      const Vec3 out{std::sin(angle), 0, std::cos(angle)}, met = r * out + Vec3{0, y, 0};
      const auto found = surface.distance(met - 0.5 * out, out, out);
      ASSERT_TRUE(found) << angle;
      off = std::max(off, std::abs(*found - 0.5));
    }
  expect_error("distance along radii, of 460", off, 1e-6);
}

// A nose begins at the third slice; what it has in common with the others stays.
TEST(profile_slices, features_begin_and_end_with_their_slices) {
  const Curve rail = arcs({0, 0, 0, 60, 0}), with_nose = arcs({-40, 0, 0, 100, 0});
  std::vector<ProfileSlice> all{
      {0, rail, {-1, 0, 60}}, {10, rail, {-1, 0, 60}}, {20, with_nose, {0, 40, 999}}, {30, with_nose, {0, 40, 999}}};
  const auto slice = std::make_shared<const ProfileSlices>(all, std::vector<ProfileWave>{}, false, 0);
  ASSERT_EQ(slice->sheets().size(), 2U);
  const SlicedSurface surface(slice, {false, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0});
  const auto there = [&](double x, double y) { return surface.distance({x, y, -1}, {0, 0, 1}, {0, 0, 0}).has_value(); };
  for (const double x : {-50.0, 5.0, 15.0, 25.0, 80.0}) EXPECT_TRUE(there(x, 30)) << x;
  for (const double x : {-50.0, 5.0, 15.0, 19.9}) EXPECT_FALSE(there(x, -20)) << x;
  for (const double x : {20.1, 25.0, 80.0}) EXPECT_TRUE(there(x, -20)) << x;
}

}  // namespace
}  // namespace rollcon
