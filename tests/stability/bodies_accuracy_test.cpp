/// Tests answers of meshed bodies where they are easily wrong: near limits of the material, in other units, on thin
/// bodies.

#include "support/error.hpp"
#include "support/extreme_bodies.hpp"
#include "support/frames.hpp"
#include "support/static_cases.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using extremes::BlockShape;
using extremes::Model;
using extremes::Press;
using extremes::Scene;

struct Answer {
  scenes::Solution s;
  double iterations = 0;
};

Answer solve(const Scene& scene) {
  const auto pair = extremes::make_pair(scene);
  extremes::give_scene(*pair, scene);
  Answer a;
  const std::int32_t status = pair->solve();
  EXPECT_TRUE(status == ROLLCON_OK || status == ROLLCON_COARSE) << scene.name << status;
  a.s = pair->solution();
  a.iterations = pair->stat("iterations");
  return a;
}

/// Returns the largest difference of forces over mu Fn and of the approach, relative.
double difference(const Answer& a, const Answer& b) {
  double most = std::abs(a.s.approach / b.s.approach - 1);
  for (std::size_t c = 0; c < 3; ++c)
    most = std::max(most, std::abs(a.s.force[c] - b.s.force[c]) / std::abs(b.s.force[2]));
  return most;
}

void expect_below(const std::string& name, double error, double bound) {
  std::printf("%-60s error %9.2e  bound %9.2e\n", name.c_str(), error, bound);
  EXPECT_LE(error, bound) << name;
}

const char* name_of(Model model) {
  return model == Model::fem ? "finite elements" : "boundary elements";
}

Scene pressed(const BlockShape& shape, const scenes::AnyBody& second) {
  return extremes::scene_on_block("", name_of(shape.model), shape, second);
}

// The load and creepage are the same throughout, so that the answers tend to a limit.
TEST(stability_bodies, tend_to_incompressible_and_to_rigid_limits) {
  for (const Model model : {Model::fem, Model::bem}) {
    const auto by_poisson = [&](double poisson) {
      BlockShape shape{.model = model};
      shape.poisson = poisson;
      Scene s = pressed(shape, scenes::RigidBody{});
      extremes::give_press(s, Press{}, shape.young);
      return solve(s);
    };
    // The answer is linear in 1 - 2 nu near the limit: a hundredth of it, a hundredth of the change.
    const Answer far = by_poisson(0.4999), near = by_poisson(0.499999);
    const Answer limit = by_poisson(model == Model::fem ? 0.4999999 : 0.5);
    const std::string name = name_of(model);
    expect_below(name + ", nu 0.499999 against the limit", difference(near, limit),
                 0.02 * difference(far, limit) + 1e-9);
    const auto by_ratio = [&](double ratio) {
      BlockShape shape{.model = model};
      Scene s = pressed(shape, scenes::HalfspaceBody{{.shear = ratio * 4000, .poisson = 0.25}});
      extremes::give_press(s, Press{}, shape.young);
      return solve(s);
    };
    Scene rigid = pressed({.model = model}, scenes::RigidBody{});
    extremes::give_press(rigid, Press{}, 1e4);
    const Answer hard = solve(rigid);
    expect_below(name + ", a half-space 1e6 times as stiff", difference(by_ratio(1e6), hard), 1e-5);
    expect_below(name + ", a half-space 1e12 times as stiff", difference(by_ratio(1e12), hard), 1e-9);
  }
}

TEST(stability_bodies_long, units_change_neither_answers_nor_iterations) {
  // The lengths are in m, mm, um, inch, with moduli to go with them.
  constexpr double lengths[] = {1e-3, 1, 1e3, 1 / 25.4}, moduli[] = {1e6, 1, 1e-3, 145.0377377};
  for (const Model model : {Model::fem, Model::bem}) {
    std::optional<Answer> first;
    for (std::size_t i = 0; i < 4; ++i) {
      BlockShape shape{.model = model};
      shape.half = lengths[i] * shape.half;
      shape.young *= moduli[i];
      Press press;
      press.size *= lengths[i];
      Scene s = extremes::scene_on_block("", name_of(model), shape, scenes::RigidBody{}, press);
      Answer a = solve(s);
      a.s.approach /= lengths[i];
      for (double& f : a.s.force) f /= lengths[i] * lengths[i] * moduli[i];
      if (!first) first = a;
      expect_below(std::string(name_of(model)) + ", units " + std::to_string(i), difference(a, *first), 1e-9);
      EXPECT_EQ(a.iterations, first->iterations) << i;
    }
  }
}

/// Rolls steadily on a layer of unit half width on a rigid base, thin beside its 16 x 16 elements, under a cylinder.
/// Returns tangential over normal force.
double driven(Model model, int n, int deep, laws::Scheme scheme) {
  constexpr double thickness = 0.02;
  BlockShape shape{.model = model};
  shape.half = {1, 1, thickness};
  shape.n = {n, n, deep};
  Scene s = pressed(shape, scenes::RigidBody{});
  s.given.quadratic = {0.05 * thickness, 0.05 * thickness, 0};
  s.approach(0.02 * thickness).friction(0.3).creep(0.01 * thickness, 0, 0).scheme(scheme);
  const Answer a = solve(s);
  return a.s.force[0] / a.s.force[2];
}

// A half-space between the nodes would be far softer than a thin layer, and give twice this force.
TEST(stability_bodies_long, thin_layers_of_boundary_elements_roll_like_finite_ones) {
  const double fine = driven(Model::fem, 24, 4, laws::Scheme::least_squares);
  for (const laws::Scheme scheme : {laws::Scheme::least_squares, laws::Scheme::characteristic})
    expect_below(std::string("layer of 1/50, ") + extremes::name_of(scheme),
                 std::abs(driven(Model::bem, 16, 1, scheme) / fine - 1), 0.05);
}

/// Returns the prepared body of a cantilever of 1 x 0.5 x thickness, pressed on its whole upper side.
statics::StaticBody cantilever(double thickness, int along, ElementType type) {
  surfaces::Block shape = surfaces::brick({along, along / 2, 1}, {1, 0.5, thickness});
  statics::StaticBody body(surfaces::block(shape, type), 1000, 0);
  body.hold_tags({1});
  return body;
}

double tip(statics::StaticBody& body) {
  const auto top = surfaces::elements_with_tag(body.mesh(), 6);
  const auto loaded = statics::load_faces(body.body(), top, [](const Vec3&) { return Vec3{0, 0, -1}; });
  double lowest = 0;
  for (const Vec3& u : loaded.u) lowest = std::min(lowest, u[2]);
  return -lowest;
}

// Returns q L^4 / 8 E I, and shear.
double theory(double thickness) {
  return 1 / (8 * 1000 * std::pow(thickness, 3) / 12) + 1.2 / (2 * 500 * thickness);
}

// Nothing in the equations of boundary elements keeps the balance of loads and reactions. Where the mesh cannot bend as
// the body does, displacements are too small by any factor, and the balance shows it.
TEST(stability_bodies, thin_boundary_elements_bend_rightly_or_are_refused) {
  struct Good {
    ElementType type;
    double bound, imbalance;
  };
  for (const auto& [type, bound, imbalance] :
       {Good{ElementType::quad8, 0.01, 0.01}, Good{ElementType::tri6, 0.01, 0.01}, Good{ElementType::quad4, 0.05, 0.1},
        Good{ElementType::tri3, 0.06, 0.2}}) {
    statics::StaticBody good = cantilever(0.1, 12, type);
    good.solve();
    expect_below(surfaces::name_of(type) + " as long as the body is thick, tip", std::abs(tip(good) / theory(0.1) - 1),
                 bound);
    expect_below("  imbalance of reactions", good.body().response()->statistics().imbalance, imbalance);
  }
  struct Case {
    double thickness;
    ElementType type;
  };
  for (const auto& [thickness, type] :
       {Case{0.05, ElementType::quad4}, Case{0.01, ElementType::quad8}, Case{0.01, ElementType::tri3},
        Case{0.001, ElementType::quad8}, Case{0.001, ElementType::tri6}}) {
    statics::StaticBody bad = cantilever(thickness, 6, type);
    bad.solve();
    try {
      const double u = tip(bad);
      ADD_FAILURE() << "thickness " << thickness << ", " << surfaces::name_of(type) << ": tip " << u / theory(thickness)
                    << " of theory's";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::err_mesh);
      EXPECT_NE(std::string(error.what()).find("reactions"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace rollcon
