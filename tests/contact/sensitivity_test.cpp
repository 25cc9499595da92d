/// Derivatives of results against central differences of whole solves on both sides, at which every
/// node keeps its state; sums that must hold; and what they cost.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/surface_meshes.hpp"
#include "support/volume_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using scenes::Elastic;
using scenes::RollingPair;
using validation::expect_error;

constexpr std::int32_t parameters[] = {ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_NORMAL,
                                       ROLLCON_SPIN, ROLLCON_FRICTION};
constexpr const char* names[] = {"longitudinal", "lateral", "normal", "spin", "friction"};

/// Force, moment, approach, creepages and spin; in groups of one kind each.
using Values = std::array<double, 10>;
struct Group {
  const char* name;
  std::size_t first, end;
};
constexpr Group groups[] = {
    {"force", 0, 3}, {"moment", 3, 6}, {"approach", 6, 7}, {"creepages", 7, 9}, {"spin", 9, 10}};

void must(std::int32_t status) {
  ASSERT_EQ(status, ROLLCON_OK) << rollcon_status_string(status);
}

Values observe(const RollingPair& pair) {
  Values v{};
  must(rollcon_contact_get_resultant(pair.handle(), ROLLCON_LOCAL, &v[0], &v[3]));
  must(rollcon_contact_get_motion(pair.handle(), &v[6], &v[7]));
  return v;
}

Values derivatives(const RollingPair& pair, std::int32_t parameter) {
  Values v{};
  must(rollcon_contact_get_sensitivity(pair.handle(), parameter, &v[0], &v[3], &v[6], &v[7]));
  return v;
}

std::vector<std::int32_t> states(const RollingPair& pair) {
  return pair.solution().state;
}

/// What is prescribed: motions first; those of `by_force` then by the loads that they cause.
struct Drive {
  double approach, along, across, spin, mu;
  std::array<bool, 4> by_force{};  ///< longitudinal, lateral, normal, spin
};

struct Setting {
  std::unique_ptr<RollingPair> pair;
  Drive drive;
  std::array<double, 4> value{};

  /// Blocks are touched by a few nodes: rates of the discrete problem are exact all the same.
  void solve() {
    const std::int32_t status = pair->solve();
    EXPECT_TRUE(status == ROLLCON_OK || status == ROLLCON_COARSE) << status;
  }

  void prescribe(std::size_t direction, double v) {
    const std::int32_t how = drive.by_force[direction] ? ROLLCON_BY_FORCE : ROLLCON_BY_MOTION;
    must(rollcon_contact_prescribe(pair->handle(), static_cast<std::int32_t>(direction) + 1, how,
                                   v));
  }

  /// Solves, and prescribes the loads found where wanted.
  Setting(std::unique_ptr<RollingPair> made, const Drive& wanted)
      : pair(std::move(made)), drive(wanted) {
    pair->option("tolerance", 1e-13);
    pair->friction(drive.mu).approach(drive.approach).creep(drive.along, drive.across, drive.spin);
    solve();
    const Values v = observe(*pair);
    value = {drive.along, drive.across, drive.approach, drive.spin};
    const std::array<double, 4> load = {v[0], v[1], -v[2], v[5]};
    for (std::size_t d = 0; d < 4; ++d) {
      if (drive.by_force[d]) value[d] = load[d];
      prescribe(d, value[d]);
    }
    solve();
  }

  double scale(std::int32_t parameter) const {
    if (parameter == ROLLCON_FRICTION) return 1;
    const auto d = static_cast<std::size_t>(parameter) - 1;
    if (value[d] != 0) return std::abs(value[d]);
    return 1e-3;  // of a creepage or spin that is zero
  }

  /// Solves with the parameter moved; the states of the nodes are those of the last solve.
  Values moved(std::int32_t parameter, double by) {
    const std::vector<std::int32_t> before = states(*pair);
    const auto d = static_cast<std::size_t>(parameter) - 1;
    if (parameter == ROLLCON_FRICTION)
      pair->friction(drive.mu * (1 + by));
    else
      prescribe(d, value[d] + by);
    solve();
    EXPECT_EQ(states(*pair), before) << "choose a state away from changes of stick and slip";
    const Values v = observe(*pair);
    if (parameter == ROLLCON_FRICTION)
      pair->friction(drive.mu);
    else
      prescribe(d, value[d]);
    return v;
  }

  /// Fourth-order central difference.
  Values difference(std::int32_t parameter) {
    const double h = 1e-4 * scale(parameter);
    const Values a = moved(parameter, -2 * h), b = moved(parameter, -h), c = moved(parameter, h),
                 e = moved(parameter, 2 * h);
    Values slope{};
    for (std::size_t i = 0; i < slope.size(); ++i)
      slope[i] = (8 * (c[i] - b[i]) - (e[i] - a[i])) / (12 * h);
    return slope;
  }
};

/// Error of each kind of result over the largest derivative of that kind; where all of a kind
/// vanish, over the result itself (moments: the normal force times a length of 1) per size of the
/// parameter.
double error_of(const Values& found, const Values& wanted, const Values& result, double scale) {
  double worst = 0;
  for (const Group& g : groups) {
    double error = 0, largest = 0, natural = 0;
    for (std::size_t i = g.first; i < g.end; ++i) {
      error = std::max(error, std::abs(found[i] - wanted[i]));
      largest = std::max(largest, std::abs(wanted[i]));
      natural = std::max(natural, std::abs(result[g.first == 3 ? 2 : i]) / scale);
    }
    const double by = std::max(largest, 1e-3 * natural);
    if (error > 0) worst = std::max(worst, error / by);
  }
  return worst;
}

constexpr double bound = 1e-6;

void check(const std::string& what, std::unique_ptr<RollingPair> made, const Drive& drive) {
  Setting s(std::move(made), drive);
  const Values result = observe(*s.pair);
  std::array<Values, 5> found{};
  for (const std::int32_t p : parameters)
    found[static_cast<std::size_t>(p) - 1] = derivatives(*s.pair, p);
  std::string kind;
  for (const bool force : drive.by_force) kind += force ? 'F' : 'm';
  for (const std::int32_t p : parameters) {
    const auto i = static_cast<std::size_t>(p) - 1;
    const double error = error_of(found[i], s.difference(p), result, s.scale(p));
    expect_error(what + ", " + kind + ", by " + names[i], error, bound);
  }
}

// Sphere of radius 50 on a half-space or a rigid plane; contact radius about 1.
const Elastic steel{.shear = 1e4 / 2.6, .poisson = 0.3};
const Elastic soft{.shear = 1e4 / 2.2, .poisson = 0.1};

std::unique_ptr<RollingPair> half_spaces(const std::optional<Elastic>& other, int n = 14) {
  auto pair = std::make_unique<RollingPair>(steel, other);
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, n);
  pair->frame(frames::rectangle(ElementType::quad4, lines, lines)).gap_quadratic(0.011, 0.009);
  return pair;
}

constexpr Drive rolling{0.02, -9e-4, 5e-4, 6e-4, 0.3};

Drive with(std::array<bool, 4> by_force, Drive drive = rolling) {
  drive.by_force = by_force;
  return drive;
}

constexpr std::array<bool, 4> ways[] = {{false, false, false, false}, {false, false, true, false},
                                        {true, false, false, false},  {false, true, true, false},
                                        {false, false, false, true},  {true, true, true, true}};

TEST(sensitivity, of_like_half_spaces_is_the_slope_of_solves) {
  for (const auto& way : ways) check("identical", half_spaces(steel), with(way));
}

TEST(sensitivity, of_unlike_half_spaces_is_the_slope_of_solves) {
  for (const auto& way : ways) check("on rigid", half_spaces({}), with(way));
  check("unlike", half_spaces(soft), with({true, false, true, false}));
}

TEST(sensitivity, under_every_linear_solver_and_scheme) {
  for (const bool coupled : {false, true})
    for (const char* solver : {"lu", "gmres", "auto"}) {
      auto pair = half_spaces(coupled ? std::optional<Elastic>{} : steel, 16);
      pair->option("linear_solver", solver);
      check(std::string(coupled ? "on rigid, " : "identical, ") + solver, std::move(pair),
            with({true, false, true, false}));
    }
  for (const char* scheme : {"godunov", "least_squares"}) {
    auto pair = half_spaces(std::nullopt);
    pair->option("convection", scheme);
    check(scheme, std::move(pair), with({true, true, true, false}));
  }
}

TEST(sensitivity, with_gaps_a_creep_field_and_turned_axes) {
  for (const auto& way : {ways[0], ways[3]}) {
    auto pair = half_spaces(soft);
    const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 14);
    std::vector<double> gap, slip;
    for (const double y : lines)
      for (const double x : lines) {
        gap.push_back(0.01 * (x * x + y * y) + 0.001 * x * x * x);
        slip.insert(slip.end(), {7e-4 * y * y, -4e-4 * x});
      }
    pair->rolling_at(0.4).speed(3).gap(gap).creep_field(slip);
    check("gap, creep field, axes", std::move(pair), with(way));
  }
}

// The top of an elastic block, curved or flat, under a sphere.
std::unique_ptr<RollingPair> block(bool finite_elements, double bulge) {
  surfaces::Block shape = surfaces::brick({8, 8, 4}, {2, 2, 1});
  shape.map = [=](const Vec3& p) {
    const double x = p[0] - 1, y = p[1] - 1;
    return Vec3{x, y, p[2] - 1 - bulge * p[2] * (x * x + 0.7 * y * y)};
  };
  scenes::MeshedBody body = finite_elements
                                ? scenes::meshed(volumes::block(shape, VolumeType::hex8), steel)
                                : scenes::meshed(surfaces::block(shape, ElementType::quad4), steel);
  body.held_tag = {5};
  auto pair = std::make_unique<RollingPair>(body, scenes::RigidBody{}, 1);
  pair->frame_from_body(1, 6).gap_quadratic(0.15, 0.12);
  return pair;
}

constexpr Drive on_block{0.06, -1e-2, 6e-3, 8e-3, 0.3};

TEST(sensitivity, of_boundary_and_finite_elements) {
  if (rollcon_has_feature("bem"))
    for (const double bulge : {0.0, 0.08})
      for (const auto& way : {ways[0], ways[2], ways[5]})
        check(bulge > 0 ? "curved BEM" : "flat BEM", block(false, bulge), with(way, on_block));
  if (rollcon_has_feature("fem"))
    for (const auto& way : {ways[1], ways[5]})
      check("flat FEM", block(true, 0), with(way, on_block));
}

TEST(sensitivity, where_everything_slides_or_little_is_prescribed) {
  // Full sliding: the direction of friction still turns with the creepages.
  check("full sliding", half_spaces(std::nullopt), {0.02, -8e-2, 3e-2, 2e-2, 0.3, {}});
  check("full sliding under a load", half_spaces(steel), {0.02, 5e-2, 4e-2, 1e-2, 0.2, ways[1]});
  check("lateral creepage alone", half_spaces(std::nullopt), {0.02, 0, 7e-4, 0, 0.3, ways[1]});
}

using Matrix = std::array<std::array<double, 4>, 4>;

// Rates of (F1, F2, -F3, M3) and of (xi1, xi2, approach, spin), by what is prescribed.
std::array<double, 4> loads(const Values& v) {
  return {v[0], v[1], -v[2], v[5]};
}
std::array<double, 4> motions(const Values& v) {
  return {v[7], v[8], v[6], v[9]};
}

TEST(sensitivity, by_motions_and_by_loads_are_inverse) {
  for (const bool coupled : {false, true}) {
    const auto other = coupled ? std::optional<Elastic>{} : steel;
    Setting by_motion(half_spaces(other), rolling), by_load(half_spaces(other), with(ways[5]));
    Matrix stiffness{}, flexibility{};
    double own = 0;
    for (std::size_t d = 0; d < 4; ++d) {
      const auto p = static_cast<std::int32_t>(d) + 1;
      const Values a = derivatives(*by_motion.pair, p), b = derivatives(*by_load.pair, p);
      for (std::size_t i = 0; i < 4; ++i) {
        stiffness[i][d] = loads(a)[i];
        flexibility[i][d] = motions(b)[i];
        own = std::max({own, std::abs(motions(a)[i] - (i == d)),
                        std::abs(loads(b)[i] - (i == d)) * by_load.value[d] / by_load.value[i]});
      }
    }
    // Products of different units: in units of the values themselves.
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k) sum += stiffness[i][k] * flexibility[k][j];
        const double unit = std::abs(by_load.value[j] / by_load.value[i]);
        worst = std::max(worst, std::abs(sum - (i == j)) * unit);
      }
    const std::string what = coupled ? "on rigid" : "identical";
    expect_error(what + ": stiffness times flexibility", worst, 1e-8);
    expect_error(what + ": what is prescribed, by itself", own, 1e-9);

    // Friction with loads held: motions give back what friction does with motions held.
    const auto at_motion = loads(derivatives(*by_motion.pair, ROLLCON_FRICTION));
    const auto at_load = motions(derivatives(*by_load.pair, ROLLCON_FRICTION));
    double error = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      double sum = at_motion[i];
      for (std::size_t k = 0; k < 4; ++k) sum += stiffness[i][k] * at_load[k];
      error = std::max(error, std::abs(sum / by_load.value[i]));
    }
    expect_error(what + ": friction at given loads and at given motions", error, 1e-8);
  }
}

TEST(sensitivity, tangential_loads_of_like_bodies_are_homogeneous) {
  // Creepages, spin and friction times f: tangential forces and the spin moment times f.
  Setting s(half_spaces(steel), rolling);
  const Values v = observe(*s.pair), by_friction = derivatives(*s.pair, ROLLCON_FRICTION);
  for (const std::size_t i : {0U, 1U, 5U}) {
    double sum = by_friction[i];
    for (const std::size_t d : {0U, 1U, 3U})
      sum += s.value[d] * derivatives(*s.pair, static_cast<std::int32_t>(d) + 1)[i];
    expect_error("Euler's sum of result " + std::to_string(i), sum / v[i] - 1, 1e-9);
  }
}

TEST(sensitivity, full_stick_is_linear_and_full_sliding_proportional_to_friction) {
  Setting stick(half_spaces(steel), {0.02, -1e-6, 0, 0, 1e3, {}});
  const double slope = observe(*stick.pair)[0] / -1e-6;
  EXPECT_EQ(stick.pair->stat("nodes_slip"), 0);
  expect_error("dF1/dxi1 of full stick against F1/xi1",
               derivatives(*stick.pair, ROLLCON_LONGITUDINAL)[0] / slope - 1, 1e-9);
  EXPECT_LT(slope, 0) << "a force against the creepage";
  const Values none = derivatives(*stick.pair, ROLLCON_FRICTION);
  for (const double d : none) EXPECT_EQ(d, 0) << "nothing slides";

  Setting slide(half_spaces(steel), {0.02, 90, 0, 0, 0.1, {}});
  EXPECT_EQ(slide.pair->stat("nodes_stick"), 0);
  const Values v = observe(*slide.pair);
  expect_error("dF1/dln(mu) of full sliding against F1",
               derivatives(*slide.pair, ROLLCON_FRICTION)[0] / v[0] - 1, 1e-10);
  expect_error("dF1/dxi1 of full sliding over F1/xi1",
               derivatives(*slide.pair, ROLLCON_LONGITUDINAL)[0] * 90 / v[0], 1e-10);
  const Values normal = derivatives(*slide.pair, ROLLCON_NORMAL);
  expect_error("dF1/dF3 of full sliding against the friction coefficient",
               normal[0] / normal[2] / 0.1 - 1, 1e-9);
}

TEST(sensitivity, without_friction_only_the_normal_problem_answers) {
  for (const bool by_force : {false, true}) {
    Setting s(half_spaces(std::nullopt), {0.02, 1e-3, 0, 0, 0, {false, false, by_force, false}});
    const Values result = observe(*s.pair), found = derivatives(*s.pair, ROLLCON_NORMAL);
    derivatives(*s.pair, ROLLCON_SPIN);
    EXPECT_EQ(s.pair->stat("sensitivity_right_sides"), 1) << "that of the pressures";
    expect_error(by_force ? "frictionless, by load" : "frictionless, by approach",
                 error_of(found, s.difference(ROLLCON_NORMAL), result, s.value[2]), bound);
    const Values along = derivatives(*s.pair, ROLLCON_LONGITUDINAL);
    EXPECT_EQ(along, (Values{0, 0, 0, 0, 0, 0, 0, 1, 0, 0}));
    EXPECT_EQ(derivatives(*s.pair, ROLLCON_FRICTION), Values{});
    must(rollcon_contact_prescribe(s.pair->handle(), ROLLCON_SPIN, ROLLCON_BY_FORCE, 0));
    EXPECT_EQ(s.pair->solve(), ROLLCON_OK);
    EXPECT_EQ(rollcon_contact_get_sensitivity(s.pair->handle(), ROLLCON_SPIN, nullptr, nullptr,
                                              nullptr, nullptr),
              ROLLCON_ERR_STATE);
  }
}

// Of the part that ends the solve.
double seconds_of_an_iteration(const RollingPair& pair) {
  std::int64_t count = 0;
  must(rollcon_contact_get_history(pair.handle(), 0, nullptr, &count));
  std::vector<double> rows(static_cast<std::size_t>(8 * count));
  must(rollcon_contact_get_history(pair.handle(), count, rows.data(), nullptr));
  const double* last = &rows[rows.size() - 8];
  const double* first = last;
  while (first != rows.data() && first[-8] == last[0]) first -= 8;
  return (last[7] - first[7]) / (last[1] - first[1]);
}

struct Cost {
  double iteration = INFINITY, first = INFINITY, all = INFINITY;  ///< seconds, least of several
  int first_krylov = 0, all_krylov = 0;
};

// All five, one after the other, each twice; counters after each stage.
void ask_for_all(const RollingPair& pair, bool coupled, bool lu, Cost& cost) {
  const auto count = [&](const char* what) {
    return static_cast<int>(pair.stat((std::string("sensitivity_") + what).c_str()));
  };
  EXPECT_EQ(count("right_sides"), 0) << "nothing before it is asked for";
  EXPECT_EQ(count("factorizations"), 0);
  derivatives(pair, ROLLCON_SPIN);
  EXPECT_EQ(count("right_sides"), 1);
  // GMRES goes on with the solve's factors unless they are too old.
  EXPECT_GE(count("factorizations"), lu ? 1 : 0);
  EXPECT_LE(count("factorizations"), 1);
  cost.first = std::min(cost.first, pair.stat("seconds_sensitivity"));
  cost.first_krylov = count("linear_iterations");
  for (const std::int32_t p : parameters) derivatives(pair, p);
  // Pressures that stand alone: one system of them and one of the tangential tractions.
  const int systems = coupled ? 1 : 2, right_sides = coupled ? 5 : 6;
  EXPECT_EQ(count("right_sides"), right_sides);
  EXPECT_GE(count("factorizations"), lu ? systems : 0);
  EXPECT_LE(count("factorizations"), systems);
  const double all = pair.stat("seconds_sensitivity");
  for (const std::int32_t p : parameters) derivatives(pair, p);
  EXPECT_EQ(count("right_sides"), right_sides) << "kept";
  EXPECT_EQ(pair.stat("seconds_sensitivity"), all);
  cost.all = std::min(cost.all, all);
  cost.all_krylov = count("linear_iterations");
  EXPECT_LE(cost.all_krylov, lu ? 0 : 25 * right_sides);
}

TEST(sensitivity, costs_one_factorisation_and_its_right_sides) {
  for (const bool coupled : {false, true})
    for (const char* solver : {"lu", "gmres"}) {
      auto made = half_spaces(coupled ? std::optional<Elastic>{} : steel, 20);
      made->option("linear_solver", solver).option("operators", "dense");
      Setting s(std::move(made), with({true, false, true, false}));
      RollingPair& pair = *s.pair;
      pair.option("tolerance", 1e-10);
      Cost cost;
      for (int repeat = 0; repeat < 5; ++repeat) {
        pair.reset();
        ASSERT_EQ(pair.solve(), ROLLCON_OK);
        const double kernels = pair.stat("kernel_evaluations");
        const double factors = pair.stat("factorizations");
        cost.iteration = std::min(cost.iteration, seconds_of_an_iteration(pair));
        ask_for_all(pair, coupled, std::string(solver) == "lu", cost);
        EXPECT_EQ(pair.stat("kernel_evaluations"), kernels);
        EXPECT_EQ(pair.stat("factorizations"), factors) << "those of the solve";
        EXPECT_EQ(pair.stat("compliance_assemblies"), 1);
      }
      std::printf(
          "%-9s %-5s %g unknowns: the first takes %.2f, all five %.2f Newton iterations of %.2f "
          "ms; %d and %d Krylov iterations (at most 25 per right side)\n",
          coupled ? "coupled" : "decoupled", solver, pair.stat("unknowns"),
          cost.first / cost.iteration, cost.all / cost.iteration, 1e3 * cost.iteration,
          cost.first_krylov, cost.all_krylov);
    }
}

TEST(sensitivity, asking_does_not_change_the_next_solve) {
  for (const bool coupled : {false, true})
    for (const char* solver : {"lu", "gmres"}) {
      std::vector<double> work[2];
      Values result[2];
      for (const std::size_t asked : {0U, 1U}) {
        auto made = half_spaces(coupled ? std::optional<Elastic>{} : steel, 16);
        made->option("linear_solver", solver);
        Setting s(std::move(made), rolling);
        for (int step = 1; step <= 3; ++step) {
          for (const std::int32_t p : parameters)
            if (asked == 1) derivatives(*s.pair, p);
          s.pair->creep((1 + 0.1 * step) * rolling.along, rolling.across, rolling.spin);
          ASSERT_EQ(s.pair->solve(), ROLLCON_OK);
          for (const char* stat : {"iterations", "linear_iterations", "factorizations"})
            work[asked].push_back(s.pair->stat(stat));
        }
        result[asked] = observe(*s.pair);
      }
      EXPECT_EQ(work[0], work[1]);
      double worst = 0;
      for (std::size_t i = 0; i < result[0].size(); ++i)
        worst = std::max(worst, std::abs(result[1][i] - result[0][i]) / std::abs(result[0][2]));
      expect_error("results after asking", worst, 1e-13);
    }
}

}  // namespace
}  // namespace rollcon
