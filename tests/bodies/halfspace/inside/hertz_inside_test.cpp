// Compares Hertz's pressures on circle and strip with closed forms below them, and with the largest von Mises and shear
// stresses.

#include "bodies/halfspace/inside/direct.hpp"
#include "support/frames.hpp"
#include "support/stress_invariants.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using inside::Solid;
using inside::Values;

std::vector<double> pressures(const Frame& frame, double (*p)(double x, double y)) {
  std::vector<double> t;
  for (std::size_t k = 0; k < frame.x.size(); ++k) t.insert(t.end(), {0, 0, p(frame.x[k], frame.y[k])});
  return t;
}

/// Makes rings of quadratic triangles graded to the edge of the unit circle.
Frame disc() {
  const std::vector<double> radius = frames::contact_radii(1, 12, 1);
  const SurfaceMesh linear = frames::ring_disc(ElementType::tri3, radius, frames::ring_counts(radius));
  return build_frame(frames::to_quadratic(linear, ElementType::tri6), Axes{});
}

TEST(inside_hertz, circle_axis_matches_closed_form) {
  const Solid solid{1, 0.3};
  const Frame frame = disc();
  const std::vector<double> t =
      pressures(frame, [](double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); });
  std::vector<std::array<double, 3>> points;
  for (int k = 0; k <= 150; ++k) points.push_back({0, 0, 0.02 * k});
  const std::vector<Values> s = inside::from_library(frame, t, solid, points, 1e-5);
  double worst = 0, mises = 0, shear = 0, depth = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    // The closed form is Johnson (3.45).
    const double z = points[p][2];
    const double arctan = z > 0 ? z * std::atan(1 / z) : 0;
    const double radial = -(1 + solid.poisson) * (1 - arctan) + 0.5 / (1 + z * z), axial = -1 / (1 + z * z);
    worst = std::max({worst, std::abs(s[p][0] - radial), std::abs(s[p][1] - radial), std::abs(s[p][2] - axial)});
    const StressInvariants v = stress_invariants(s[p].data());
    if (v.von_mises > mises) mises = v.von_mises, depth = z;
    shear = std::max(shear, v.shear);
  }
  std::printf("circle: von Mises %.4f, shear %.4f at z = %.2f\n", mises, shear, depth);
  expect_error("Hertz circle, stresses on the axis, over p0", worst, 8e-5);
  expect_error("Hertz circle, largest von Mises stress, .620 p0", relative(mises, 0.620), 2.4e-4);
  expect_error("Hertz circle, largest shear stress, .310 p0", relative(shear, 0.310), 2.4e-4);
  expect_error("Hertz circle, its depth, .48 a", depth - 0.48, 0.021);
}

TEST(inside_hertz, line_contact_matches_closed_form) {
  // A strip 600 a long has the stresses of plane strain at its middle, to about 0.4 a/L.
  const Solid solid{1, 0.3};
  std::vector<double> x = frames::cosine_lines(1, 24), y;
  for (int k = -12; k <= 12; ++k) y.push_back(std::copysign(300.0 * std::pow(std::abs(k) / 12.0, 2), k));
  const Frame frame = build_frame(frames::rectangle(ElementType::quad9, x, y), Axes{});
  const std::vector<double> t = pressures(frame, [](double u, double) { return std::sqrt(std::max(0.0, 1 - u * u)); });
  std::vector<std::array<double, 3>> points;
  for (int k = 1; k <= 150; ++k) points.push_back({0, 0, 0.02 * k});
  const std::vector<Values> s = inside::from_library(frame, t, solid, points, 1e-5);
  double worst = 0, shear = 0, depth = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    // The closed form is Johnson (4.46).
    const double z = points[p][2], root = std::sqrt(1 + z * z);
    worst = std::max({worst, std::abs(s[p][0] + (1 + 2 * z * z) / root - 2 * z), std::abs(s[p][2] + 1 / root)});
    const double in_plane = 0.5 * std::abs(s[p][0] - s[p][2]);
    if (in_plane > shear) shear = in_plane, depth = z;
  }
  std::printf("line: shear %.4f at z = %.3f\n", shear, depth);
  expect_error("Hertz line, stresses on the axis, over p0", worst, 2e-3);
  expect_error("Hertz line, largest shear stress, .300 p0", relative(shear, 0.300), 5e-3);
  expect_error("Hertz line, its depth, .786 a", depth - 0.786, 0.021);
}

}  // namespace
}  // namespace rollcon
