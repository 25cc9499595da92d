// Tests that every solution procedure finds the tractions of the standard one, on the paper's examples, coarsely
// meshed.

#include "support/example1.hpp"
#include "support/example2.hpp"
#include "support/example3.hpp"
#include "support/example4.hpp"
#include "validation/procedure_runs.hpp"

namespace rollcon::validation {
namespace {

namespace example1 = scenes::example1;
namespace example2 = scenes::example2;
namespace example3 = scenes::example3;
namespace example4 = scenes::example4;
using Pair = std::unique_ptr<RollingPair>;

surfaces::Ring coarse(surfaces::Ring shape, int zone_around, int across, int deep) {
  shape.zone_around = zone_around;
  shape.across = across;
  shape.around = 2 * zone_around;
  shape.deep = deep;
  shape.largest = example1::longest(shape.around - shape.zone_around);
  return shape;
}

/// Leaves out the condensation beforehand, so that the monolithic systems do not gain by it.
MeshedBody unprepared(MeshedBody body) {
  body.int_option.emplace_back("prepare", 0);
  return body;
}

MeshedBody bem_ring() {
  return unprepared(example1::ring_body(coarse(example1::paper_ring(), 6, 2, 1), ElementType::quad4));
}

MeshedBody fem_ring() {
  surfaces::Ring shape = coarse(example1::paper_ring(), 6, 2, 3);
  shape.top_layer = 0.4;
  return unprepared(example1::ring_body(shape, VolumeType::hex8));
}

/// Rolls rings without a force across: at a given creepage of 0, a lateral force that the reduced unknowns leave behind
/// would die out, sweep by sweep, as slowly as a tyre's along its way.
Pair rings(const scenes::AnyBody& one, const scenes::AnyBody& two) {
  auto pair = example1::pair(one, two, "godunov");
  pair->tangential_force(ROLLCON_LATERAL, 0);
  return pair;
}

Pair ring_on_ground() {
  surfaces::Ring shape = coarse(example2::ring_of(8), 8, 2, 4);
  auto pair = std::make_unique<RollingPair>(unprepared(example2::ring_body(shape, VolumeType::hex8)),
                                            scenes::HalfspaceBody{example2::ground}, 1);
  pair->axes({0, 0, example2::radius}, {1, 0, 0}, {0, 0, 1}).frame_from_body(1, 2);
  pair->friction(example2::mu).load(example2::load).speed(example2::speed);
  pair->tangential_force(ROLLCON_LONGITUDINAL, example2::force_ratio * example2::mu * example2::load);
  pair->option("convection", "godunov");
  return pair;
}

Pair sphere(const SurfaceMesh& mesh, const char* scheme) {
  return example3::pair(mesh, scheme);
}

SurfaceMesh quads() {
  const double reach = 1.3 * example3::hertz().a;
  return frames::o_grid(ElementType::quad4, 8, 2, reach, reach);
}

SurfaceMesh triangles() {
  const double a = example3::hertz().a;
  return graded_disc(a, a, 6);
}

/// Makes a part of the wheel of example 4 around its top: 30 x 30 x 20 mm, 8 x 8 elements in 6 x 6 mm.
Pair wheel() {
  auto pair = example4::pair(unprepared(example4::part_of_wheel({30, 20, 6, 8, 1, 1})), "godunov");
  pair->creep(-9e-4, 0, 0);
  return pair;
}

struct Example {
  const char* name;
  Pair (*make)();
  Plain plain = Plain::fast;
  bool reduced = true;
  std::vector<Failing> failing = {};
};

class Procedures : public ::testing::TestWithParam<Example> {};
using Monolithic = Procedures;

TEST_P(Procedures, condensed_reach_the_standard_tractions) {
  const Example& e = GetParam();
  compare_procedures(e.name, *e.make(), procedures_of("condensed", e.reduced), e.failing);
}

TEST_P(Monolithic, monolithic_reach_the_standard_tractions) {
  const Example& e = GetParam();
  compare_procedures(e.name, *e.make(), procedures_of("monolithic", e.reduced, e.plain), e.failing);
}

constexpr auto example_name = [](const auto& param) { return std::string(param.param.name); };

const Example on_half_space{"example_2_FEM_on_half_space", ring_on_ground};
const Example others[] = {
    {"example_1_BEM_on_BEM", [] { return rings(bem_ring(), scenes::TwinBody{}); }},
    {"example_1_FEM_on_FEM", [] { return rings(fem_ring(), scenes::TwinBody{}); }},
    {"example_3_quad4_godunov", [] { return sphere(quads(), "godunov"); }, Plain::all},
    {"example_3_tri3_least_squares",
     [] { return sphere(triangles(), "least_squares"); },
     Plain::all,
     true,
     {{"", "reduced", "pseudo_temporal"}}},
    {"example_3_quad4_characteristic", [] { return sphere(quads(), "characteristic"); }, Plain::all, false}};
const Example larger[] = {{"example_1_FEM_on_BEM", [] { return rings(fem_ring(), bem_ring()); }},
                          {"example_4_BEM_on_rigid", wheel}};

INSTANTIATE_TEST_SUITE_P(Example2, Procedures, ::testing::Values(on_half_space), example_name);
INSTANTIATE_TEST_SUITE_P(Examples_long, Procedures, ::testing::ValuesIn(others), example_name);
INSTANTIATE_TEST_SUITE_P(Larger_long, Procedures, ::testing::ValuesIn(larger), example_name);
INSTANTIATE_TEST_SUITE_P(Example2_long, Monolithic, ::testing::Values(on_half_space), example_name);
INSTANTIATE_TEST_SUITE_P(Examples_long, Monolithic, ::testing::ValuesIn(others), example_name);
INSTANTIATE_TEST_SUITE_P(Larger_nightly, Monolithic, ::testing::ValuesIn(larger), example_name);

}  // namespace
}  // namespace rollcon::validation
