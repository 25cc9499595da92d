/// Tests rollers whose ends carry load, without a caller's frame: tilts of both signs, mirrored profiles, sharp ends
/// and what is told of them, means of pressures, logarithmic profiles.

#include "rollcon.h"
#include "support/closed_forms.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using scenes::RollingPair;
const closed_forms::Elastic steel{206e3 / 2.6, 0.3};
constexpr double radius = 6, load = 1500;

struct Shape {
  const char* name;
  std::vector<double> parameter;
};

/// Lays a roller on a plane without friction; mirrored: by an axis in the opposite direction.
void lay_roller(RollingPair& pair, const Shape& shape, double tilt, bool mirrored = false) {
  const double c = std::cos(tilt), s = std::sin(tilt);
  pair.friction(0).load(load).pose(2, {{{1, 0, 0}, {0, c, -s}, {0, s, c}}}, {});
  ASSERT_EQ(
      rollcon_body_set_profile_shape(pair.body(2), shape.name, std::ssize(shape.parameter), shape.parameter.data()),
      ROLLCON_OK)
      << rollcon_last_error();
  const double centre[3] = {0, 0, radius}, axis[3] = {0, mirrored ? -1.0 : 1.0, 0};
  ASSERT_EQ(rollcon_body_revolve_profile(pair.body(2), centre, axis, radius), ROLLCON_OK);
}

const Shape crowned{"arc", {2000, 5}}, straight{"line", {5, 0}}, lundberg{"roller", {5, 4.2e-4, 0.9999, 0}};

TEST(roller_ends_long, tilts_of_both_signs_and_mirrored_rollers_are_alike) {
  const double first = -((std::sin(0.012) - std::sin(0.002)) / 0.01 + std::sin(0.002) / 5e-4);
  for (const Shape& shape : {crowned, straight, lundberg, Shape{"roller", {4.8, 4.2e-4, 0.99, 0.2}},
                             Shape{"arcs", {first, -6.5e-3, 0.012, 1, -0.01, 8, -5e-4, 1, -0.01}}})
    for (const double tilt : {5e-4, 3e-3}) {
      double pressure[4], approach[4];
      for (int i = 0; i < 4; ++i) {
        RollingPair pair(steel, steel);
        pair.option("frame_accuracy", 0.05).option("pressure_length", 0.1);
        // An axis in the opposite direction mirrors the profile, and all of these are symmetric.
        lay_roller(pair, shape, i % 2 == 0 ? tilt : -tilt, i > 1);
        ASSERT_EQ(pair.solve(), ROLLCON_OK) << shape.name << " " << tilt << ": " << rollcon_last_caveat();
        pressure[i] = pair.stat("max_pressure");
        approach[i] = pair.solution().approach;
      }
      const std::string name = shape.name + std::string(" tilted by ") + std::to_string(tilt);
      for (int i = 1; i < 4; ++i) {
        expect_error(name + ": pressure", relative(pressure[i], pressure[0]), 1e-6);
        expect_error(name + ": approach", (approach[i] - approach[0]) / 5e-3, 1e-6);
      }
      // At worst a tenth of the roller carries.
      EXPECT_LT(
          pressure[0],
          10 * closed_forms::hertz_line_from_load(radius, closed_forms::effective_modulus(steel, steel), load / 10).p0);
    }
}

/// A straight roller has unbounded pressures at its ends; the mean over a length does not depend on the frame.
TEST(roller_ends_long, sharp_ends_are_told_and_means_have_a_bound) {
  double largest[2], mean[2];
  for (const int fine : {0, 1}) {
    RollingPair pair(steel, steel);
    lay_roller(pair, straight, 5e-4);
    pair.rectangle(ElementType::quad4, fine ? 48 : 24, fine ? 1024 : 256, 0.25, 5 - 1e-5);
    EXPECT_EQ(pair.solve(), ROLLCON_INACCURATE);
    EXPECT_NE(std::string(rollcon_last_caveat()).find("sharp end"), std::string::npos) << rollcon_last_caveat();
    largest[fine] = pair.stat("max_pressure");
    pair.option("pressure_length", 0.2);
    EXPECT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
    mean[fine] = pair.stat("max_pressure");
  }
  expect_error("elements of a quarter of the size double the largest pressure", largest[1] / largest[0] / 2 - 1, 0.1);
  expect_error("the mean over 0.2 mm stays", relative(mean[1], mean[0]), 0.03);
  RollingPair own(steel, steel);
  lay_roller(own, straight, 5e-4);
  EXPECT_EQ(own.solve(), ROLLCON_INACCURATE);
  EXPECT_NE(std::string(rollcon_last_caveat()).find("sharp end"), std::string::npos) << rollcon_last_caveat();
  own.option("pressure_length", 0.2);
  EXPECT_EQ(own.solve(), ROLLCON_OK) << rollcon_last_caveat();
  expect_error("the mean on the library's frame", relative(own.stat("max_pressure"), mean[1]), 0.02);
}

// Strips near the corners and a caller's lattice tell the same peak of a roller with rounded edges.
TEST(roller_ends_long, rounded_edges_have_peaks_that_lattices_have) {
  const Shape rounded{"roller", {5, 1e-9, 0.5, 1}};
  RollingPair own(steel, steel), given(steel, steel);
  own.option("frame_accuracy", 0.005);
  lay_roller(own, rounded, 0);
  lay_roller(given, rounded, 0);
  ASSERT_EQ(own.solve(), ROLLCON_OK) << rollcon_last_caveat();
  given.rectangle(ElementType::quad4, 48, 1600, 0.15, 5.15);
  ASSERT_EQ(given.solve(), ROLLCON_OK) << rollcon_last_caveat();
  expect_error("largest pressure", relative(own.stat("max_pressure"), given.stat("max_pressure")), 0.02);
  expect_error("approach", relative(own.solution().approach, given.solution().approach), 2e-3);
}

// Over the middle of a ball the mean of sqrt(1 - y^2/a^2) is known.
TEST(roller_ends, means_of_hertz_pressures) {
  RollingPair pair(steel, steel);
  pair.friction(0).load(100).gap_quadratic(1 / 20.0, 1 / 20.0);
  const auto hertz =
      closed_forms::hertz_from_load(1 / 20.0, 1 / 20.0, closed_forms::effective_modulus(steel, steel), 100);
  pair.rectangle(ElementType::quad4, 64, 64, 1.1 * hertz.a, 1.1 * hertz.a);
  for (const double part : {0.2, 1.0, 2.0, 5.0}) {
    pair.option("pressure_length", part * hertz.a);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const double u = std::min(part / 2, 1.0), exact = (u * std::sqrt(1 - u * u) + std::asin(u)) / part;
    expect_error("mean over " + std::to_string(part) + " a", relative(pair.stat("max_pressure"), exact * hertz.p0),
                 3e-3);
  }
}

// Lundberg's profile for 3000 MPa has a relief of 0.00035 diameters (ISO/TS 16281).
TEST(roller_ends, lundbergs_profile_has_an_even_pressure) {
  const double modulus = closed_forms::effective_modulus(steel, steel), p = 3000;
  const double line = p * p * std::numbers::pi * radius / modulus, relief = line / (std::numbers::pi * modulus);
  expect_error("relief over the diameter", relative(relief / (2 * radius), 0.00035), 5e-3);
  RollingPair pair(steel, steel);
  lay_roller(pair, {"roller", {5, relief, 1, 0}}, 0);
  pair.load(10 * line);
  ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
  const scenes::Solution s = pair.solution();
  std::vector<double> ridge(16);
  for (std::size_t k = 0; k < s.nodes(); ++k)
    if (std::abs(s.y[k]) < 4) {
      double& most = ridge[static_cast<std::size_t>(2 * (s.y[k] + 4))];
      most = std::max(most, s.pressure[k]);
    }
  double least = 1e9, most = 0;
  for (const double r : ridge)
    if (r > 0) least = std::min(least, r), most = std::max(most, r);
  report("pressure over 80 % of the length, least", least);
  report("pressure over 80 % of the length, most", most);
  EXPECT_LT(most / least - 1, 0.03);
  expect_error("their mean", relative((least + most) / 2, p), 0.03);
}

}  // namespace
}  // namespace rollcon
