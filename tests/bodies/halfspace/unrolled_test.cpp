/// Tests half-spaces under a frame that follows a cylinder: reciprocity, and the plane as its limit.

#include "bodies/halfspace/unrolled.hpp"

#include "mesh/section_line.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr HalfspaceConstants unlike{1.0, 0.6, 0.35}, like{1.0, 0.6, 0};
constexpr int along = 6, across = 10;

/// Puts nodes at equal arc lengths on a cylinder about the rolling direction; half the arc is 1.
Frame on_cylinder(double radius) {
  SurfaceMesh mesh =
      frames::rectangle(ElementType::quad4, frames::uniform_lines(-1, 1, along), frames::uniform_lines(-1, 1, across));
  std::vector<Vec3> normal;
  std::vector<SectionLine::Place> place;
  for (Vec3& x : mesh.node) {
    const double angle = x[1] / radius;
    x = {x[0], radius * std::sin(angle), radius * (1 - std::cos(angle))};
    normal.push_back({0, -std::sin(angle), std::cos(angle)});
    if (place.empty() || x[1] > place.back().y + 1e-9) place.push_back({x[1], x[2], angle});
  }
  Frame frame = build_frame(std::move(mesh), {});
  curve_frame(frame, normal);
  frame.section = std::make_shared<const SectionLine>(place);
  return frame;
}

/// Holds a[i][j][n * p + k].
struct Rows {
  Rows(const Frame& frame, const HalfspaceConstants& constants) {
    const auto compliance = make_halfspace_compliance(frame, constants, 1e-10, 1);
    const auto n = static_cast<std::size_t>(frame.nodes());
    ComplianceBlock out;
    out.stride = static_cast<std::ptrdiff_t>(n);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        a[i][j].resize(n * n);
        out.a[i][j] = a[i][j].data();
      }
    compliance->block({frame.x, frame.y}, out);
    std::vector<double> traction(3 * n), u(3 * n);
    for (std::size_t k = 0; k < traction.size(); ++k) traction[k] = std::sin(1.7 * static_cast<double>(k));
    compliance->apply({frame.x, frame.y}, traction.data(), u.data());
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t i = 0; i < 3; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t j = 0; j < 3; ++j) sum += a[i][j][n * p + k] * traction[3 * k + j];
        applied = std::max(applied, std::abs(u[3 * p + i] - sum));
      }
  }
  std::vector<double> a[3][3];
  double applied = 0;  ///< difference of apply() from the rows
};

// Inner nodes have the same hats: what one moves at another is what that moves at the first.
TEST(unrolled, is_reciprocal) {
  const Frame frame = on_cylinder(1.2);
  const Rows rows(frame, unlike);
  const auto n = static_cast<std::size_t>(frame.nodes());
  double worst = 0, largest = 0, coupling = 0;
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t k = 0; k < n; ++k) {
      if (frame.rim[p] || frame.rim[k]) continue;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          largest = std::max(largest, std::abs(rows.a[i][j][n * p + k]));
          worst = std::max(worst, std::abs(rows.a[i][j][n * p + k] - rows.a[j][i][n * k + p]));
          if (i == 1 && j == 2) coupling = std::max(coupling, std::abs(rows.a[i][j][n * p + k]));
        }
    }
  expect_error("arc of 95 degrees: reciprocity over the largest entry", worst / largest, 1e-9);
  expect_error("arc of 95 degrees: apply() beside the rows", rows.applied, 1e-12);
  EXPECT_GT(coupling, 0.01 * largest);
}

TEST(unrolled, tends_to_the_plane_with_the_square_of_its_angle) {
  Frame plane = on_cylinder(1e6);
  plane.section.reset();
  const Rows flat(plane, like);
  double before = 0;
  for (const double radius : {50.0, 100.0}) {
    const Rows bent(on_cylinder(radius), like);
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t m = 0; m < flat.a[i][i].size(); ++m)
        worst = std::max(worst, std::abs(bent.a[i][i][m] - flat.a[i][i][m]));
    report("radius " + std::to_string(radius) + ": direct entries off those of the plane", worst);
    if (before > 0) expect_order("direct entries", observed_order(before, worst, 2, 1), 1.9);
    before = worst;
  }
}

}  // namespace
}  // namespace rollcon
