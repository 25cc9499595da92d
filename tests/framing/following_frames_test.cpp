/// Tests frames of the library in time loops: they follow the contact, and results have no jumps.

#include <functional>

#include "rollcon.h"
#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;
const Elastic steel{.shear = 82000, .poisson = 0.28}, aluminium{.shear = 27000, .poisson = 0.34};
constexpr double mu = 0.3;

/// Holds what a vehicle changes from step to step, for a wheel of radius 460 mm on rails; mm, N.
struct Step {
  double load = 1e5, radius = 300;
  std::array<double, 3> creep{5e-4, -6e-4, 1e-4};
};

std::array<double, 3> solve(RollingPair& pair, const Step& s, std::int32_t expected = ROLLCON_OK) {
  pair.gap_quadratic(1 / 920.0, 1 / (2 * s.radius)).load(s.load).friction(mu);
  pair.creep(s.creep[0], s.creep[1], s.creep[2]);
  EXPECT_EQ(pair.solve(), expected);
  const scenes::Solution r = pair.solution();
  return {r.force[0] / (mu * s.load), r.force[1] / (mu * s.load), r.moment[2] / (6 * mu * s.load)};
}

double largest(const std::array<double, 3>& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

// A frame that was stretched through many places gives what a new one gives there; accuracies stay on one level.
TEST(following_frames, the_way_does_not_matter) {
  for (const Elastic& second : {steel, aluminium}) {
    RollingPair follows(steel, second);
    follows.option("frame_accuracy", 0.1);
    double worst = 0, nodes = 0;
    int compared = 0;
    for (int i = 0; i < 120; ++i) {
      const double phase = 0.05 * i;
      const Step s{.load = 1e5 * (1 + 0.3 * std::sin(2 * phase)),
                   .radius = 350 + 200 * std::sin(phase),
                   .creep = {8e-4 * std::sin(phase), 1e-3 * std::cos(phase), 2e-4 * std::sin(3 * phase)}};
      const auto there = solve(follows, s);
      nodes = static_cast<double>(follows.solution().nodes());
      if (i % 10 != 5) continue;
      RollingPair fresh(steel, second);
      fresh.option("frame_accuracy", 0.1);
      const auto anew = solve(fresh, s);
      if (static_cast<double>(fresh.solution().nodes()) != nodes) continue;
      ++compared;
      worst = std::max(worst, largest({there[0] - anew[0], there[1] - anew[1], there[2] - anew[2]}));
    }
    expect_error("stretched frames beside new ones, over mu Fn", worst, 1e-9);
    EXPECT_GE(compared, 8) << "of 12, on frames of one level";
  }
}

TEST(following_frames, laws_hold_where_a_frame_went) {
  RollingPair follows(steel, steel);
  Step s;
  solve(follows, s);
  s.load *= 1.21;
  const auto there = solve(follows, s);
  EXPECT_EQ(follows.stat("compliance_builds"), 1);
  RollingPair fresh(steel, steel);
  const auto anew = solve(fresh, s);
  expect_error("another size beside a new frame", largest({there[0] - anew[0], there[1] - anew[1], there[2] - anew[2]}),
               1e-9);
  // Laws that are computed from integrals know where the frame went.
  for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
    expect_error(law, follows.stat(law), 1e-9);
}

// Derivatives count that the contact moves with load and approach. In the second case results of two counts are mixed,
// and the mixture changes, too.
TEST(following_frames, derivatives_by_the_load_are_those_of_differences) {
  for (const auto& creep : {std::array{1e-3, 0.0, 0.0}, {3e-4, -2e-4, 0.0}, {5e-4, -3e-4, 1e-4}})
    for (const bool by_force : {true, false}) {
      const auto put = [&](RollingPair& pair, double factor) {
        pair.gap_quadratic(1 / 920.0, 1 / 600.0).friction(mu).option("frame_accuracy", 0.02);
        by_force ? pair.load(1e5 * factor) : pair.approach(0.1 * factor);
        pair.creep(creep[0], creep[1], creep[2]);
        EXPECT_EQ(pair.solve(), ROLLCON_OK);
        return pair.solution();
      };
      RollingPair pair(steel, steel);
      put(pair, 1);
      double force[3], moment[3];
      ASSERT_EQ(rollcon_contact_get_sensitivity(pair.handle(), ROLLCON_NORMAL, force, moment, nullptr, nullptr),
                ROLLCON_OK);
      constexpr double step = 1e-4;
      const scenes::Solution before = put(pair, 1 - step), after = put(pair, 1 + step);
      const double change = 2 * step * (by_force ? 1e5 : 0.1);
      double largest = 0, off = 0;
      for (std::size_t c = 0; c < 2; ++c) {
        const double slope = (after.force[c] - before.force[c]) / change;
        largest = std::max(largest, std::abs(slope));
        off = std::max(off, std::abs(force[c] - slope));
      }
      off = std::max(off, std::abs(moment[2] - (after.moment[2] - before.moment[2]) / change) / 6);
      const bool mixed = creep[0] == 3e-4;
      expect_error(std::string(by_force ? "by load" : "by approach") + (mixed ? ", mixed" : ""), off / largest,
                   mixed ? 1e-4 : 1e-7);
    }
}

// Axes may turn, too.
TEST(following_frames, frames_follow_the_axes) {
  RollingPair follows(steel, steel);
  const Step s;
  const auto before = solve(follows, s);
  follows.axes({1, 2, 3}, {0, 0, 1}, {0, 1, 0});
  const auto after = solve(follows, s);
  expect_error("other axes", largest({after[0] - before[0], after[1] - before[1], after[2] - before[2]}), 1e-9);
  std::vector<double> x(static_cast<std::size_t>(3 * follows.solution().nodes()));
  ASSERT_EQ(rollcon_contact_get_field(follows.handle(), ROLLCON_FIELD_POINT, ROLLCON_GLOBAL,
                                      static_cast<std::int64_t>(x.size()), x.data(), nullptr),
            ROLLCON_OK);
  for (std::size_t k = 0; k < x.size(); k += 3) EXPECT_NEAR(x[k + 1], 2, 1e-12);
}

/// Expects the largest second difference of force and moment along 500 steps to be small, for a frame made by the
/// library and a fine one that stays.
void expect_smooth(const char* what, const std::function<Step(double)>& at) {
  constexpr int steps = 500;
  RollingPair follows(steel, steel), stays(steel, steel);
  follows.option("frame_accuracy", 0.01);
  ASSERT_EQ(rollcon_contact_frame_rectangle(stays.handle(), ROLLCON_QUAD4, 60, 60, -9, 9, -9, 9), ROLLCON_OK);
  double second[2] = {0, 0};
  std::array<double, 3> last[2][2];
  for (int i = 0; i < steps; ++i) {
    RollingPair* pairs[2] = {&follows, &stays};
    for (std::size_t p = 0; p < 2; ++p) {
      const auto now = solve(*pairs[p], at(i / (steps - 1.0)));
      for (std::size_t c = 0; i > 1 && c < 3; ++c)
        second[p] = std::max(second[p], std::abs(now[c] - 2 * last[p][1][c] + last[p][0][c]));
      last[p][0] = last[p][1];
      last[p][1] = now;
    }
  }
  report(std::string(what) + ": second differences on a fine lattice", second[1]);
  expect_error(std::string(what) + ": second differences, no frame", second[0], 10 * second[1]);
}

TEST(following_frames_long, a_sweep_over_shapes_has_no_jumps) {
  expect_smooth("ratio of semi-axes", [](double t) { return Step{.radius = 150 + 400 * t}; });
}

TEST(following_frames_nightly, sweeps_have_no_jumps) {
  expect_smooth("load", [](double t) { return Step{.load = 6e4 + 8e4 * t}; });
  expect_smooth("creepage", [](double t) { return Step{.creep = {2e-3 * t, -1e-3 + 2e-3 * t, 1e-4}}; });
}

}  // namespace
}  // namespace rollcon
