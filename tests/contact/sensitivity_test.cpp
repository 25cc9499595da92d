/// Compares derivatives of results with central differences of whole solves on both sides, at which every node keeps
/// its state; tests sums that must hold.

#include <algorithm>

#include "contact/sensitivity_case.hpp"
#include "support/frames.hpp"
#include "support/surface_meshes.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

using namespace sensitivity_test;

constexpr const char* names[] = {"longitudinal", "lateral", "normal", "spin", "friction"};

struct Group {
  const char* name;
  std::size_t first, end;
};
constexpr Group groups[] = {
    {"force", 0, 3}, {"moment", 3, 6}, {"approach", 6, 7}, {"creepages", 7, 9}, {"spin", 9, 10}};

/// Returns the error of each kind of result over the largest derivative of that kind; where all of a kind vanish, over
/// the result itself (moments: the normal force times a length of 1) per size of the parameter.
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
  for (const std::int32_t p : parameters) found[static_cast<std::size_t>(p) - 1] = derivatives(*s.pair, p);
  std::string kind;
  for (const bool force : drive.by_force) kind += force ? 'F' : 'm';
  for (const std::int32_t p : parameters) {
    const auto i = static_cast<std::size_t>(p) - 1;
    const double error = error_of(found[i], s.difference(p), result, s.scale(p));
    expect_error(what + ", " + kind + ", by " + names[i], error, bound);
  }
}

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

// Puts the top of an elastic block, curved or flat, under a sphere.
std::unique_ptr<RollingPair> block(bool finite_elements, double bulge) {
  surfaces::Block shape = surfaces::brick({8, 8, 4}, {2, 2, 1});
  shape.map = [=](const Vec3& p) {
    const double x = p[0] - 1, y = p[1] - 1;
    return Vec3{x, y, p[2] - 1 - bulge * p[2] * (x * x + 0.7 * y * y)};
  };
  scenes::MeshedBody body = finite_elements ? scenes::meshed(volumes::block(shape, VolumeType::hex8), steel)
                                            : scenes::meshed(surfaces::block(shape, ElementType::quad4), steel);
  body.held_tag = {5};
  auto pair = std::make_unique<RollingPair>(body, scenes::RigidBody{}, 1);
  pair->frame_from_body(1, 6).gap_quadratic(0.15, 0.12);
  return pair;
}

const Drive on_block{0.06, -1e-2, 6e-3, 8e-3, 0.3};

TEST(sensitivity, of_boundary_and_finite_elements) {
  if (rollcon_has_feature("bem"))
    for (const double bulge : {0.0, 0.08})
      for (const auto& way : {ways[0], ways[2], ways[5]})
        check(bulge > 0 ? "curved BEM" : "flat BEM", block(false, bulge), with(way, on_block));
  if (rollcon_has_feature("fem"))
    for (const auto& way : {ways[1], ways[5]}) check("flat FEM", block(true, 0), with(way, on_block));
}

TEST(sensitivity, where_everything_slides_or_little_is_prescribed) {
  // The direction of friction still turns with the creepages under full sliding.
  check("full sliding", half_spaces(std::nullopt), {0.02, -8e-2, 3e-2, 2e-2, 0.3, {}});
  check("full sliding under a load", half_spaces(steel), {0.02, 5e-2, 4e-2, 1e-2, 0.2, ways[1]});
  check("lateral creepage alone", half_spaces(std::nullopt), {0.02, 0, 7e-4, 0, 0.3, ways[1]});
}

void give(RollingPair& pair, const char* law, const std::vector<double>& parameters) {
  must(rollcon_contact_set_friction(pair.handle(), law, static_cast<std::int32_t>(parameters.size()),
                                    parameters.data()));
}

TEST(sensitivity, under_orthotropic_friction) {
  for (const char* law : {"orthotropic", "orthotropic_collinear"})
    for (const bool coupled : {false, true})
      for (const auto& way : {ways[0], ways[2], ways[5]}) {
        Drive drive = with(way);
        drive.law = [law](RollingPair& pair, double mu) { give(pair, law, {mu, 0.5 * mu, 0.6}); };
        check(std::string(law) + (coupled ? ", on rigid" : ", identical"),
              half_spaces(coupled ? std::optional<Elastic>{} : steel), drive);
      }
}

TEST(sensitivity, under_friction_that_falls_with_slip) {
  for (const char* law : {"linear", "rational", "exponential"})
    for (const bool coupled : {false, true})
      for (const auto& way : {ways[0], ways[2], ways[5]}) {
        Drive drive = with(way);
        drive.law = [law](RollingPair& pair, double mu) { give(pair, law, {0.5 * mu, 0.5 * mu, 4e-3}); };
        check(std::string(law) + (coupled ? ", on rigid" : ", identical"),
              half_spaces(coupled ? std::optional<Elastic>{} : steel), drive);
      }
}

using Matrix = std::array<std::array<double, 4>, 4>;

// Returns the rates of (F1, F2, -F3, M3); below, those of (xi1, xi2, approach, spin), by what is prescribed.
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
    // The products have different units, so they are taken in units of the values themselves.
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

    // Motions give back, with loads held, what friction does with motions held.
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
  // Creepages, spin and friction times f give tangential forces and the spin moment times f.
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
  expect_error("dF1/dxi1 of full stick against F1/xi1", derivatives(*stick.pair, ROLLCON_LONGITUDINAL)[0] / slope - 1,
               1e-9);
  EXPECT_LT(slope, 0) << "a force against the creepage";
  const Values none = derivatives(*stick.pair, ROLLCON_FRICTION);
  for (const double d : none) EXPECT_EQ(d, 0) << "nothing slides";

  Setting slide(half_spaces(steel), {0.02, 90, 0, 0, 0.1, {}});
  EXPECT_EQ(slide.pair->stat("nodes_stick"), 0);
  const Values v = observe(*slide.pair);
  expect_error("dF1/dln(mu) of full sliding against F1", derivatives(*slide.pair, ROLLCON_FRICTION)[0] / v[0] - 1,
               1e-10);
  expect_error("dF1/dxi1 of full sliding over F1/xi1", derivatives(*slide.pair, ROLLCON_LONGITUDINAL)[0] * 90 / v[0],
               1e-10);
  const Values normal = derivatives(*slide.pair, ROLLCON_NORMAL);
  expect_error("dF1/dF3 of full sliding against the friction coefficient", normal[0] / normal[2] / 0.1 - 1, 1e-9);
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
    EXPECT_EQ(rollcon_contact_get_sensitivity(s.pair->handle(), ROLLCON_SPIN, nullptr, nullptr, nullptr, nullptr),
              ROLLCON_ERR_STATE);
  }
}

}  // namespace
}  // namespace rollcon
