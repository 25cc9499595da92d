// Tests the first example of Rodriguez-Tembleque and Abascal: two equal boundary-element rings roll on each other. They
// are compared with the paper's numbers, Hertz, fine meshes, and finite elements.

#include <map>
#include <string>
#include <utility>

#include "support/example1.hpp"
#include "support/mid_plane.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace example1 = scenes::example1;

scenes::MidPlane mid_plane(const Solution& s) {
  return scenes::mid_plane(s, example1::paper_ring().zone, example1::width);
}

scenes::RollingErrors errors_of(const Solution& s) {
  return scenes::rolling_errors(scenes::found_creepage(s, example1::mu * example1::load, example1::arm),
                                {{example1::fine_creepage, 0}, 0});
}

TEST(Rings, roll_as_the_paper_and_fine_meshes_say) {
  auto pair = example1::pair(example1::paper_ring(), ElementType::quad4, "characteristic");
  const closed_forms::HertzLine hertz = closed_forms::hertz_line_from_load(
      example1::radius / 2, closed_forms::effective_modulus(example1::material, example1::material),
      example1::load / example1::width);
  expect_error("closed form beside the paper: p0 103.87 MPa", relative(hertz.p0, 103.87), 1e-4);
  expect_error("closed form beside the paper: a 0.9453 mm", relative(hertz.a, 0.9453), 1e-4);
  std::map<std::string, scenes::MidPlane> found;
  for (const char* scheme : {"characteristic", "least_squares", "godunov"}) {
    pair->option("convection", scheme);
    ASSERT_EQ(pair->solve(), ROLLCON_OK) << "the contact ends at the rings' own edges";
    const Solution s = pair->solution();
    const scenes::MidPlane m = found[scheme] = mid_plane(s);
    const std::string name = std::string("1472 quad4, ") + scheme + ": ";
    expect_error(name + "p0 at mid-plane, fine meshes", relative(m.p0, example1::fine_p0), 0.003);
    expect_error(name + "half-width [elements of 0.2 mm]", (m.half_width - hertz.a) / 0.2, 1);
    const auto errors = errors_of(s);
    expect_error(name + "creepage, turned like the force, fine meshes", errors.force, 0.016);
    expect_error(name + "spin moment", errors.moment, 1e-7);
    expect_error(name + "greatest slip velocity, the paper's 0.0428 mm/s", relative(m.slip, 0.0428), 0.05);
    expect_error(name + "pressure at the free side over that at mid-plane, 0.70", m.side_pressure / m.p0 - 0.70, 0.05);
    for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
      expect_error(name + law, pair->stat(law), 1e-8);
    EXPECT_EQ(pair->body_stat(1, "assemblies"), 1);
    EXPECT_EQ(pair->body_stat(1, "factorizations"), 1);
    EXPECT_EQ(pair->body_stat(1, "condensations"), 1) << "the equal body shares them";
  }
  expect_error("Godunov beside least squares: p0", relative(found["godunov"].p0, found["least_squares"].p0), 1e-3);
  expect_error("Godunov beside least squares: slip velocity",
               relative(found["godunov"].slip, found["least_squares"].slip), 1e-3);
}

// The greatest gap and slip velocity of the paper are those of a zone of 3 mm, which it does not state.
TEST(Rings, gap_of_the_paper) {
  surfaces::Ring shape = example1::paper_ring();
  shape.zone = 3;
  auto pair = example1::pair(shape, ElementType::quad4, "least_squares");
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  const scenes::MidPlane m = scenes::mid_plane(pair->solution(), shape.zone, example1::width);
  expect_error("zone of 3 mm: greatest gap, the paper's 0.0156 mm", relative(m.gap, 0.0156), 0.02);
  expect_error("zone of 3 mm: greatest slip velocity, the paper's 0.0428 mm/s", relative(m.slip, 0.0428), 0.02);
}

// Equal bodies cancel what pressure does to the slip; finite on boundary elements leave the difference of their errors,
// a few per cent of strains three times as large as the creepage.
TEST(Rings_long, by_finite_and_by_boundary_elements) {
  for (const int parts : {8, 12}) {
    const auto fem = example1::ring_body(example1::fem_ring(parts), VolumeType::hex8);
    const auto bem = example1::ring_body(example1::bem_ring(parts), ElementType::quad4);
    std::map<std::string, std::pair<double, double>> found;
    for (const auto& [name, second] : {std::pair<std::string, scenes::AnyBody>{"FEM on FEM", scenes::TwinBody{}},
                                       {"FEM on BEM", bem},
                                       {"BEM on BEM", scenes::TwinBody{}}}) {
      auto pair = example1::pair(name[0] == 'F' ? fem : bem, second, "least_squares");
      // Unlike meshes are told.
      ASSERT_EQ(pair->solve(), name == "FEM on BEM" ? ROLLCON_INACCURATE : ROLLCON_OK) << name;
      const Solution s = pair->solution();
      found[name] = {mid_plane(s).p0, s.creep[0]};
      const std::string what = name + ", zone " + std::to_string(parts) + " x " + std::to_string(parts) + ": ";
      expect_error(what + "p0, fine meshes", relative(found[name].first, example1::fine_p0),
                   parts < 12 ? 0.022 : 0.005);
      expect_error(what + "creepage, fine meshes", relative(found[name].second, example1::fine_creepage),
                   parts < 12 ? 0.2 : 0.08);
    }
    for (const char* name : {"FEM on FEM", "FEM on BEM"})
      expect_error(std::string(name) + ": p0 beside BEM on BEM", relative(found[name].first, found["BEM on BEM"].first),
                   parts < 12 ? 0.04 : 0.02);
  }
}

TEST(Rings_long, quadratic_elements_agree) {
  surfaces::Ring shape = example1::paper_ring();
  shape.around = 24, shape.zone_around = 6, shape.across = 6, shape.deep = 2;
  auto pair = example1::pair(shape, ElementType::quad8, "characteristic");
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  const Solution s = pair->solution();
  const scenes::MidPlane m = mid_plane(s);
  expect_error("quad8, 6 x 6: p0 at mid-plane, fine meshes", relative(m.p0, example1::fine_p0), 0.0035);
  expect_error("quad8, 6 x 6: half-width [elements of 0.4 mm]", (m.half_width - example1::hertz_a) / 0.4, 1);
  const auto errors = errors_of(s);
  expect_error("quad8, 6 x 6: creepage, turned like the force, fine meshes", errors.force, 0.016);
  expect_error("quad8, 6 x 6: spin moment", errors.moment, 1e-7);
}

TEST(Rings, two_equal_rings_cost_as_much_as_one_used_twice) {
  const auto ring = example1::ring_body(example1::bem_ring(6), ElementType::quad4);
  auto twins = example1::pair(ring, scenes::TwinBody{}, "characteristic");
  auto equal = example1::pair(ring, ring, "characteristic");
  ASSERT_EQ(twins->solve(), ROLLCON_OK);
  ASSERT_EQ(equal->solve(), ROLLCON_OK);
  EXPECT_EQ(equal->solution().traction, twins->solution().traction);
  EXPECT_EQ(equal->body_stat(1, "shared") + equal->body_stat(2, "shared"), 1);
  for (const char* count : {"assemblies", "factorizations", "condensations", "bytes"})
    EXPECT_EQ(equal->body_stat(2, count), twins->body_stat(1, count)) << count;
}

TEST(Rings_long, new_creepages_need_no_assembly) {
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
