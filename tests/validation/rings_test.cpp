// The first example of Rodriguez-Tembleque and Abascal: two equal boundary-element rings roll on
// each other. Against the plane problem (Hertz, Carter), the paper's numbers, and itself on finer
// meshes.

#include <algorithm>
#include <map>

#include "support/example1.hpp"
#include "validation/report.hpp"

namespace rollcon::validation {
namespace {

namespace example1 = scenes::example1;

struct MidPlane {
  double p0 = 0, half_width = 0, side_pressure = 0, slip = 0;
};

MidPlane mid_plane(const scenes::Solution& s) {
  MidPlane m;
  double xx = 0, pp = 0, x2 = 0, x4 = 0, count = 0;  // fit of p^2 = p0^2 (1 - x^2/a^2)
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    // Godunov's cells end at the outflow rim and double the slip there, well outside the contact.
    if (std::abs(s.x[k]) < 0.45 * example1::paper_ring().zone)
      m.slip = std::max(m.slip, std::hypot(s.slip[k][0], s.slip[k][1]));
    if (std::abs(std::abs(s.y[k]) - example1::width / 2) < 1e-6)
      m.side_pressure = std::max(m.side_pressure, s.pressure[k]);
    if (std::abs(s.y[k]) > 1e-6 || !(s.pressure[k] > 0)) continue;
    m.p0 = std::max(m.p0, s.pressure[k]);
    const double q = s.pressure[k] * s.pressure[k], u = s.x[k] * s.x[k];
    xx += u, pp += q, x2 += u * q, x4 += u * u, ++count;
  }
  const double slope = (count * x2 - xx * pp) / (count * x4 - xx * xx);
  m.half_width = std::sqrt((pp - slope * xx) / count / -slope);
  return m;
}

TEST(Rings, roll_as_the_paper_and_the_plane_problem_say) {
  auto pair = example1::pair(example1::paper_ring(), ElementType::quad4, "characteristic");
  const closed_forms::HertzLine hertz = closed_forms::hertz_line_from_load(
      example1::radius / 2, closed_forms::effective_modulus(example1::material, example1::material),
      example1::load / example1::width);
  expect_error("closed form beside the paper: p0 103.87 MPa", relative(hertz.p0, 103.87), 1e-4);
  expect_error("closed form beside the paper: a 0.9453 mm", relative(hertz.a, 0.9453), 1e-4);
  std::map<std::string, MidPlane> found;
  for (const char* scheme : {"characteristic", "least_squares", "godunov"}) {
    pair->option("convection", scheme);
    ASSERT_EQ(pair->solve(), ROLLCON_OK) << "the contact ends at the rings' own edges";
    const scenes::Solution s = pair->solution();
    const MidPlane m = found[scheme] = mid_plane(s);
    const std::string name = std::string("1472 quad4, ") + scheme + ": ";
    expect_error(name + "p0 at mid-plane, plane problem", relative(m.p0, hertz.p0), 0.05);
    expect_error(name + "half-width [elements of 0.2 mm]", (m.half_width - hertz.a) / 0.2, 1);
    expect_error(name + "creepage, Carter at the same force",
                 relative(s.creep[0], example1::carter_creepage), 0.05);
    expect_error(name + "greatest slip velocity, the paper's 0.0428 mm/s", relative(m.slip, 0.0428),
                 0.05);
    expect_error(name + "pressure at the free side over that at mid-plane, 0.70",
                 m.side_pressure / m.p0 - 0.70, 0.05);
    for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
      expect_error(name + law, pair->stat(law), 1e-8);
    EXPECT_EQ(pair->body_stat(1, "assemblies"), 1);
    EXPECT_EQ(pair->body_stat(1, "factorizations"), 1);
    EXPECT_EQ(pair->body_stat(1, "condensations"), 1) << "the equal body shares them";
  }
  expect_error("Godunov beside least squares: p0",
               relative(found["godunov"].p0, found["least_squares"].p0), 1e-3);
  expect_error("Godunov beside least squares: slip velocity",
               relative(found["godunov"].slip, found["least_squares"].slip), 1e-3);
}

TEST(Rings, quadratic_elements_agree) {
  surfaces::Ring shape = example1::paper_ring();
  shape.around = 24, shape.zone_around = 6, shape.across = 6, shape.deep = 2;
  auto pair = example1::pair(shape, ElementType::quad8, "characteristic");
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  const scenes::Solution s = pair->solution();
  const MidPlane m = mid_plane(s);
  expect_error("quad8, 6 x 6: p0 at mid-plane, plane problem", relative(m.p0, example1::hertz_p0),
               0.05);
  expect_error("quad8, 6 x 6: half-width [elements of 0.4 mm]",
               (m.half_width - example1::hertz_a) / 0.4, 1);
  expect_error("quad8, 6 x 6: creepage, Carter", relative(s.creep[0], example1::carter_creepage),
               0.05);
}

TEST(Rings, new_creepages_need_no_assembly) {
  auto pair = example1::pair(example1::paper_ring(), ElementType::quad4, "characteristic");
  pair->creep(-1.4e-3, 0, 0);
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  pair->creep(-1.5e-3, 1e-4, 0);
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  EXPECT_EQ(pair->stat("compliance_assemblies"), 1);
  for (const char* count : {"assemblies", "factorizations", "condensations"})
    EXPECT_EQ(pair->body_stat(1, count), 1) << count;
}

}  // namespace
}  // namespace rollcon::validation
