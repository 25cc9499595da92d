// Tests what holds for every elastic body at rest: equilibrium, linearity, independence of axes and units; supports
// that do not hold it; edges where held faces meet.

#include "support/error.hpp"
#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;

constexpr double young = 1e4, poisson = 0.3;

SurfaceMesh small_ring(ElementType type, int level) {
  return surfaces::ring({.zone = 30,
                         .around = 14 << level,
                         .zone_around = 3 << level,
                         .across = 1 << level,
                         .deep = 2 << level,
                         .largest = 0,
                         .top_layer = 0},
                        type);
}

class Statics : public ::testing::TestWithParam<ElementType> {};

TEST_P(Statics, reactions_balance_the_load_as_the_mesh_refines) {
  const Vec3 load{30, 20, -100};
  double error[2][2];
  for (const int level : {0, 1}) {
    StaticBody body(small_ring(GetParam(), level), young, poisson);
    body.hold_tags({3}).traction(2, load).solve();
    const auto acting = body.resultant({1, 2, 4, 5}), reaction = body.resultant({3});
    error[0][level] = length(acting.force + reaction.force) / length(acting.force);
    error[1][level] = length(acting.moment + reaction.moment) / (50 * length(acting.force));
  }
  const std::string what = surfaces::name_of(GetParam());
  const bool quadratic = is_quadratic(GetParam());
  expect_error(what + " ring, force, coarse", error[0][0], quadratic ? 0.01 : 0.12);
  expect_error(what + " ring, force, fine", error[0][1], quadratic ? 0.0015 : 0.07);
  expect_order(what + " ring, force", observed_order(error[0][0], error[0][1], 2, 1), quadratic ? 2 : 0.7);
  expect_error(what + " ring, moment, fine", error[1][1], quadratic ? 0.001 : 0.1);
}

// The bound is the integrals' accuracy: which tractions are wanted decides over rules used for several.
TEST_P(Statics, loads_superpose) {
  const SurfaceMesh mesh = small_ring(GetParam(), 0);
  const auto given = [](const Vec3& x) { return Vec3{1e-3 * x[1], 2e-3, -1e-4 * x[0]}; };
  StaticBody loaded(mesh, young, poisson), moved(mesh, young, poisson), both(mesh, young, poisson);
  loaded.hold_tags({3}).traction(2, {1, 2, -5}).pressure(4, 3).solve();
  moved.hold_tags({3}, 7, given).solve();
  both.hold_tags({3}, 7, given).traction(2, {2, 4, -10}).pressure(4, 6).solve();
  double error = 0, size = 0;
  for (std::int32_t k = 0; k < mesh.nodes(); ++k) {
    const Vec3 u = 2.0 * loaded.displacement(k) + moved.displacement(k);
    error = std::max(error, length(both.displacement(k) - u));
    size = std::max(size, length(u));
  }
  expect_error(surfaces::name_of(GetParam()) + " ring, superposition", error / size, 1e-7);
}

// A body turned, shifted far away, and in other units has the same displacements in its own terms.
TEST_P(Statics, axes_and_units_do_not_matter) {
  const SurfaceMesh mesh = small_ring(GetParam(), 0);
  const auto solve = [](const SurfaceMesh& m, double e, const Vec3& load) {
    auto body = std::make_unique<StaticBody>(m, e, poisson);
    body->hold_tags({3}).traction(2, load).solve();
    return body;
  };
  const auto reference = solve(mesh, young, {1, 2, -5});
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turn = [=](const Vec3& v) {
    const Vec3 a{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    return Vec3{c * a[0] + s * a[2], a[1], -s * a[0] + c * a[2]};
  };
  const auto compare = [&](const char* what, const StaticBody& other, const std::function<Vec3(const Vec3&)>& expected,
                           double bound) {
    double error = 0, size = 0;
    for (std::int32_t k = 0; k < mesh.nodes(); ++k) {
      const Vec3 u = expected(reference->displacement(k));
      error = std::max(error, length(other.displacement(k) - u));
      size = std::max(size, length(u));
    }
    expect_error(surfaces::name_of(GetParam()) + " ring, " + what, error / size, bound);
  };
  const auto turned = solve(surfaces::transform(mesh, turn), young, turn({1, 2, -5}));
  compare("turned", *turned, turn, 1e-6);
  const auto shifted = solve(surfaces::transform(mesh,
                                                 [](const Vec3& x) {
                                                   return x + Vec3{1e4, -2e4, 5e3};
                                                 }),
                             young, {1, 2, -5});
  compare(
      "shifted", *shifted, [](const Vec3& u) { return u; }, 1e-8);
  for (const auto& [unit, length_unit, stress_unit] :
       {std::tuple{"m and Pa", 1e-3, 1e6}, std::tuple{"um and GPa", 1e3, 1e-3},
        std::tuple{"extreme units", 1e-20, 1e30}}) {
    const double scale = length_unit;
    const auto other = solve(surfaces::transform(mesh, [scale](const Vec3& x) { return scale * x; }),
                             stress_unit * young, stress_unit * Vec3{1, 2, -5});
    compare(
        unit, *other, [scale](const Vec3& u) { return scale * u; }, 1e-8);
  }
}

TEST_P(Statics, the_error_of_the_integrals_follows_the_accuracy_asked_for) {
  const SurfaceMesh mesh = small_ring(GetParam(), 0);
  const auto solve = [&](double accuracy) {
    auto body = std::make_unique<StaticBody>(mesh, young, poisson, accuracy);
    body->hold_tags({3}).traction(2, {1, 2, -5}).solve();
    return body;
  };
  const auto exact = solve(1e-10);
  for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
    const auto body = solve(accuracy);
    double error = 0, size = 0;
    for (std::int32_t k = 0; k < mesh.nodes(); ++k) {
      size = std::max(size, length(exact->displacement(k)));
      error = std::max(error, length(exact->displacement(k) - body->displacement(k)));
    }
    expect_error(
        surfaces::name_of(GetParam()) + " ring, accuracy 1e" + std::to_string(std::lround(std::log10(accuracy))),
        error / size, 2 * accuracy);
  }
}

// All held faces react where two and three of them meet in edges and corners.
TEST_P(Statics, clamped_edges_and_corners_are_well_conditioned) {
  const SurfaceMesh brick =
      surfaces::distort(surfaces::block(surfaces::brick({4, 3, 3}, {2, 1, 1}), GetParam()), 0.15, 4);
  const struct {
    const char* what;
    std::initializer_list<std::int32_t> held;
  } cases[] = {{"one face", {1}},
               {"opposite faces", {1, 2}},
               {"an edge", {1, 3}},
               {"a corner", {1, 3, 5}},
               {"all but one face", {1, 2, 3, 4, 5}}};
  double open = 0;
  for (const auto& c : cases) {
    StaticBody body(brick, young, poisson);
    body.hold_tags(c.held).traction(6, {20, -10, 50}).solve();
    const double condition = body.body().response()->statistics().condition;
    if (open == 0) open = condition;
    const std::string what = surfaces::name_of(GetParam()) + " brick held at " + c.what;
    expect_error(what + ", condition (Frobenius norms)", condition, 2e4);
    expect_error(what + ", condition over that of one face", condition / open, 2);
    const auto acting = body.resultant({6}), all = body.resultant({1, 2, 3, 4, 5, 6});
    expect_error(what + ", balance of forces", length(all.force) / length(acting.force),
                 is_quadratic(GetParam()) ? 0.01 : 0.06);
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, Statics, ::testing::Values(ElementType::quad4),
                         [](const auto& param) { return surfaces::name_of(param.param); });
INSTANTIATE_TEST_SUITE_P(Bodies_long, Statics,
                         ::testing::Values(ElementType::tri3, ElementType::tri6, ElementType::quad8,
                                           ElementType::quad9),
                         [](const auto& param) { return surfaces::name_of(param.param); });

/// Returns the message, after checking the status.
std::string refusal(StaticBody& body) {
  try {
    body.solve();
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_singular) << e.what();
    return e.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

void expect_refused(const std::string& what, StaticBody& body) {
  const std::string message = refusal(body);
  std::printf("%s: %s\n", what.c_str(), message.c_str());
  EXPECT_NE(message.find("rollcon_body_set_support"), std::string::npos) << "names no remedy";
  EXPECT_FALSE(body.body().prepared());
}

TEST(Supports, bodies_that_can_move_are_refused_with_the_remedy) {
  const auto cube = [] { return surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), ElementType::quad8); };
  StaticBody loose(cube(), young, poisson);
  expect_refused("no supports", loose.traction(6, {0, 0, 1}));

  StaticBody hinged(cube(), young, poisson);
  const auto edge = surfaces::nodes_where(hinged.mesh(), [](const Vec3& x) { return x[0] == 0 && x[1] == 0; });
  expect_refused("held along an edge", hinged.hold(edge));

  StaticBody pinned(cube(), young, poisson);
  const std::int32_t node[] = {surfaces::node_at(pinned.mesh(), {1, 1, 1})};
  expect_refused("held at a node", pinned.hold(node));

  StaticBody sliding(cube(), young, poisson);
  expect_refused("held along z only", sliding.hold_tags({1, 2, 3, 4, 5, 6}, 4));

  StaticBody spinning(surfaces::ring({.around = 12, .zone_around = 4, .across = 2, .deep = 2}, ElementType::quad4),
                      young, poisson);
  expect_refused("ring between planes", spinning.hold_tags({4, 5}, 2));
}

TEST(Supports, a_refused_body_can_be_mended) {
  StaticBody body(surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), ElementType::quad4), young, poisson);
  body.traction(2, {1, 0, 0});
  expect_refused("no supports", body);
  body.hold_tags({1}, 1).hold_tags({3}, 2).hold_tags({5}, 4).solve();
  expect_error("mended cube, stretch", body.displacement(Vec3{1, 1, 1})[0] - 1 / young, 1e-5 / young);
}

}  // namespace
}  // namespace rollcon
