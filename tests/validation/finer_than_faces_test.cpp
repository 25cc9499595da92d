// Tests frames finer than a body's linear faces: the pressure has no ripples from the facets, whether the gap was
// measured or given.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "support/example1.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace example1 = scenes::example1;

/// Returns the ring's zone by n x n linear quadrilaterals, on the true surface.
SurfaceMesh laid(double zone, int n) {
  const double r = example1::radius, half = example1::width / 2;
  const auto s = frames::uniform_lines(-zone / 2, zone / 2, n);
  const auto y = frames::uniform_lines(-half, half, n);
  return surfaces::transform(frames::rectangle(ElementType::quad4, s, y), [r](const Vec3& x) {
    return Vec3{r * std::sin(x[0] / r), x[1], r * std::cos(x[0] / r)};
  });
}

struct Pressed {
  double middle = 0, ripple = 0;
};

/// Presses the ring; compares around mid-plane with the ellipse of a line contact with the pressure and half-width of
/// quad8.
Pressed press(const MeshedBody& ring, double zone, bool given) {
  constexpr double p0 = 106.8, a = 0.966;
  RollingPair pair(ring, RigidBody{}, 1);
  pair.axes({0, 0, example1::radius}, {1, 0, 0}, {0, 0, 1}).frame(laid(zone, 18));
  pair.friction(0).load(example1::load);
  if (given) pair.gap_quadratic(1 / (2 * example1::radius), 0);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  const Solution s = pair.solution();
  Pressed found;
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    if (std::hypot(s.x[k], s.y[k]) < 1e-6) found.middle = s.pressure[k] / p0;
    if (std::abs(s.y[k]) > 2.01 || std::abs(s.x[k]) > 0.8 * a) continue;
    const double off = s.pressure[k] / (p0 * std::sqrt(1 - s.x[k] * s.x[k] / (a * a))) - 1;
    sum += off * off;
    ++count;
  }
  found.ripple = std::sqrt(sum / count);
  return found;
}

// The pressure in the middle would be 27 % high, with ripples of 18 %, with the gap measured from the facets.
TEST(FinerThanFaces, boundary_elements) {
  const surfaces::Ring shape = example1::bem_ring(6);
  const MeshedBody ring = example1::ring_body(shape, ElementType::quad4);
  const Pressed given = press(ring, shape.zone, true), measured = press(ring, shape.zone, false);
  expect_error("gap given: middle", given.middle - 1, 0.03);
  expect_error("gap given: ripples", given.ripple, 0.04);
  expect_error("gap measured: middle", measured.middle - 1, 0.03);
  expect_error("gap measured: ripples", measured.ripple, 0.04);
  expect_error("measured beside given: middle", measured.middle - given.middle, 1e-3);
}

// The pressure in the middle would be 81 %, with ripples of 12 %, under a given gap if displacements bent with the
// faces alone.
TEST(FinerThanFaces, finite_elements) {
  const surfaces::Ring shape = example1::fem_ring(6);
  const MeshedBody ring = example1::ring_body(shape, VolumeType::hex8);
  const Pressed given = press(ring, shape.zone, true), measured = press(ring, shape.zone, false);
  expect_error("gap given: middle", given.middle - 1, 0.03);
  expect_error("gap given: ripples", given.ripple, 0.05);
  expect_error("gap measured: middle", measured.middle - 1, 0.03);
  expect_error("gap measured: ripples", measured.ripple, 0.05);
  expect_error("measured beside given: middle", measured.middle - given.middle, 1e-3);
}

/// Makes a cube of hex8, 16 faces across its top, finer towards it.
MeshedBody cube() {
  surfaces::Block block;
  block.line[0] = block.line[1] = frames::uniform_lines(-1, 1, 16);
  block.line[2] = surfaces::graded_to(8, -1.5, 0, 0.125);
  MeshedBody body = meshed(volumes::block(block, VolumeType::hex8), {.shear = 2.1e5 / 2.6, .poisson = 0.3});
  body.held_tag = {5};
  body.contact_tag = {6};
  return body;
}

// The error is the root mean square over the middle of the contact, over p0; the ball stands over a node or over the
// middle of a face. With displacements that bend with the faces alone it would be 0.02, 0.05 and 0.07.
TEST(FinerThanFaces, a_ball_on_finite_elements) {
  constexpr double face = 0.125, radius_over_a = 50, modulus = 2.1e5 / (1 - 0.09);
  const MeshedBody body = cube();
  for (const auto& [faces, bound] : {std::pair{0.5, 0.025}, {1.0, 0.05}, {2.0, 0.04}})
    for (const double off : {0.0, 0.5 * face}) {
      const double a = faces * face, radius = radius_over_a * a, p0 = 2 * modulus / (std::numbers::pi * radius_over_a);
      const auto lines = frames::uniform_lines(-1.3 * a, 1.3 * a, 20);
      const SurfaceMesh frame =
          surfaces::transform(frames::rectangle(ElementType::quad4, lines, lines), [&](const Vec3& x) {
            return x + Vec3{off, off, 0};
          });
      RollingPair pair(body, RigidBody{}, 1);
      pair.axes({off, off, 0}, {1, 0, 0}, {0, 0, 1}).frame(frame).friction(0);
      pair.gap_quadratic(1 / (2 * radius), 1 / (2 * radius)).load(4.0 / 3 * modulus * a * a * a / radius);
      EXPECT_EQ(pair.solve(), ROLLCON_OK);
      const Solution s = pair.solution();
      double sum = 0, count = 0;
      for (std::size_t k = 0; k < s.nodes(); ++k) {
        const double r = std::hypot(s.x[k], s.y[k]) / a;
        if (r > 0.8) continue;
        sum += std::pow(s.pressure[k] / p0 - std::sqrt(1 - r * r), 2);
        ++count;
      }
      expect_error("radius of " + std::to_string(faces) + " faces: pressure", std::sqrt(sum / count), bound);
    }
}

}  // namespace
}  // namespace rollcon::validation
