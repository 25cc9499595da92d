/// Tests frames that the library makes for callers: what they cover, their elements, refusals.

#include "framing/makers.hpp"

#include "rollcon.h"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using std::numbers::pi;

const Axes turned_axes{{1, 2, 3}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};

TEST(makers, rectangles_of_every_element_cover_their_bounds) {
  for (const ElementType type :
       {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    const Frame frame = build_frame(rectangle_mesh(turned_axes, type, 4, 3, {-1, 3, -2, 0}), turned_axes);
    EXPECT_NEAR(frame.area, 8, 1e-13);
    EXPECT_EQ(frame.elements(), corner_count(type) == 3 ? 24 : 12);
    EXPECT_EQ(std::count(frame.used.begin(), frame.used.end(), 0), 0);
    const auto [left, right] = std::minmax_element(frame.x.begin(), frame.x.end());
    const auto [low, high] = std::minmax_element(frame.y.begin(), frame.y.end());
    EXPECT_EQ(std::vector({*left, *right, *low, *high}), (std::vector<double>{-1, 3, -2, 0}));
    // The nodes come line by line from the least y.
    EXPECT_TRUE(std::is_sorted(frame.y.begin(), frame.y.end()));
  }
}

TEST(makers, strips_of_an_ellipse_end_at_its_edge) {
  const double a = 3, b = 0.5;
  for (const double angle : {0.0, 0.3, pi / 2, 2.5}) {
    std::vector<double> lack;
    for (const int n : {8, 16, 32}) {
      const Frame frame = build_frame(strips_mesh(turned_axes, strips_of_ellipse(a, b, angle, n), n), turned_axes);
      double worst = 0;
      for (std::size_t k = 0; k < frame.x.size(); ++k) {
        const double u = frame.x[k] * std::cos(angle) + frame.y[k] * std::sin(angle);
        const double v = frame.y[k] * std::cos(angle) - frame.x[k] * std::sin(angle);
        const double r = std::hypot(u / a, v / b);
        worst = std::max(worst, frame.rim[k] ? std::abs(r - 1) : r - 1);
      }
      EXPECT_LE(worst, 1e-12) << angle << ' ' << n;
      lack.push_back(1 - frame.area / (pi * a * b));
    }
    expect_order("area of strips at angle " + std::to_string(angle), observed_order(lack[1], lack[2], 2, 1), 1.9);
  }
}

// Nodes of the coarser of two frames, one twice as fine, are nodes of the finer.
TEST(makers, halved_strips_are_nested) {
  const SurfaceMesh coarse = strips_mesh({}, strips_of_ellipse(2, 1, 0.4, 6), 8);
  const SurfaceMesh fine = strips_mesh({}, strips_of_ellipse(2, 1, 0.4, 12), 16);
  for (const Vec3& x : coarse.node) {
    double nearest = INFINITY;
    for (const Vec3& y : fine.node) nearest = std::min(nearest, std::hypot(x[0] - y[0], x[1] - y[1]));
    EXPECT_LE(nearest, 1e-14);
  }
}

TEST(makers, strips_may_end_in_lines) {
  const std::vector<Strip> strip{{-1, -1, 1}, {0, -2, 2}, {1, 0.5, 0.5}};
  const Frame frame = build_frame(strips_mesh({}, strip, 4), {});
  EXPECT_NEAR(frame.area, 3 + 2, 1e-14);
  EXPECT_EQ(frame.nodes(), 5 + 5 + 1);
}

using scenes::RollingPair;
const closed_forms::Elastic steel{.shear = 82000, .poisson = 0.28};

TEST(makers, contacts_solve_on_what_callers_ask_for) {
  RollingPair pair(steel, steel);
  const auto hertz = closed_forms::hertz_from_axes(2, 1, 1000, closed_forms::effective_modulus(steel, steel));
  pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(0.3).creep(1e-4, 0, 0);
  ASSERT_EQ(rollcon_contact_frame_ellipse(pair.handle(), 24, 16, 2, 1, 0), ROLLCON_OK);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  const double on_ellipse = pair.solution().force[0];
  expect_error("approach on an ellipse of 24 x 16", relative(pair.solution().approach, hertz.approach), 1e-3);
  ASSERT_EQ(rollcon_contact_frame_rectangle(pair.handle(), ROLLCON_QUAD4, 40, 40, -2.4, 2.4, -1.2, 1.2), ROLLCON_OK);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  expect_error("force on 40 x 40 beside that on the ellipse", relative(pair.solution().force[0], on_ellipse), 0.02);
  const double line[5][3] = {{-1, 0, 0}, {-0.6, -1.6, 1.6}, {0, -2, 2}, {0.6, -1.6, 1.6}, {1, 0, 0}};
  ASSERT_EQ(rollcon_contact_frame_strips(pair.handle(), 8, 5, line[0]), ROLLCON_OK);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  expect_error("force on 8 x 4 strips", relative(pair.solution().force[0], on_ellipse), 0.1);
}

TEST(makers, a_frame_that_cuts_the_contact_off_is_told) {
  RollingPair pair(steel, steel);
  const auto hertz = closed_forms::hertz_from_axes(2, 1, 1000, closed_forms::effective_modulus(steel, steel));
  pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(0);
  const int sizes[3][2] = {{6, 4}, {12, 8}, {24, 16}};
  for (const auto& [along, across] : sizes) {
    for (const double part : {1.0, 1.05, 1.2}) {
      ASSERT_EQ(rollcon_contact_frame_ellipse(pair.handle(), along, across, 2 * part, part, 0), ROLLCON_OK);
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << along << ' ' << part;
    }
    for (const double part : {0.7, 0.5}) {
      ASSERT_EQ(rollcon_contact_frame_ellipse(pair.handle(), along, across, 2 * part, part, 0), ROLLCON_OK);
      EXPECT_EQ(pair.solve(), ROLLCON_RIM_CONTACT) << along << ' ' << part;
    }
  }
}

// Every procedure knows where such frames end.
TEST(makers, published_procedures_solve_on_strips) {
  if (!rollcon_has_feature("procedures")) GTEST_SKIP() << "this build has no published procedures";
  const auto hertz = closed_forms::hertz_from_axes(2, 1, 1000, closed_forms::effective_modulus(steel, steel));
  double standard = 0;
  for (const char* jacobian : {"exact", "b_derivative"})
    for (const char* system : {"condensed", "monolithic"}) {
      RollingPair pair(steel, steel);
      pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(0.3).creep(1e-4, 0, 0);
      pair.option("procedure", (std::string("system=") + system + " jacobian=" + jacobian).c_str());
      ASSERT_EQ(rollcon_contact_frame_ellipse(pair.handle(), 12, 8, 2, 1, 0), ROLLCON_OK);
      EXPECT_EQ(pair.solve(), ROLLCON_OK) << jacobian << ' ' << system;
      const double force = pair.solution().force[0];
      if (standard == 0) standard = force;
      expect_error(std::string(jacobian) + ", " + system, relative(force, standard), 1e-6);
    }
}

void expect_refused(std::int32_t status, const char* words) {
  EXPECT_EQ(status, ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(std::string(rollcon_last_error()).find(words), std::string::npos) << rollcon_last_error();
}

TEST(makers, refusals_name_the_entry_and_leave_the_frame) {
  RollingPair pair(steel, steel);
  rollcon_contact* c = pair.handle();
  ASSERT_EQ(rollcon_contact_frame_ellipse(c, 4, 4, 2, 1, 0), ROLLCON_OK);
  expect_refused(rollcon_contact_frame_rectangle(c, 1, 4, 4, 0, 1, 0, 1), "type is 1;");
  expect_refused(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, 0, 4, 0, 1, 0, 1), "nx is 0; allowed: 1 to");
  expect_refused(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD9, 30000, 30000, 0, 1, 0, 1), "3600120001 nodes");
  expect_refused(rollcon_contact_frame_rectangle(c, ROLLCON_QUAD4, 4, 4, 0, 1, 1, 1), "y_least is 1 and y_greatest");
  expect_refused(rollcon_contact_frame_ellipse(c, 1, 4, 2, 1, 0), "along is 1; allowed: 2 to");
  expect_refused(rollcon_contact_frame_ellipse(c, 4, 4, 2, 0, 0), "b is 0; allowed: > 0");
  const double falling[3][3] = {{0, 0, 0}, {2, -1, 1}, {1, 0, 0}}, empty[3][3] = {{0, 0, 0}, {1, 1, 1}, {2, 0, 0}};
  expect_refused(rollcon_contact_frame_strips(c, 4, 3, falling[0]), "y of lines 1 and 2");
  expect_refused(rollcon_contact_frame_strips(c, 4, 3, empty[0]), "line 1 (counting from 0) goes from 1 to 1");
  expect_refused(rollcon_contact_frame_strips(c, 4, 3, nullptr), "lines is NULL");
  EXPECT_EQ(rollcon_contact_frame_ellipse(c, 4, 4, NAN, 1, 0), ROLLCON_ERR_NONFINITE);
  std::int64_t nodes = 0;
  EXPECT_EQ(rollcon_contact_get_size(c, &nodes, nullptr), ROLLCON_OK);
  EXPECT_EQ(nodes, 2 + 3 * 5);
}

}  // namespace
}  // namespace rollcon
