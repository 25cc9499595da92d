// Tests the second example of Rodriguez-Tembleque and Abascal: a finite-element ring rolls on a half-space, exact or a
// block of boundary elements. It is compared with the plane problem, the paper's numbers, and itself on a finer mesh.

#include <map>
#include <string>

#include "support/example2.hpp"
#include "support/mid_plane.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace example2 = scenes::example2;
using example2::Ground;

TEST(RingOnHalfSpace, closed_forms_are_those_of_the_paper) {
  expect_error("Hertz, plane problem: p0, the paper's 107.9 MPa", relative(example2::hertz.p0, 107.9), 1e-3);
  expect_error("Hertz, plane problem: a, the paper's 0.99 mm", relative(example2::hertz.a, 0.99), 5e-3);
  // Pressure stretches the ring's tread, not the stiff ground: the ring turns faster, by eight times the creepage that
  // the force asks for (Bentall and Johnson).
  const double creepage = example2::plane_creepage();
  report("plane problem of these materials: creepage", creepage);
  report("plane problem of equal materials (Carter): creepage", example2::carter_creepage);
  const double vanishing =
      closed_forms::bentall_johnson_vanishing(example2::ring, example2::ground, example2::hertz.a, example2::radius);
  expect_error("creepage between Bentall and Johnson's, force and friction small, and Carter's more",
               (std::abs(creepage) - std::abs(vanishing)) / example2::carter_creepage, 1);
}

TEST(RingOnHalfSpace, rolls_as_the_paper_and_the_plane_problem_say) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  const double creepage = example2::plane_creepage();
  const surfaces::Ring shape = example2::ring_of();
  std::map<Ground, std::map<std::string, double>> found;
  for (const Ground on : {Ground::half_space, Ground::block}) {
    auto pair = example2::pair(shape, VolumeType::hex8, on);
    std::map<std::string, scenes::MidPlane> middle;
    std::map<std::string, double> creep;
    for (const char* scheme : {"characteristic", "least_squares", "godunov"}) {
      pair->option("convection", scheme);
      ASSERT_EQ(pair->solve(), ROLLCON_OK);
      const Solution s = pair->solution();
      const scenes::MidPlane m = scenes::mid_plane(s, shape.zone, example2::width);
      middle[scheme] = m;
      creep[scheme] = s.creep[0];
      const std::string name =
          std::string("2016 hex8 on ") + (on == Ground::block ? "a block" : "the half-space") + ", " + scheme + ": ";
      expect_error(name + "p0 at mid-plane, the paper's 107.9 MPa", relative(m.p0, 107.9), 0.05);
      expect_error(name + "half-width [elements of 0.25 mm]", (m.half_width - example2::hertz.a) / 0.25, 0.5);
      const auto errors = scenes::rolling_errors(
          scenes::found_creepage(s, example2::mu * example2::load, example2::arm), {{creepage, 0}, 0});
      expect_error(name + "creepage, turned like the force, plane problem", errors.force, 0.04);
      expect_error(name + "spin moment", errors.moment, 1e-8);
      expect_error(name + "greatest gap at mid-plane, plane problem",
                   relative(m.gap, example2::hertz.gap(shape.zone / 2)), 0.06);
      expect_error(name + "greatest gap at mid-plane, the paper's 0.0086 mm", relative(m.gap, 0.0086), 0.2);
      // The slip would be 0.02 without any coupling of pressure and slip.
      report(name + "greatest slip velocity [mm/s], the paper's 0.0139", m.slip);
      report(name + "pressure at the free side over that at mid-plane", m.side_pressure / m.p0);
      for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
        expect_error(name + law, pair->stat(law), 1e-8);
    }
    EXPECT_EQ(pair->body_stat(1, "factorizations"), 1);
    EXPECT_EQ(pair->body_stat(1, "condensations"), 1);
    const scenes::MidPlane &g = middle["godunov"], &l = middle["least_squares"];
    expect_error("Godunov beside least squares: p0", relative(g.p0, l.p0), 1e-3);
    expect_error("Godunov beside least squares: slip velocity", relative(g.slip, l.slip), 1e-2);
    expect_error("Godunov beside least squares: creepage", relative(creep["godunov"], creep["least_squares"]), 1e-2);
    found[on] = {{"p0", l.p0}, {"slip", l.slip}, {"creep", creep["characteristic"]}};
  }
  for (const char* what : {"p0", "slip", "creep"})
    expect_error(std::string("half-space by 288 quadrilaterals on a block, exact one: ") + what,
                 relative(found[Ground::block][what], found[Ground::half_space][what]), 0.02);
}

}  // namespace
}  // namespace rollcon::validation
