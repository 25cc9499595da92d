// Compares contact that turns by up to 60 degrees with closed forms without friction: a bore lined with a thin layer,
// where every point yields by its own pressure, and an elastic pin in an elastic plate.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/extreme_bodies.hpp"
#include "support/persson.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

constexpr double degree = std::numbers::pi / 180, clearance = 1e-3, young = 1e4, poisson = 0.3;

/// Returns the greatest angle of nodes in contact to the lowest line of a bore of radius 1.
double reach_of(const Solution& s, const SurfaceMesh& frame) {
  double reach = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    const Vec3& x = frame.node[k];
    if (s.pressure[k] > 0) reach = std::max(reach, std::abs(std::atan2(x[1], 1 - x[2])));
  }
  return reach;
}

/// Presses a rigid pin, sunk by `depth`, which reaches where depth cos - clearance (1 - cos) is zero; its pressure is
/// (depth cos - clearance (1 - cos)) M / wall.
void press_into_a_layer(extremes::Model model, double wall) {
  constexpr double angle = 54 * degree;
  extremes::ConformalShape shape{.model = model};
  shape.crown = 0;
  shape.wall = wall;
  shape.half_length = 0.25;
  shape.half_angle = 60;
  shape.n = {4, 48, 1};
  const MeshedBody body = extremes::make_conformal(shape);
  const SurfaceMesh frame = extremes::top_of(body, 1);
  RollingPair pair(body, RigidBody{}, 1);
  std::vector<double> gap;
  for (const Vec3& x : frame.node) gap.push_back(clearance * x[2]);  // 1 - cos of the angle
  const double depth = clearance * (1 / std::cos(angle) - 1);
  pair.frame_from_body(1, 6).gap(gap).approach(depth).friction(0);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  const double modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  const double force =
      2 * shape.half_length * modulus / wall *
      ((depth + clearance) * (angle + std::sin(angle) * std::cos(angle)) - 2 * clearance * std::sin(angle));
  const std::string name =
      std::string(model == extremes::Model::fem ? "FEM" : "BEM") + ", layer " + std::to_string(wall) + ": ";
  const Solution s = pair.solution();
  expect_error(name + "reach (radian)", reach_of(s, frame) - angle, 120 * degree / 48);
  expect_error(name + "force", relative(-s.force[2], force), 2 * wall);
  expect_error(name + "p0", relative(pair.stat("max_pressure"), modulus * depth / wall), 2 * wall);
}

TEST(ConformalFits, a_lined_bore) {
  for (const extremes::Model model : {extremes::Model::fem, extremes::Model::bem})
    for (const double wall : {0.04, 0.02}) press_into_a_layer(model, wall);
}

constexpr double half_length = 0.02;

/// Makes a plate with a hole of radius 1 about the axis at height 1, held far away, in plane strain; tag 7 spans 60
/// degrees to both sides of the hole's lowest line.
MeshedBody plate(int around, int deep) {
  constexpr double outer = 40;
  surfaces::Block block;
  block.ring = true;
  const int n = around / 2;
  for (int i = 0; i <= around; ++i) block.line[0].push_back(std::numbers::pi * (i - n) / n);
  block.line[1] = {-half_length, half_length};
  block.line[2] = surfaces::graded_to(deep, -std::log(outer), 0, std::log(outer) / deep);
  block.zone_from = {n - around / 6, 0};
  block.zone_to = {n + around / 6, 1};
  block.zone_tag = 7;
  block.map = [](const Vec3& q) {
    const double r = std::exp(-q[2]);
    return Vec3{q[1], -r * std::sin(q[0]), 1 - r * std::cos(q[0])};
  };
  MeshedBody body = meshed(volumes::block(block, VolumeType::hex8), {.shear = young / 2.6, .poisson = poisson});
  body.held_tag = {5};
  body.slide = {{3, 1}, {4, 1}};
  body.contact_tag = {7};
  return body;
}

/// Makes a pin held at a thin hole along its axis.
MeshedBody pin(int around, int deep) {
  constexpr double radius = 1 - clearance;
  surfaces::Block block;
  block.ring = true;
  block.line = {frames::uniform_lines(0, 2 * std::numbers::pi, around),
                {-half_length, half_length},
                frames::uniform_lines(0.02, radius, deep)};
  block.tag = {0, 0, 3, 4, 2, 1};
  block.map = [](const Vec3& q) { return Vec3{q[1], q[2] * std::cos(q[0]), q[2] * std::sin(q[0]) + radius}; };
  MeshedBody body = meshed(volumes::block(block, VolumeType::hex8), {.shear = young / 2.6, .poisson = poisson});
  body.held_tag = {2};
  body.slide = {{3, 1}, {4, 1}};
  body.contact_tag = {1};
  return body;
}

TEST(ConformalFits_long, a_pin_in_a_plate) {
  // Hertz's p0 under the same load is 5, 15 and 30 % less.
  for (const double angle : {20 * degree, 35 * degree, 50 * degree}) {
    const Persson persson(angle);
    const double load = 2 * half_length * clearance * young / (1 - poisson * poisson) / persson.clearance();
    for (const int n : {48, 96}) {
      const MeshedBody body = plate(n, n / 4);
      RollingPair pair(body, pin(n, n / 3), 1);
      pair.frame_from_body(1, 7).friction(0).load(load);
      std::vector<double> gap;
      const SurfaceMesh frame = extremes::top_of(body, 1, 7);
      for (const Vec3& x : frame.node) gap.push_back(clearance * x[2]);
      pair.gap(gap);
      ASSERT_EQ(pair.solve(), ROLLCON_OK) << rollcon_last_caveat();
      const Solution s = pair.solution();
      const double p0 = load / (2 * half_length) * persson.pressure(0);
      double error = 0;
      for (std::size_t k = 0; k < s.nodes(); ++k) {
        const Vec3& x = frame.node[k];
        const double p = load / (2 * half_length) * persson.pressure(std::atan2(x[1], 1 - x[2]));
        error = std::max(error, std::abs(s.pressure[k] - p) / p0);
      }
      const std::string name = "pin, " + std::to_string(static_cast<int>(angle / degree + 0.5)) + " degrees, " +
                               std::to_string(n) + " elements around: ";
      expect_error(name + "reach (radian)", reach_of(s, frame) - angle, 360 * degree / n);
      expect_error(name + "p0", relative(pair.stat("max_pressure"), p0), 0.02 * 48 / n * 48 / n);
      // The greatest error is at the node beside the edge, where pressures rise as a root.
      expect_error(name + "pressure over p0, greatest", error, 0.1);
    }
  }
}

}  // namespace
}  // namespace rollcon::validation
