/// Tests that the judge of the extreme scenes sees what is wrong: a right solution is held against a scene that is
/// slightly another one.

#include "support/extremes_base.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using laws::Given;
using laws::Laws;
using laws::Scheme;

TEST(independent_laws, see_a_scene_that_is_another_one) {
  struct Defect {
    const char* name;
    double Laws::*law;
    std::function<void(Given&)> make;
  };
  const Defect defects[] = {
      {"friction a thousandth less", &Laws::bound, [](Given& g) { g.friction[0] *= 0.999; }},
      {"deeper gap", &Laws::separation, [](Given& g) { (*g.quadratic)[0] *= 1.001; }},
      {"flatter gap", &Laws::penetration, [](Given& g) { (*g.quadratic)[0] *= 0.999; }},
      {"another scheme", &Laws::stick, [](Given& g) { g.scheme = Scheme::godunov; }},
      {"another step", &Laws::stick, [](Given& g) { g.step *= 1.01; }},
      {"rolling turned, sticking nodes", &Laws::stick, [](Given& g) { g.rolling[1] = 1e-3; }},
      {"more force", &Laws::equilibrium, [](Given& g) { g.value[0] *= 1.001; }},
      {"more spin", &Laws::motion, [](Given& g) { g.value[3] *= 1.001; }},
      {"a creep field, slipping nodes", &Laws::direction,
       [](Given& g) { g.creep_field.assign(2 * g.frame.node.size(), 1e-5); }},
      {"nodes moved", &Laws::stick,
       [](Given& g) {
         g.regular = false;
         for (Vec3& x : g.frame.node) x[0] *= 1.001;
       }},
  };
  constexpr double kept = 1e-8, seen = 1e-5;
  for (const extremes::Pairing pairing :
       {extremes::Pairing::on_rigid, extremes::Pairing::twins, extremes::Pairing::unlike}) {
    extremes::Scene scene = extremes::base("", "", pairing);
    const double load = extremes::base_load(scene);
    scene.load(load).force(ROLLCON_LONGITUDINAL, 0.15 * load);
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    ASSERT_EQ(pair->solve(), ROLLCON_OK);
    EXPECT_LE(laws::check(pair->handle(), scene.given).worst(), kept);
    for (const Defect& defect : defects) {
      Given other = scene.given;
      defect.make(other);
      const double error = laws::check(pair->handle(), other).*defect.law;
      std::printf("%s, %s: %.1e (at least %.0e)\n", extremes::name_of(pairing), defect.name, error, seen);
      EXPECT_GE(error, seen) << extremes::name_of(pairing) << ", " << defect.name;
    }
  }
}

TEST(independent_laws, schemes_are_exact_for_linear_fields) {
  const SurfaceMesh mesh = frames::perturb(
      frames::rectangle(ElementType::tri3, frames::uniform_lines(-1, 1, 8), frames::uniform_lines(-1, 1, 8)), 0.2, 5);
  laws::Plane at;
  for (const Vec3& x : mesh.node) at.x.push_back(x[0]), at.y.push_back(x[1]);
  const laws::Rows rows = laws::least_squares_rows(mesh, at);
  double worst = 0;
  int counted = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    // The derivative v . grad (2 x + 3 y) is -2 inside the frame.
    if (std::abs(at.x[k]) > 0.7 || std::abs(at.y[k]) > 0.7) continue;
    double sum = 0;
    for (const laws::Difference& d : rows[k]) {
      const auto j = static_cast<std::size_t>(d.node);
      sum += d.c * (2 * (at.x[j] - at.x[k]) + 3 * (at.y[j] - at.y[k]));
    }
    worst = std::max(worst, std::abs(sum + 2));
    ++counted;
  }
  std::printf("least squares of a linear field at %d nodes: error %.1e (bound 1e-12)\n", counted, worst);
  EXPECT_GT(counted, 20);
  EXPECT_LE(worst, 1e-12);
  double area = 0;
  for (const auto& integral : laws::shape_integrals(mesh, at)) area += integral[0];
  EXPECT_NEAR(area, 4, 1e-12);
}

}  // namespace
}  // namespace rollcon
