/// Tests each row of the plan: counters show that what a scene does not need is not there, and results are those with
/// it to 1e-10.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "contact/scene_fixture.hpp"
#include "support/example1.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double bound = 1e-10;

double stat(const Pair& pair, const char* name) {
  return pair.contact->stat(name);
}

bool says(const Pair& pair, const char* what) {
  return pair.contact->plan().find(what) != std::string::npos;
}

void expect_equal(const char* what, const Pair& a, const Pair& b, double limit = bound) {
  const double off = largest_difference(a.tractions(), b.tractions());
  std::printf("%s: tractions differ by %.1e (bound %.0e)\n", what, off, limit);
  EXPECT_LT(off, limit) << what;
}

struct Case {
  const char* name;
  double young2, poisson2;  ///< poisson2 < -1: rigid
};
const Case cases[] = {{"equal", 1e4, 0.3}, {"unequal", 2e4, 0.1}, {"on rigid", 1, -2}};

TEST(plan_rigid_body, is_the_limit_of_a_stiff_one_without_its_compliance) {
  Pair rigid(1e4, 0.3, 1, -2), stiff(1e4, 0.3, 1e22, 0.3);
  for (Pair* pair : {&rigid, &stiff}) {
    sharp_scene(*pair);
    ASSERT_EQ(pair->contact->solve(), Status::ok);
  }
  EXPECT_TRUE(says(rigid, "body 2: rigid, no mesh: no matrix, no factorisation, no compliance"));
  EXPECT_EQ(stat(rigid, "body_preparations"), 0);
  EXPECT_EQ(stat(rigid, "kernel_evaluations"), stat(stiff, "kernel_evaluations")) << "one compliance, not two";
  expect_equal("rigid against 1e18 times as stiff", rigid, stiff);
}

TEST(plan_without_friction, has_no_tangential_unknown_row_or_column) {
  for (const Case& c : cases) {
    Pair without(1e4, 0.3, c.young2, c.poisson2), with(1e4, 0.3, c.young2, c.poisson2);
    sharp_scene(without);
    sharp_scene(with);
    without.friction(0);
    with.friction(1e-13);
    ASSERT_EQ(without.contact->solve(), Status::ok);
    ASSERT_EQ(with.contact->solve(), Status::ok);
    EXPECT_TRUE(says(without, "no tangential unknowns"));
    EXPECT_EQ(stat(without, "unknowns"), stat(without, "nodes_contact"));
    EXPECT_EQ(stat(without, "system_unknowns"), stat(without, "nodes_contact"));
    EXPECT_EQ(stat(without, "operator_bytes"), 8 * 225 * 225) << "one block";
    EXPECT_LT(stat(without, "kernel_evaluations"), 0.51 * stat(with, "kernel_evaluations")) << "nothing upstream";
    EXPECT_EQ(stat(without, "tangential_iterations") + stat(without, "full_iterations"), 0);
    expect_equal(c.name, without, with);
  }
}

TEST(plan_equal_bodies, have_no_coupling_blocks) {
  Pair equal(1e4, 0.3, 1e4, 0.3), nearly(1e4, 0.3, 1e4, 0.3 - 2e-11);
  for (Pair* pair : {&equal, &nearly}) {
    sharp_scene(*pair);
    ASSERT_EQ(pair->contact->solve(), Status::ok);
  }
  EXPECT_TRUE(says(equal, "normal problem first, alone"));
  EXPECT_TRUE(says(nearly, "solved together"));
  EXPECT_EQ(stat(equal, "operator_bytes") * 9, stat(nearly, "operator_bytes") * 5);
  EXPECT_EQ(stat(equal, "full_iterations"), 0);
  EXPECT_GT(stat(nearly, "full_iterations"), 0);
  EXPECT_EQ(stat(equal, "system_unknowns"), 2 * stat(equal, "nodes_contact"));
  expect_equal("alone against together", equal, nearly);
}

TEST(plan_same_body_twice, is_prepared_once) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  namespace example1 = scenes::example1;
  const auto ring = example1::ring_body(example1::bem_ring(6), ElementType::quad4);
  scenes::MeshedBody other = ring;
  other.material->shear *= 1 + 1e-14;
  const auto solved = [&](const scenes::AnyBody& second) {
    auto pair = example1::pair(ring, second, "characteristic");
    pair->option("tolerance", 1e-12).solve();
    return pair;
  };
  const auto twin = solved(scenes::TwinBody{}), equal = solved(ring), different = solved(other);
  for (const auto* pair : {&twin, &equal}) {
    EXPECT_EQ((*pair)->stat("body_preparations"), 1);
    EXPECT_NE((*pair)->plan().find("body 2 equals body 1"), std::string::npos);
    const scenes::Solution a = (*pair)->solution(), b = different->solution();
    double off = 0, scale = 0;
    for (std::size_t k = 0; k < a.nodes(); ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        off = std::max(off, std::abs(a.traction[k][c] - b.traction[k][c]));
        scale = std::max(scale, std::abs(b.traction[k][c]));
      }
    std::printf("one preparation against two: %.1e (bound %.0e)\n", off / scale, bound);
    EXPECT_LT(off, bound * scale);
  }
  EXPECT_EQ(different->stat("body_preparations"), 2);
  EXPECT_EQ(different->plan().find("body 2 equals body 1"), std::string::npos);
}

TEST(plan_unchanged_scene, makes_nothing_again) {
  for (const Case& c : cases) {
    Pair pair(1e4, 0.3, c.young2, c.poisson2);
    sharp_scene(pair);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    EXPECT_TRUE(says(pair, "made for this solve: frame, gap, compliance"));
    const std::vector<double> first = pair.tractions();
    const double kernels = stat(pair, "kernel_evaluations");
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    EXPECT_TRUE(says(pair, "nothing is new since the solve before"));
    EXPECT_EQ(stat(pair, "kernel_evaluations"), kernels);
    EXPECT_EQ(stat(pair, "compliance_assemblies"), 1);
    EXPECT_EQ(stat(pair, "iterations"), 0);
    EXPECT_EQ(stat(pair, "factorizations"), 0);
    EXPECT_EQ(stat(pair, "right_sides"), 0);
    EXPECT_LT(largest_difference(pair.tractions(), first), bound);
  }
}

TEST(plan_sparse_library, is_called_for_finite_elements_alone) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  sharp_scene(pair);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  EXPECT_TRUE(says(pair, "no finite-element body: no sparse matrix"));
}

TEST(plan_results, are_computed_when_asked_for_and_once) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  sharp_scene(pair);
  Contact& c = *pair.contact;
  const char* names[] = {"fields_derived", "laws_checked", "displacement_fields", "error_estimates"};
  const auto expect = [&](std::vector<double> counts, const char* when) {
    for (std::size_t i = 0; i < counts.size(); ++i) EXPECT_EQ(c.stat(names[i]), counts[i]) << names[i] << " " << when;
  };
  ASSERT_EQ(c.solve(), Status::ok);
  pair.tractions();
  double force[3], moment[3], approach, creep[3];
  c.resultant(InAxes::global, force, moment);
  c.motion(&approach, creep);
  c.stat("contact_area");
  expect({0, 0, 0, 0}, "after tractions, forces, motions");
  EXPECT_EQ(c.stat("operator_applications"), 0);
  EXPECT_TRUE(says(pair,
                   "not computed, as nobody asked: gap, slip and state of the nodes, residuals of the laws, "
                   "displacements of the bodies, error estimate"));
  std::vector<std::int32_t> state(static_cast<std::size_t>(c.nodes()));
  for (int again = 0; again < 2; ++again) c.node_status(c.nodes(), state.data());
  expect({1, 0, 0, 0}, "after states");
  for (int again = 0; again < 2; ++again) c.stat("law_slip");
  expect({1, 1, 0, 0}, "after a law");
  std::vector<double> u(static_cast<std::size_t>(3 * c.nodes()));
  c.field(Field::displacement1, InAxes::local, 3 * c.nodes(), u.data());
  expect({1, 1, 1, 0}, "after displacements");
  for (int again = 0; again < 2; ++again) c.stat("error_estimate");
  expect({1, 1, 1, 1}, "after an estimate");
  c.scene.set_creep(1e-3, 0, 0);
  ASSERT_EQ(c.solve(), Status::ok);
  expect({1, 1, 1, 1}, "a solve asks for nothing");
  c.stat("nodes_slip");
  expect({2, 1, 1, 1}, "of another solution");
}

}  // namespace
}  // namespace rollcon
