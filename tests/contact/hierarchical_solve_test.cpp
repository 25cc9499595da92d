// Tests contacts on irregular frames whose operators are hierarchical: they are those of dense operators in all kinds
// of scenes, work grows with the number of nodes, and large frames have the closed forms.

#include "support/carter_strip.hpp"
#include "support/data_limit.hpp"
#include "support/example3.hpp"
#include "support/graded_disc.hpp"
#include "support/steady_rolling.hpp"
#include "support/testing.hpp"

namespace {

namespace frames = rollcon::frames;
namespace scenes = rollcon::scenes;
namespace steady_rolling = scenes::steady_rolling;
using rollcon::expect_error;
using scenes::RollingPair;

rollcon::SurfaceMesh triangles(int n) {
  const auto lines = frames::uniform_lines(-1.2 * steady_rolling::radius, 1.2 * steady_rolling::radius, n);
  return frames::perturb(frames::rectangle(rollcon::ElementType::tri3, lines, lines), 0.2, 3);
}

std::unique_ptr<RollingPair> make(const rollcon::SurfaceMesh& mesh, bool soft, const char* operators) {
  const scenes::Elastic rubber{.shear = 41000, .poisson = 0.4};
  auto pair = std::make_unique<RollingPair>(soft ? rubber : steady_rolling::steel, steady_rolling::steel, 2);
  steady_rolling::prepare(*pair, mesh, "b");
  pair->option("operators", operators);
  return pair;
}

/// Returns the largest difference of forces and moment, over mu Fn and mu Fn a.
double difference(const RollingPair& a, const RollingPair& b) {
  const auto x = steady_rolling::found(a.solution()), y = steady_rolling::found(b.solution());
  return std::max(
      {std::abs(x.force[0] - y.force[0]), std::abs(x.force[1] - y.force[1]), std::abs(x.moment - y.moment)});
}

TEST(Hierarchical, SolvesAreThoseOfDenseOperators) {
  for (const bool soft : {false, true})
    for (const int variant : {0, 1, 2, 3}) {
      std::unique_ptr<RollingPair> pair[2];
      for (int k = 0; k < 2; ++k) {
        pair[k] = make(triangles(20), soft, k == 0 ? "dense" : "hierarchical");
        pair[k]->creep(1.02 * steady_rolling::creepage, 0, steady_rolling::spin);
        if (variant == 1) {
          pair[k]->tangential_force(ROLLCON_LONGITUDINAL, 0.4 * steady_rolling::mu * steady_rolling::hertz.load);
          pair[k]->tangential_force(ROLLCON_SPIN, 0);
        }
        if (variant == 2) pair[k]->approach(0.9 * steady_rolling::hertz.approach);
        if (variant == 3) {
          pair[k]->tangential_force(ROLLCON_LATERAL, 0.5 * steady_rolling::mu * steady_rolling::hertz.load);
        }
        EXPECT_EQ(pair[k]->solve(), ROLLCON_OK);
        pair[k]->friction(0.9 * steady_rolling::mu);  // warm
        EXPECT_EQ(pair[k]->solve(), ROLLCON_OK);
      }
      expect_error((soft ? "unlike bodies, variant " : "alike bodies, variant ") + std::to_string(variant),
                   difference(*pair[0], *pair[1]), 1e-6);
      double rates[2][3] = {};
      for (int k = 0; k < 2; ++k)
        ASSERT_EQ(
            rollcon_contact_get_sensitivity(pair[k]->handle(), ROLLCON_NORMAL, rates[k], nullptr, nullptr, nullptr),
            ROLLCON_OK);
      const int c = variant == 1 ? 1 : 0;  // a component that is not given
      expect_error("its rate", rates[1][c] / rates[0][c] - 1, 1e-5);
      EXPECT_EQ(pair[0]->stat("operator_applications"), 0);
      EXPECT_GT(pair[1]->stat("operator_applications"), 0);
      EXPECT_EQ(pair[1]->stat("factorizations"), 0);
    }
}

TEST(Hierarchical, FrictionlessAndFrictionalScenesTakeTurns) {
  auto dense = make(triangles(20), true, "dense"), other = make(triangles(20), true, "hierarchical");
  for (const double mu : {0.0, 0.3, 0.0, 0.2})
    for (auto* pair : {&dense, &other}) {
      (*pair)->friction(mu);
      EXPECT_EQ((*pair)->solve(), ROLLCON_OK) << (*pair)->plan();
      if (pair == &other) expect_error("friction " + std::to_string(mu), difference(*dense, *other), 1e-6);
    }
}

TEST(Hierarchical, AnythingElseIsRefusedByName) {
  const auto expect = [](const char* option, const char* value, const char* text) {
    auto pair = make(triangles(8), false, "hierarchical");
    pair->option(option, value);
    EXPECT_EQ(rollcon_contact_solve(pair->handle()), ROLLCON_ERR_UNSUPPORTED);
    EXPECT_NE(std::string(rollcon_last_error()).find(text), std::string::npos) << rollcon_last_error();
    pair->option("operators", "dense");
    EXPECT_EQ(pair->solve(), ROLLCON_OK);
  };
  expect("linear_solver", "lu", "operators is 'hierarchical' but linear_solver is 'lu'");
  auto pair = make(triangles(8), false, "hierarchical");
  ASSERT_EQ(rollcon_contact_set_step(pair->handle(), ROLLCON_SHIFT_STEP, 1), ROLLCON_OK);
  EXPECT_EQ(rollcon_contact_solve(pair->handle()), ROLLCON_ERR_UNSUPPORTED);
  EXPECT_NE(std::string(rollcon_last_error()).find("time steps"), std::string::npos) << rollcon_last_error();
}

TEST(Hierarchical_long, FramesWithoutRoomAreRefusedBeforeTheyAreIntegrated) {
  EXPECT_EQ(make(triangles(8), true, "hierarchical")->solve(), ROLLCON_OK);  // threads of the BLAS have their memory
  auto pair = make(triangles(32), true, "hierarchical");
  double told = 0;
  {
    const rollcon::DataLimit limit(2e7);
    EXPECT_EQ(rollcon_contact_solve(pair->handle()), ROLLCON_ERR_MEMORY);
    const std::string text = rollcon_last_error();
    const std::string before = "the operators of a frame of 1089 nodes need ";
    const auto at = text.find(before);
    ASSERT_NE(at, std::string::npos) << text;
    told = 1e9 * std::atof(text.c_str() + at + before.size());
  }
  EXPECT_EQ(pair->solve(), ROLLCON_OK);
  expect_error("bytes foreseen", told / pair->stat("operator_bytes") - 1, 0.2);
}

TEST(Hierarchical, ErrorEstimatesFollowTheErrors) {
  auto fine = make(triangles(44), false, "hierarchical");
  EXPECT_EQ(fine->solve(), ROLLCON_OK);
  for (const int n : {16, 24}) {
    auto pair = make(triangles(n), false, "hierarchical");
    EXPECT_EQ(pair->solve(), ROLLCON_OK);
    const auto s = pair->solution(), exact = fine->solution();
    const double error = std::hypot(s.force[0] - exact.force[0], s.force[1] - exact.force[1]) /
                         std::hypot(exact.force[0], exact.force[1]),
                 told = pair->stat("error_estimate_tangential");
    std::printf("%d lines: friction is off by %.2g, told %.2g\n", n, error, told);
    EXPECT_GT(told, error / 3);
    EXPECT_LT(told, 20 * error + 0.02);
  }
}

TEST(Hierarchical_long, WorkGrowsWithTheNodes) {
  double before = 0;
  for (const int n : {54, 100, 141}) {
    auto pair = make(triangles(n), false, "auto");
    EXPECT_EQ(pair->solve(), ROLLCON_OK);
    ASSERT_GT(pair->stat("operator_applications"), 0) << "the operators are not hierarchical";
    const double each = pair->stat("linear_iterations") / pair->stat("right_sides");
    std::printf("%6d nodes: %.0f applications, %.1f iterations a system\n", (n + 1) * (n + 1),
                pair->stat("operator_applications"), each);
    expect_error("largest pressure", pair->stat("max_pressure") / steady_rolling::hertz.p0 - 1, 0.01);
    if (before > 0) {
      EXPECT_LT(each, 2 * before);
    }
    before = before > 0 ? before : each;
  }
}

TEST(Hierarchical_nightly, TwentyThousandNodesGradedToTheEdge) {
  // Triangles are a third as wide in the middle as beyond the edge.
  const rollcon::SurfaceMesh mesh = frames::transform(triangles(150), [](const rollcon::Vec3& x) {
    const double half = 1.2 * steady_rolling::radius;
    const auto graded = [&](double t) { return t * (0.55 + 0.45 * t * t / (half * half)); };
    return rollcon::Vec3{graded(x[0]), graded(x[1]), 0};
  });
  RollingPair pair(steady_rolling::steel, steady_rolling::steel, 2);
  steady_rolling::prepare(pair, mesh, "a");
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  expect_error("largest pressure", pair.stat("max_pressure") / steady_rolling::hertz.p0 - 1, 1e-3);
  expect_error("force of case (a)", steady_rolling::errors(pair.solution(), "a").force, 5e-3);
  EXPECT_LT(pair.stat("operator_bytes"), 2e9);
}

// Carter's problem is plane: the frame is a strip ten half-widths to each side, loaded up to its ends, and its
// triangles are twice as narrow at the edges of the contact as in the middle.
TEST(Hierarchical_nightly, CarterOnTwentyThousandNodesGradedToTheEdges) {
  const scenes::Strip strip{scenes::carter.hertz, 10};
  std::vector<double> x = frames::uniform_lines(-1.2, 1.2, 128);
  for (double& t : x) t *= 1.25 - 0.25 * t * t;
  const auto mesh = frames::rectangle(rollcon::ElementType::tri3, x, frames::uniform_lines(-10, 10, 160));
  RollingPair pair(scenes::roller, scenes::roller, 2);
  pair.frame(mesh).option("operators", "hierarchical");
  scenes::load_strip(pair, strip, mesh);
  EXPECT_EQ(pair.solve(), ROLLCON_RIM_CONTACT);
  EXPECT_GT(pair.stat("operator_applications"), 0);
  const scenes::CarterErrors error = scenes::compare(scenes::middle_section(pair.solution()));
  expect_error(std::to_string(mesh.nodes()) + " nodes, load", error.load, 1e-3);
  expect_error("force", error.force, 3e-3);
  expect_error("tractions", error.traction, 0.01);
}

// The paper's disc of triangles in equal rings, each time with half the width of the rings.
TEST(Hierarchical_nightly, ExampleThreeOnFiftyThousandTriangles) {
  namespace example3 = scenes::example3;
  std::vector<double> creepage;
  for (const int rings : {24, 48, 96}) {
    std::vector<double> radius;
    std::vector<int> count;
    for (int k = 1; k <= rings; ++k) {
      radius.push_back(1.3 * example3::hertz().a * k / rings);
      count.push_back(std::min(6 * k, 4 * rings));
    }
    const auto mesh = frames::ring_disc(rollcon::ElementType::tri3, radius, count);
    auto pair = example3::pair(mesh, "characteristic", 2);
    pair->option("operators", "hierarchical");
    EXPECT_EQ(pair->solve(), ROLLCON_OK);
    const auto s = pair->solution();
    creepage.push_back(s.creep[0]);
    std::printf("%lld triangles: creepage %.6e, largest pressure %.2g off\n", static_cast<long long>(mesh.elements()),
                s.creep[0], pair->stat("max_pressure") / example3::hertz().p0 - 1);
  }
  const double first = creepage[1] - creepage[0], last = creepage[2] - creepage[1];
  std::printf("order %.2f\n", std::log2(std::abs(first / last)));
  EXPECT_LT(std::abs(last), std::abs(first) / 1.5);
  expect_error("change by the last refinement", last / creepage[2], 2e-4);
}

}  // namespace
