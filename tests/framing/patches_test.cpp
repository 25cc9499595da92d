/// Tests contacts without a caller's frame under gaps given on grids: of any shape, of several patches, cut by edges.

#include "rollcon.h"
#include "support/scene.hpp"
#include "support/steady_rolling.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;
using scenes::Solution;
const Elastic steel = scenes::steady_rolling::steel;
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double load = 1000, mu = 0.3;

using Height = double (*)(double x, double y);

void give_gap(RollingPair& pair, Height height, double half, int points) {
  std::vector<double> gap;
  for (int j = 0; j < points; ++j)
    for (int i = 0; i < points; ++i)
      gap.push_back(height(half * (2.0 * i / (points - 1) - 1), half * (2.0 * j / (points - 1) - 1)));
  ASSERT_EQ(rollcon_contact_set_gap_grid(pair.handle(), points, -half, half, -half, half,
                                         static_cast<std::int64_t>(gap.size()), gap.data()),
            ROLLCON_OK)
      << rollcon_last_error();
}

struct Bounds {
  double x_least = INFINITY, x_greatest = -INFINITY, y_least = INFINITY, y_greatest = -INFINITY;
};

Bounds bounds(const Solution& s) {
  Bounds b;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    b.x_least = std::min(b.x_least, s.x[k]);
    b.x_greatest = std::max(b.x_greatest, s.x[k]);
    b.y_least = std::min(b.y_least, s.y[k]);
    b.y_greatest = std::max(b.y_greatest, s.y[k]);
  }
  return b;
}

struct Scene {
  const char* name;
  Height height;
  double half;
  int points;
  double force_bound, moment_bound;
  std::int32_t status = ROLLCON_OK;
};

/// Returns what lattices of 64 and 128 intervals tend to at first order: slip is taken half a step upstream of the
/// nodes.
Solution limit_of_lattices(RollingPair& pair, const std::array<double, 4>& sides) {
  Solution all[2];
  for (const int i : {0, 1}) {
    const int n = i == 0 ? 64 : 128;
    EXPECT_EQ(
        rollcon_contact_frame_rectangle(pair.handle(), ROLLCON_QUAD4, n, n, sides[0], sides[1], sides[2], sides[3]),
        ROLLCON_OK);
    EXPECT_EQ(pair.solve(), ROLLCON_OK);
    all[i] = pair.solution();
  }
  for (int c = 0; c < 3; ++c) {
    all[1].force[c] = 2 * all[1].force[c] - all[0].force[c];
    all[1].moment[c] = 2 * all[1].moment[c] - all[0].moment[c];
  }
  return all[1];
}

// Compares the scene with fine lattices under the same gap.
void expect_lattice(const Scene& scene) {
  RollingPair pair(steel, steel);
  pair.load(load).friction(mu).creep(-4e-4, 2e-4, 1e-4);
  give_gap(pair, scene.height, scene.half, scene.points);
  ASSERT_EQ(pair.solve(), scene.status) << scene.name;
  const Solution found = pair.solution();
  EXPECT_LE(pair.stat("error_estimate"), 0.005) << scene.name;
  const double length = std::sqrt(pair.stat("contact_area") / std::numbers::pi);
  Bounds b = bounds(found);
  const double margin = 0.02 * std::max(b.x_greatest - b.x_least, b.y_greatest - b.y_least);
  const auto out = [&](double value, double towards) {
    return std::isfinite(scene.height(value + towards * margin, 0)) &&
                   std::isfinite(scene.height(0, value + towards * margin))
               ? value + towards * margin
               : value;
  };
  const Solution lattice =
      limit_of_lattices(pair, {out(b.x_least, -1), out(b.x_greatest, 1), out(b.y_least, -1), out(b.y_greatest, 1)});
  const std::string name = scene.name;
  expect_error(name + ": force vector over mu Fn",
               std::hypot(found.force[0] - lattice.force[0], found.force[1] - lattice.force[1]) / (mu * load),
               scene.force_bound);
  expect_error(name + ": spin moment", (found.moment[2] - lattice.moment[2]) / (mu * load * length),
               scene.moment_bound);
  expect_error(name + ": approach", relative(found.approach, lattice.approach), 3e-3);
}

// The pressure of a cone has a peak as wide as its tip, a tenth of a strip: that is told.
TEST(patches_long, shapes_that_are_no_ellipse) {
  const Scene scenes[] = {
      {"fourth power",
       [](double x, double y) { return 1e-4 * std::pow((x - 0.3) * (x - 0.3) + (y + 0.2) * (y + 0.2), 2); }, 6, 121,
       5e-3, 5e-3},
      {"cone with a rounded tip",
       [](double x, double y) { return 3e-3 * std::sqrt((x - 0.3) * (x - 0.3) + (y + 0.2) * (y + 0.2) + 0.01); }, 8,
       161, 5e-3, 5e-3, ROLLCON_INACCURATE},
      {"egg", [](double x, double y) { return 1e-3 * (x * x + y * y) * (1 + 0.15 * x + 0.1 * y); }, 2.5, 51, 5e-3,
       5e-3},
  };
  for (const Scene& scene : scenes) expect_lattice(scene);
}

TEST(patches_long, two_bumps) {
  const Scene scenes[] = {
      {"beside each other, merging", [](double x, double y) { return 1e-3 * x * x + 2e-4 * std::pow(y * y - 2, 2); }, 6,
       121, 9e-3, 5e-3},
      {"beside each other, apart", [](double x, double y) { return 1e-3 * x * x + 2e-4 * std::pow(y * y - 6, 2); }, 7,
       141, 9e-3, 9e-3},
      {"behind each other, merging", [](double x, double y) { return 1e-3 * y * y + 1e-4 * std::pow(x * x - 2, 2); }, 7,
       141, 9e-3, 9e-3},
      {"behind each other, apart", [](double x, double y) { return 1e-3 * y * y + 2e-4 * std::pow(x * x - 6, 2); }, 7,
       141, 9e-3, 9e-3},
  };
  for (const Scene& scene : scenes) expect_lattice(scene);
}

TEST(patches_long, cut_by_an_edge_of_a_body) {
  const Scene scenes[] = {
      {"across the rolling direction",
       [](double x, double y) { return x > 0.5 + 1e-9 ? none : 1e-3 * (x * x + y * y); }, 5, 101, 7e-3, 5e-3},
      {"along the rolling direction", [](double x, double y) { return y > 0.5 + 1e-9 ? none : 1e-3 * (x * x + y * y); },
       5, 101, 7e-3, 5e-3},
  };
  for (const Scene& scene : scenes) expect_lattice(scene);
}

// Galin's solution for h = c r^4 has an approach of 8/3 c a^4 and a load of 8/5 E* a times it.
TEST(patches, fourth_power_without_friction_is_that_of_galin) {
  constexpr double c = 1e-4;
  const double modulus = closed_forms::effective_modulus(steel, steel);
  const double a = std::pow(load / (8.0 / 5 * 8.0 / 3 * modulus * c), 0.2), approach = 8.0 / 3 * c * std::pow(a, 4);
  RollingPair pair(steel, steel);
  pair.load(load).friction(0);
  give_gap(
      pair, [](double x, double y) { return c * (x * x + y * y) * (x * x + y * y); }, 10, 101);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  expect_error("approach", relative(pair.solution().approach, approach), 1.5e-3);
  expect_error("area", relative(pair.stat("contact_area"), std::numbers::pi * a * a), 2e-2);
  pair.approach(approach);
  ASSERT_EQ(pair.solve(), ROLLCON_OK);
  expect_error("load of that approach", relative(-pair.solution().force[2], load), 2e-3);
}

// A grid that samples a quadratic gap gives what the quadratic gap gives, wherever the contact lies on it.
TEST(patches, ellipses_on_a_grid_are_those_of_a_quadratic_gap) {
  for (const double angle : {0.0, 0.5, 2.2}) {
    static double A, B, C, x0, y0;
    const auto hertz = closed_forms::hertz_from_axes(2.5, 0.8, load, closed_forms::effective_modulus(steel, steel));
    const double c = std::cos(angle), s = std::sin(angle);
    A = hertz.A * c * c + hertz.B * s * s, B = hertz.A * s * s + hertz.B * c * c, C = 2 * (hertz.A - hertz.B) * c * s;
    x0 = 1.3, y0 = -2.1;
    const double spin = 2e-4;
    RollingPair quadratic(steel, steel), grid(steel, steel);
    quadratic.load(load).friction(mu).creep(4e-4, -3e-4, spin).gap_quadratic(A, B, C);
    ASSERT_EQ(quadratic.solve(), ROLLCON_OK);
    // Spin turns about the origin of the axes.
    grid.load(load).friction(mu).creep(4e-4 + spin * y0, -3e-4 - spin * x0, spin);
    give_gap(
        grid,
        [](double x, double y) { return A * (x - x0) * (x - x0) + B * (y - y0) * (y - y0) + C * (x - x0) * (y - y0); },
        40, 81);
    ASSERT_EQ(grid.solve(), ROLLCON_OK);
    const Solution expected = quadratic.solution(), found = grid.solution();
    const std::string name = "at " + std::to_string(angle);
    expect_error(name + ": force",
                 std::hypot(found.force[0] - expected.force[0], found.force[1] - expected.force[1]) / (mu * load),
                 5e-3);
    const double about_centre = found.moment[2] - (x0 * found.force[1] - y0 * found.force[0]);
    expect_error(name + ": moment about the middle", (about_centre - expected.moment[2]) / (mu * load * std::sqrt(2.0)),
                 3e-3);
    expect_error(name + ": approach", relative(found.approach, expected.approach), 1e-3);
  }
}

TEST(patches, units_do_not_matter) {
  std::array<double, 3> found[2];
  for (const int u : {0, 1}) {
    const double l = u == 0 ? 1 : 1e-3;
    const Elastic material{.shear = 82000 / (l * l), .poisson = 0.28};
    RollingPair pair(material, material);
    pair.load(load).friction(mu).creep(-4e-4, 2e-4, 1e-4 / l);
    std::vector<double> gap;
    constexpr int points = 81;
    for (int j = 0; j < points; ++j)
      for (int i = 0; i < points; ++i) {
        const double x = 0.15 * i - 6, y = 0.15 * j - 6;
        gap.push_back(l * 1e-4 * std::pow((x - 1) * (x - 1) + y * y, 2));
      }
    ASSERT_EQ(
        rollcon_contact_set_gap_grid(pair.handle(), points, -6 * l, 6 * l, -6 * l, 6 * l, points * points, gap.data()),
        ROLLCON_OK);
    ASSERT_EQ(pair.solve(), ROLLCON_OK);
    const Solution s = pair.solution();
    found[u] = {s.force[0] / load, s.force[1] / load, s.moment[2] / (load * l)};
  }
  for (std::size_t i = 0; i < 3; ++i) expect_error("mm and m", found[0][i] - found[1][i], 1e-9);
}

TEST(patches, the_end_of_the_data_is_told) {
  RollingPair pair(steel, steel);
  pair.load(load).friction(mu).creep(1e-3, 0, 0);
  give_gap(
      pair, [](double x, double y) { return 1e-3 * ((x - 2) * (x - 2) + y * y); }, 2.5, 51);
  EXPECT_EQ(pair.solve(), ROLLCON_RIM_CONTACT);
  give_gap(
      pair, [](double x, double y) { return 1e-3 * ((x - 2) * (x - 2) + y * y); }, 5, 101);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
}

// Lattices of the search touch in a few nodes at first, which concerns nobody else.
TEST(patches, the_search_warns_of_nothing_and_can_be_cancelled) {
  struct Heard {
    int warnings = 0;
    rollcon_contact* cancel = nullptr;
  } heard;
  RollingPair pair(steel, steel);
  pair.load(load).friction(mu).creep(1e-3, 0, 0);
  give_gap(
      pair, [](double x, double y) { return 1e-3 * ((x - 7) * (x - 7) + y * y); }, 20, 81);
  const auto listen = [](std::int32_t level, const char*, void* user) {
    Heard& h = *static_cast<Heard*>(user);
    h.warnings += level == ROLLCON_LOG_WARNING;
    if (h.cancel) rollcon_contact_request_cancel(h.cancel);
  };
  ASSERT_EQ(rollcon_context_set_log(pair.context(), ROLLCON_LOG_INFO, listen, &heard), ROLLCON_OK);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  rollcon_contact_reset(pair.handle());
  heard.cancel = pair.handle();
  EXPECT_EQ(pair.solve(), ROLLCON_CANCELLED);
  heard.cancel = nullptr;
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
  EXPECT_EQ(heard.warnings, 0);
}

TEST(patches, bodies_apart_are_told) {
  RollingPair pair(steel, steel);
  pair.approach(-0.1).friction(mu).creep(1e-3, 0, 0);
  give_gap(
      pair, [](double x, double y) { return 1e-3 * (x * x + y * y); }, 5, 51);
  EXPECT_EQ(pair.solve(), ROLLCON_NO_CONTACT);
  EXPECT_EQ(pair.solution().force[0], 0);
  pair.load(0);
  EXPECT_EQ(pair.solve(), ROLLCON_NO_CONTACT);
  pair.load(load);
  EXPECT_EQ(pair.solve(), ROLLCON_OK);
}

TEST(patches, refusals) {
  RollingPair pair(steel, steel);
  pair.load(load).friction(mu);
  std::vector<double> gap(12, 0.0);
  const auto expect_refusal = [&](int nx, double x_greatest, std::int64_t n, std::int32_t status, const char* words) {
    EXPECT_EQ(rollcon_contact_set_gap_grid(pair.handle(), nx, 0, x_greatest, 0, 1, n, gap.data()), status);
    EXPECT_NE(std::string(rollcon_last_error()).find(words), std::string::npos) << rollcon_last_error();
  };
  expect_refusal(1, 1, 12, ROLLCON_ERR_ARGUMENT, "nx is 1; allowed: 2 or more");
  expect_refusal(5, 1, 12, ROLLCON_ERR_ARGUMENT, "n is 12; allowed: a multiple of nx = 5, 2 lines or more");
  expect_refusal(12, 1, 12, ROLLCON_ERR_ARGUMENT, "2 lines or more");
  expect_refusal(4, -1, 12, ROLLCON_ERR_ARGUMENT, "x_least is 0 and x_greatest is -1");
  gap[6] = NAN;
  expect_refusal(4, 1, 12, ROLLCON_ERR_NONFINITE, "gap of point 2 of line 1 (both counting from 0) is nan");
  gap.assign(12, none);
  ASSERT_EQ(rollcon_contact_set_gap_grid(pair.handle(), 4, 0, 1, 0, 1, 12, gap.data()), ROLLCON_OK);
  EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(std::string(rollcon_last_error()).find("nowhere finite"), std::string::npos) << rollcon_last_error();
  // The caller's frame goes beyond the grid.
  give_gap(
      pair, [](double x, double y) { return 1e-3 * (x * x + y * y); }, 1, 11);
  ASSERT_EQ(rollcon_contact_frame_rectangle(pair.handle(), ROLLCON_QUAD4, 8, 8, -2, 2, -1, 1), ROLLCON_OK);
  EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_ARGUMENT);
  EXPECT_NE(std::string(rollcon_last_error()).find("lies where the grid of the gap ends"), std::string::npos)
      << rollcon_last_error();
}

}  // namespace
}  // namespace rollcon
