/// Compares triads, areas and resultants of curved frames with closed forms of a cylinder.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "contact/convection/convection.hpp"
#include "contact/problem/problem.hpp"
#include "support/error.hpp"
#include "support/frames.hpp"

namespace rollcon {
namespace {

constexpr double radius = 2, half_angle = 0.6, half_width = 0.5;
constexpr ElementType types[] = {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                 ElementType::quad9};

// Puts nodes on the cylinder, from (angle, width, 0): it touches the plane z = 0 from below.
Vec3 on_cylinder(const Vec3& p) {
  return {radius * std::sin(p[0]), p[1], radius * (std::cos(p[0]) - 1)};
}

Frame cylinder(ElementType type, int n, const Axes& axes = {}) {
  const std::vector<double> along = frames::uniform_lines(-half_angle, half_angle, n);
  const std::vector<double> across = frames::uniform_lines(-half_width, half_width, 2);
  const SurfaceMesh plane = frames::rectangle(type, along, across);
  Frame frame = build_frame(frames::transform(plane, on_cylinder), axes);
  std::vector<Vec3> normal;
  for (const Vec3& p : plane.node)  // normals of any length
    normal.push_back((1 + p[0] * p[0]) * Vec3{std::sin(p[0]), 0, std::cos(p[0])});
  curve_frame(frame, normal);
  return frame;
}

struct Sums {
  double area, normal_force, along_force, moment;
};

Sums sums_on(const Frame& frame) {
  Problem problem;
  take_frame(problem, frame);
  const auto n = static_cast<std::size_t>(frame.nodes());
  const auto load = [&](int component, int motion) {
    std::vector<double> lambda[3];
    for (auto& l : lambda) l.assign(n, 0.0);
    lambda[component].assign(n, 1.0);
    problem.convection.slip_x = frame.x;
    problem.convection.slip_y = frame.y;
    return load_on_body1(problem, motion, lambda).value;
  };
  double moment = 0;  // moment about t2, of a unit traction along t1 everywhere
  for (std::size_t k = 0; k < n; ++k)
    moment += problem.moment_z[k] * problem.turn[k][0][0] - problem.moment_x[k] * problem.turn[k][0][2];
  return {frame.area, -load(2, approach), load(0, xi1), moment};
}

TEST(curved_frame, area_and_resultants_of_a_cylinder) {
  const double s = std::sin(half_angle), width = 2 * half_width;
  const Sums exact{2 * half_angle * radius * width, 2 * radius * s * width, 2 * radius * s * width,
                   width * radius * 2 * radius * (half_angle - s)};
  for (const ElementType type : types) {
    const int steps[] = {4, 8, 16};
    double error[3][4];
    for (int i = 0; i < 3; ++i) {
      const Frame frame = cylinder(type, steps[i]);
      const Sums found = sums_on(frame);
      error[i][0] = std::abs(found.area / exact.area - 1);
      error[i][1] = std::abs(found.normal_force / exact.normal_force - 1);
      error[i][2] = std::abs(found.along_force / exact.along_force - 1);
      error[i][3] = std::abs(found.moment / exact.moment - 1);
      double cells = 0, weights = 0;
      for (const double a : frame.cell_area) cells += a;
      for (const double w : frame.weight) weights += w;
      EXPECT_NEAR(cells, frame.area, 1e-13 * frame.area);
      EXPECT_NEAR(weights, frame.area, 1e-13 * frame.area);
    }
    // Flat facets are of second order, quadratic elements of fourth. The moment is a small difference. The coarsest
    // mesh has measured errors of 1.1e-2 and 0.14; quadratic 1.7e-5 and 1.6e-4.
    const bool quadratic = is_quadratic(type);
    const double order_bound = quadratic ? 3.9 : 1.9;
    const double force_bound = quadratic ? 2.5e-5 : 1.5e-2, moment_bound = quadratic ? 2.5e-4 : 0.2;
    static constexpr const char* names[] = {"area", "normal force", "force along", "moment"};
    for (int q = 0; q < 4; ++q) {
      const double bound = q == 3 ? moment_bound : force_bound;
      const double order = std::log2(error[1][q] / error[2][q]);
      std::printf("type %d %-12s error %.1e %.1e %.1e (bound of the first %.0e), order %.2f (at least %.1f)\n",
                  static_cast<int>(type), names[q], error[0][q], error[1][q], error[2][q], bound, order, order_bound);
      EXPECT_LT(error[0][q], bound);
      EXPECT_GT(order, order_bound);
    }
  }
}

TEST(curved_frame, triads_follow_the_surface) {
  const Axes turned{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};  // rolling along the axle
  for (const Axes& axes : {Axes{}, turned}) {
    const Frame frame = cylinder(ElementType::quad9, 8, axes);
    ASSERT_TRUE(frame.curved());
    double worst = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(frame.nodes()); ++k) {
      const Triad t = frame.triad(k);
      const double x = frame.mesh.node[k][0] / radius;  // sine of the angle
      const Vec3 n{x, 0, std::sqrt(1 - x * x)};
      const Vec3 along = axes.t1[0] == 1 ? Vec3{n[2], 0, -n[0]} : Vec3{0, 1, 0};
      worst = std::max({worst, length(t.n - n), length(t.t1 - along), length(t.t2 - cross(t.n, t.t1)),
                        std::abs(dot(t.t2, axes.t1))});
    }
    std::printf("triads: error %.1e (bound 1e-14)\n", worst);
    EXPECT_LT(worst, 1e-14);
  }
}

// A displacement grows by one with the distance in the projection, and along the surface by the cosine.
TEST(curved_frame, derivatives_are_taken_along_the_surface) {
  const Frame frame = cylinder(ElementType::quad4, 10);
  const auto n = static_cast<std::size_t>(frame.nodes());
  for (const Scheme scheme : {scheme_of("least_squares"), Scheme::characteristic}) {
    const Convection convection = make_convection(frame, scheme, false);
    std::vector<double> w(3 * n, 0.0), ahead(3 * n, 0.0), slip[2];
    for (std::size_t k = 0; k < n; ++k) {
      w[3 * k] = frame.x[k];
      if (!convection.ahead.empty()) ahead[3 * k] = frame.x[k] + convection.ahead[k];
    }
    convect(convection, w.data(), ahead.data(), slip);
    double worst = 0;
    int rows = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (convection.rows.start[k] == convection.rows.start[k + 1]) continue;
      const double sine = frame.mesh.node[k][0] / radius;
      worst = std::max(worst, std::abs(slip[0][k] + std::sqrt(1 - sine * sine)));
      ++rows;
    }
    std::printf("%s: %d rows, error %.1e (bound 1e-12)\n", scheme.name, rows, worst);
    EXPECT_GE(rows, 30);
    EXPECT_LT(worst, 1e-12);
  }
}

TEST(curved_frame, normals_of_the_axes_leave_it_flat) {
  const SurfaceMesh mesh =
      frames::rectangle(ElementType::quad4, frames::uniform_lines(0, 1, 2), frames::uniform_lines(0, 1, 2));
  Frame frame = build_frame(mesh, {});
  const std::vector<double> weight = frame.weight;
  std::vector<Vec3> normal(mesh.node.size(), Vec3{1e-13, 0, 3});
  curve_frame(frame, normal);
  EXPECT_FALSE(frame.curved());
  EXPECT_EQ(frame.weight, weight);
  normal[3] = {1e-6, 0, 1};
  curve_frame(frame, normal);
  EXPECT_TRUE(frame.curved());
}

TEST(curved_frame, steep_surfaces_are_refused) {
  SurfaceMesh mesh =
      frames::rectangle(ElementType::quad4, frames::uniform_lines(0, 1, 2), frames::uniform_lines(0, 1, 2));
  mesh.index_base = 1;
  Frame frame = build_frame(mesh, {});
  std::vector<Vec3> normal(mesh.node.size(), Vec3{0, 0, 1});
  normal[4] = {std::sin(1.05), 0, std::cos(1.05)};  // 60.2 degrees
  normal[7] = {0, 1, -1};
  try {
    curve_frame(frame, normal);
    FAIL() << "not refused";
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_mesh);
    const std::string text = e.what();
    EXPECT_NE(text.find("2 node(s)"), std::string::npos) << text;
    EXPECT_NE(text.find("first: node 5"), std::string::npos) << text;
    EXPECT_NE(text.find("rollcon_contact_set_axes"), std::string::npos) << text;
  }
  EXPECT_FALSE(frame.curved());
}

}  // namespace
}  // namespace rollcon
