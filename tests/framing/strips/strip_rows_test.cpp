/// Rows of strips near jumps of curvature: peaks of pressure at rounded ends of rollers.

#include "framing/strips/strip_rows.hpp"

#include "framing/strips/strip_families.hpp"

namespace rollcon::strips {
namespace {

/// A straight roller on a plane, with rounded ends, tilted; lengths in mm.
struct Roller : PlaneField {
  double radius, straight, edge, tilt;

  Roller(double r, double length, double of_edge, double by = 0)
      : radius(r), straight(length), edge(of_edge), tilt(by) {}
  void at(std::span<const Vec2> point, double* value, Vec2* slope) const override {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const auto [x, y] = point[i];
      const double beyond = std::max(std::abs(y) - straight / 2, 0.0), on = std::min(beyond, 0.99 * edge);
      const double root = std::sqrt(edge * edge - on * on), by = on / root;
      value[i] = x * x / (2 * radius) + tilt * y + edge - root + by * (beyond - on);
      if (slope) slope[i] = {x / radius, tilt + (y < 0 ? -by : by)};
    }
  }
};

struct RollerCase {
  Roller gap;
  StripScene scene;
  StripState state;

  RollerCase(const Roller& roller, double load) : gap(roller) {
    scene.bodies = equal_bodies(210e3 / 2.6, 0.3);
    scene.value = load;
    scene.mu = 0.3;
    scene.motion = {-1e-4, 1e-4, 0};
  }
  StripStatus solve(StripCounts counts, bool warm = false) {
    scene.gap = &gap;
    const double half = 3 * std::sqrt(8 * scene.bodies.cn * scene.value * gap.radius / gap.straight),
                 end = gap.straight / 2 + std::min(0.9 * gap.edge, 2.0);
    return finder_.find(scene, {-half, half, -end, end}, counts, state, warm).status;
  }

 private:
  StripFinder finder_;
};

// Lattices of 96 x 960 cells have these pressures.
TEST(strip_rows, peaks_at_rounded_ends_are_those_of_lattices) {
  const struct {
    Roller roller;
    double load, pressure;
  } cases[] = {{{6, 6, 5}, 3000, 2567}, {{200, 45, 8}, 1e5, 1987}, {{150, 40, 10}, 6e4, 1647}};
  for (const auto& [roller, load, pressure] : cases) {
    RollerCase test(roller, load);
    const std::string name = "edge of " + std::to_string(roller.edge) + " mm, ";
    for (const auto& [counts, bound] : {std::pair{StripCounts{8, 12}, 0.07}, {StripCounts{16, 24}, 0.01}}) {
      ASSERT_EQ(test.solve(counts), StripStatus::solved);
      const PressurePeak peak = largest_pressure(test.state);
      expect_error(name + std::to_string(counts.across) + " intervals", peak.pressure / pressure - 1, bound);
      EXPECT_GT(std::abs(peak.at[1]), roller.straight / 2);
    }
  }
}

TEST(strip_rows, are_where_the_scene_wants_them) {
  for (const double edge : {0.4, 5.0})
    for (const double tilt : {0.0, 5e-4, 5e-3}) {
      RollerCase cold({6, 9.2, edge, tilt}, 3000), warm({6, 9.2, edge, tilt}, 2500);
      ASSERT_EQ(cold.solve({8, 12}), StripStatus::solved) << edge << " " << tilt;
      ASSERT_EQ(warm.solve({8, 12}), StripStatus::solved) << edge << " " << tilt;
      EXPECT_TRUE(is_laid(cold.state.layout));
      for (const double load : {2600.0, 2800.0, 3000.0}) {
        warm.scene.value = load;
        ASSERT_EQ(warm.solve({8, 12}, true), StripStatus::solved) << edge << " " << tilt;
      }
      const StripTotals a = StripSolver::totals(cold.state), b = StripSolver::totals(warm.state);
      const std::string name = "cold and warm, edge " + std::to_string(edge) + ", tilt " + std::to_string(tilt);
      expect_error(name + ", force", (a.force[0] - b.force[0]) / 900, 1e-7);
      expect_error(name + ", approach", a.approach / b.approach - 1, 1e-8);
      expect_error(name + ", peak", largest_pressure(cold.state).pressure / largest_pressure(warm.state).pressure - 1,
                   1e-5);
    }
}

TEST(strip_rows, mirrored_rollers_are_alike) {
  RollerCase one({6, 9.2, 0.4, 1e-3}, 3000), other({6, 9.2, 0.4, -1e-3}, 3000);
  other.scene.motion[1] = -other.scene.motion[1];
  ASSERT_EQ(one.solve({12, 18}), StripStatus::solved);
  ASSERT_EQ(other.solve({12, 18}), StripStatus::solved);
  expect_error("force along",
               (StripSolver::totals(one.state).force[0] - StripSolver::totals(other.state).force[0]) / 900, 1e-7);
  expect_error("peak", largest_pressure(one.state).pressure / largest_pressure(other.state).pressure - 1, 1e-6);
}

// Contacts that end far from corners, or without any, keep the usual rows.
TEST(strip_rows, stay_where_there_are_no_corners) {
  for (const auto kind : {FamilyGap::ellipse, FamilyGap::arcs}) {
    StripCase test(kind, 0.3);
    test.scene.value = 1e4;
    StripFinder finder;
    StripState state;
    ASSERT_EQ(finder.find(test.now(), wide, {8, 12}, state, false).status, StripStatus::solved);
    EXPECT_FALSE(is_laid(state.layout));
  }
}

}  // namespace
}  // namespace rollcon::strips
