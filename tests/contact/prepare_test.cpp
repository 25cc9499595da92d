/// Tests what the discrete problem takes from bodies: displacements they have anyway, coupling that turns out to be
/// none, and what a change of pose makes stale.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "build_info.hpp"
#include "contact/body_geometry.hpp"
#include "contact/prepare/preparation.hpp"
#include "contact/scene_fixture.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

/// Replaces a compliance by displacements of its own, and coupling as given.
class Changed final : public Compliance {
 public:
  using Field = std::array<double, 3> (*)(double x, double y);

  Changed(std::shared_ptr<Compliance> inner, Field given, double coupling)
      : inner_(std::move(inner)), given_(given), coupling_(coupling) {}
  std::int64_t nodes() const override { return inner_->nodes(); }
  bool couples() const override { return coupling_ != 0; }
  void block(Points p, const ComplianceBlock& out) const override {
    inner_->block(p, out);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (out.a[i][j] && (i == 2) != (j == 2))
          for (std::size_t k = 0; k < p.size(); ++k)
            out.a[i][j][static_cast<std::ptrdiff_t>(k) * out.stride] = coupling_;
  }
  void apply(Points p, const double* t, double* u) const override { inner_->apply(p, t, u); }
  bool offset(Points p, double* u) const override {
    for (std::size_t k = 0; given_ && k < p.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) u[3 * k + c] = given_(p.x[k], p.y[k])[c];
    return given_ != nullptr;
  }
  void set_threads(int) override {}
  std::int64_t kernel_evaluations() const override { return 0; }
  std::size_t bytes() const override { return 0; }

 private:
  std::shared_ptr<Compliance> inner_;
  Field given_;
  double coupling_;
};

struct PreparedScene {
  Pair pair{1e4, 0.3, 1e4, 0.3};
  Preparation preparation;

  PreparedScene() { standard_scene(pair, 10); }
  void run() { prepare(preparation, pair.contact->scene, *pair.body1, *pair.body2, 1); }
  void change(Changed::Field given, double coupling) {
    Prepared& on = *preparation.made;
    on.compliance = std::make_shared<Changed>(std::move(on.compliance), given, coupling);
    forget_operators(preparation);
    preparation.convection.forget();
  }
};

TEST(bodies_displaced, gap_and_slip_take_it) {
  for (const char* scheme : {"godunov", "least_squares", "characteristic"}) {
    PreparedScene scene;
    scene.pair.contact->scene.options.set_text("convection", scheme);
    scene.pair.contact->scene.set_speed(7);
    scene.run();
    const Problem before = scene.preparation.made->problem;
    ASSERT_TRUE(before.slip1.empty());
    scene.change(
        [](double x, double y) {
          return std::array{2e-3 * x + 1e-3 * y + 5, -3e-3 * x, 1e-3 + 2e-4 * x * y};
        },
        0);
    scene.run();
    const Problem& p = scene.preparation.made->problem;
    double gap = 0, slip = 0;
    const std::vector<double> with = p.undeformed_gaps(), without = before.undeformed_gaps();
    for (std::size_t k = 0; k < p.gap.size(); ++k) {
      const double x = scene.preparation.made->frame.x[k], y = scene.preparation.made->frame.y[k];
      gap = std::max(gap, std::abs(without[k] - with[k] - (1e-3 + 2e-4 * x * y)));
      if (scene.preparation.made->frame.rim[k]) continue;  // stencils may be cut there
      // Material flows along -t1: D w = -dw/dx, exact for linear displacements.
      slip = std::max({slip, std::abs(p.slip1[k] + 2e-3), std::abs(p.slip2[k] - 3e-3)});
    }
    std::printf("%s: gap off by %.1e (bound 1e-15), slip %.1e (bound 1e-13)\n", scheme, gap, slip);
    EXPECT_LT(gap, 1e-15);
    EXPECT_LT(slip, 1e-13);
    // A creep field adds to the slip, and again when it changes.
    for (const double creep : {0.07, 0.14}) {
      const std::vector<double> field(2 * p.gap.size(), creep);
      scene.pair.contact->scene.set_creep_field(scene.pair.contact->nodes(), field.data());
      scene.run();
      EXPECT_NEAR(p.slip1[60], creep / 7 - 2e-3, 1e-12);
    }
    scene.pair.contact->scene.set_creep_field(0, nullptr);
    scene.pair.contact->scene.set_gap_quadratic(0, 0, 0);
    scene.run();
    EXPECT_NEAR(p.slip1[60], -2e-3, 1e-13);
    EXPECT_NEAR(p.undeformed_gaps()[60],
                -(1e-3 + 2e-4 * scene.preparation.made->frame.x[60] * scene.preparation.made->frame.y[60]), 1e-16);
  }
}

TEST(coupling, blocks_of_rounding_are_dropped) {
  for (const double coupling : {1e-22, 1e-6}) {  // direct entries: about 1e-6 and more
    PreparedScene scene;
    scene.run();
    scene.change(nullptr, coupling);
    scene.run();
    const auto& op = dynamic_cast<const DenseOperators&>(*scene.preparation.made->problem.op);
    const bool dropped = coupling < 1e-10;
    EXPECT_EQ(op.coupled, !dropped);
    EXPECT_EQ(op.coupling_vanished, dropped);
    EXPECT_EQ(op.block[0][2].empty(), dropped);
    EXPECT_EQ(op.block[2][1].empty(), dropped);
    EXPECT_FALSE(op.block[2][2].empty());
    // Another scheme does not ask again.
    scene.pair.contact->scene.options.set_text("convection", "godunov");
    scene.run();
    EXPECT_EQ(op.coupled, !dropped);
    EXPECT_EQ(op.block[1][2].empty(), dropped);
  }
}

/// Puts a block of boundary elements, held at its bottom, under a rigid sphere.
struct SphereOnBlock {
  std::shared_ptr<Context> context = std::make_shared<Context>();
  std::shared_ptr<Body> block = std::make_shared<Body>(context, 2);
  std::shared_ptr<Body> sphere = rigid_body(context, sphere_cap(ElementType::quad9, 10, 1.5, 50, 0, false));
  Contact contact{context, block, sphere};

  SphereOnBlock() {
    context->set_threads(1);
    const SurfaceMesh mesh = surfaces::zone_block({8, 6, 2.6, 8, 2, 2}, ElementType::quad4);
    set_mesh(*block, mesh);
    block->set_elastic(1, 1e4, 0.3);
    const std::vector<std::int32_t> held = surfaces::nodes_with_tag(mesh, std::array{3});
    block->set_support(static_cast<std::int64_t>(held.size()), held.data(), 0, 7, nullptr);
    contact.frame_from_body(1, 2);
    const double mu = 0.3;
    contact.scene.set_friction("coulomb", 1, &mu);
    contact.scene.set_creep(-1e-3, 0, 0);
    contact.scene.prescribe(3, 1, 0.02);
  }
  std::vector<double> tractions() {
    EXPECT_GE(static_cast<int>(contact.solve()), 0);
    std::vector<double> t(static_cast<std::size_t>(3 * contact.nodes()));
    contact.tractions(InAxes::local, contact.nodes(), t.data());
    return t;
  }
};

TEST(pose_of_a_rigid_body, changes_the_gap_alone) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  SphereOnBlock scene;
  const std::vector<double> standing = scene.tractions();
  const std::string plan = scene.contact.plan();
  EXPECT_NE(plan.find("flat"), std::string::npos) << plan;
  const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, up[3] = {0, 0, 0.004};
  scene.contact.scene.set_pose(2, one, up);
  const std::vector<double> lifted = scene.tractions();
  EXPECT_GT(largest_difference(lifted, standing), 0.05);
  EXPECT_EQ(scene.contact.stat("compliance_assemblies"), 1);
  scene.contact.scene.prescribe(3, 1, 0.024);
  const double difference = largest_difference(scene.tractions(), standing);
  std::printf("lifted by 0.004 and pressed by as much more: %.1e (bound 1e-9)\n", difference);
  EXPECT_LT(difference, 1e-9);
  EXPECT_EQ(scene.contact.stat("compliance_assemblies"), 1);
  EXPECT_LT(scene.contact.stat("law_slip"), 1e-8);
}

TEST(pose_of_both_bodies, moves_the_scene_without_a_trace) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  SphereOnBlock still, moved;
  const std::vector<double> expected = still.tractions();
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(2.0), e = std::sin(2.0);
  const double rotation[9] = {c, -s * d, s * e, s, c * d, -c * e, 0, e, d};
  const double shift[3] = {30, -20, 10}, rolling[3] = {c, s, 0}, normal[3] = {s * e, -c * e, d};
  Scene& scene = moved.contact.scene;
  for (const int which : {1, 2}) scene.set_pose(which, rotation, shift);
  scene.set_axes(shift, rolling, normal);
  const double difference = largest_difference(moved.tractions(), expected);
  std::printf("scene turned and moved: tractions differ by %.1e (bound 1e-9)\n", difference);
  EXPECT_LT(difference, 1e-9);
  double force[3], turned[3];
  still.contact.resultant(InAxes::global, force, nullptr);
  moved.contact.resultant(InAxes::global, turned, nullptr);
  double off = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j) sum += rotation[3 * i + j] * force[j];
    off = std::max(off, std::abs(sum - turned[i]));
  }
  EXPECT_LT(off, 1e-8 * std::abs(force[2]));
}

// The test takes the setters of a scene with meshes; setters_test.cpp has the others.
TEST(setter_of_a_meshed_scene_long, makes_only_what_depends_on_it) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  const std::vector<std::string> counted{"body_preparations", "frame_builds", "compliance_builds",
                                         "stencil_builds",    "gap_builds",   "friction_builds",
                                         "slip_builds",       "scale_builds", "compliance_assemblies"};
  const std::vector<int> nothing(9, 0), gap{0, 0, 0, 0, 1, 0, 0, 0, 0}, frame{0, 1, 1, 1, 1, 1, 1, 1, 1};
  const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, up[3] = {0, 0, 0.004};
  const double aside[3] = {0.1, 0, 0};
  struct Change {
    const char* name;
    std::function<void(Contact&)> apply;
    std::vector<int> made;
  };
  const Change changes[] = {{"creep", [](Contact& c) { c.scene.set_creep(2e-3, 0, 0); }, nothing},
                            {"approach", [](Contact& c) { c.scene.prescribe(3, 1, 0.024); }, nothing},
                            {"pose of the rigid body", [&](Contact& c) { c.scene.set_pose(2, one, up); }, gap},
                            {"pose of both",
                             [&](Contact& c) {
                               for (const int which : {1, 2}) c.scene.set_pose(which, one, aside);
                               const double rolling[3] = {1, 0, 0}, normal[3] = {0, 0, 1};
                               c.scene.set_axes(aside, rolling, normal);
                             },
                             frame},
                            {"the same poses",
                             [&](Contact& c) {
                               const double none[3] = {0, 0, 0};
                               for (const int which : {1, 2}) c.scene.set_pose(which, one, none);
                             },
                             nothing},
                            {"frame", [](Contact& c) { c.frame_from_body(1, 2); }, frame}};
  for (const Change& change : changes) {
    SphereOnBlock scene, fresh;
    scene.tractions();
    std::vector<double> before;
    for (const std::string& name : counted) before.push_back(scene.contact.stat(name.c_str()));
    EXPECT_EQ(before[0], 1) << "the block, not the rigid sphere";
    change.apply(scene.contact);
    change.apply(fresh.contact);
    const double off = largest_difference(scene.tractions(), fresh.tractions());
    std::printf("%s: against a fresh contact %.1e (bound 1e-9)\n", change.name, off);
    EXPECT_LT(off, 1e-9);
    for (std::size_t i = 0; i < counted.size(); ++i)
      EXPECT_EQ(scene.contact.stat(counted[i].c_str()) - before[i], change.made[i])
          << change.name << ": " << counted[i];
  }
}

TEST(pose_of_a_body, set_after_a_solve_leaves_its_results) {
  if (ROLLCON_BUILD_BEM == 0) GTEST_SKIP() << "this build has no boundary elements";
  SphereOnBlock scene, twin;
  const auto displacements = [](SphereOnBlock& of) {
    std::vector<double> u(static_cast<std::size_t>(3 * of.contact.nodes()));
    of.contact.field(Field::displacement1, InAxes::global, static_cast<std::int64_t>(u.size()), u.data());
    return u;
  };
  scene.tractions();
  twin.tractions();
  const double one[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, away[3] = {100, 0, 0};
  scene.contact.scene.set_pose(1, one, away);
  const std::vector<double> expected = displacements(twin), found = displacements(scene);
  EXPECT_GT(*std::min_element(expected.begin(), expected.end()), -0.03);
  EXPECT_LT(*std::min_element(expected.begin(), expected.end()), -0.01) << "pressed down";
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace rollcon
