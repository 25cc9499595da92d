/// Tests orthotropic friction: Coulomb's law where both coefficients are equal, the same in all axes, the ellipse at
/// every node, and exact derivatives.

#include <algorithm>
#include <cmath>

#include "contact/scene_fixture.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double quarter = 0.78539816339744831;

void set_law(Pair& pair, const char* law, double mu1, double mu2, double angle) {
  const double parameters[] = {mu1, mu2, angle};
  pair.contact->scene.set_friction(law, 3, parameters);
}

constexpr const char* both[] = {"orthotropic", "orthotropic_collinear"};

TEST(orthotropic, equal_coefficients_are_coulombs_law) {
  for (const char* law : both)
    for (const double second : {0.1, 0.3}) {  // unlike bodies, and like ones
      Pair coulomb(1e4, 0.3, second > 0.2 ? 1e4 : 2e4, second), orthotropic(1e4, 0.3, second > 0.2 ? 1e4 : 2e4, second);
      for (Pair* p : {&coulomb, &orthotropic}) sharp_scene(*p);
      set_law(orthotropic, law, 0.3, 0.3, 0.6);
      coulomb.contact->solve();
      orthotropic.contact->solve();
      const double off = largest_difference(orthotropic.tractions(), coulomb.tractions());
      std::printf("%s: tractions off Coulomb's by %.1e (bound 1e-10)\n", law, off);
      EXPECT_LE(off, 1e-10);
      EXPECT_EQ(orthotropic.contact->stat("iterations"), coulomb.contact->stat("iterations"));
    }
}

// The scene is turned in space with its axes, and the law's axes turned against the rolling direction: lateral creepage
// under axes at an angle is that under axes at the mirrored one, mirrored.
TEST(orthotropic, the_same_in_all_axes) {
  for (const char* law : both) {
    std::vector<double> reference;
    for (const double turn : {0.0, 0.4, 2.5}) {
      Pair pair(1e4, 0.3, 2e4, 0.1);
      const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 14);
      SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
      const double c = std::cos(turn), s = std::sin(turn);
      for (Vec3& x : mesh.node) x = {c * x[0] - s * x[1], s * x[0] + c * x[1], 0};
      pair.frame(mesh);
      Scene& scene = pair.contact->scene;
      const double origin[] = {0, 0, 0}, rolling[] = {c, s, 0}, normal[] = {0, 0, 1};
      scene.set_axes(origin, rolling, normal);
      scene.set_gap_quadratic(0.01, 0.013, 0.002);
      scene.prescribe(3, 1, 0.02);
      scene.set_creep(-2e-3, 5e-4, 1e-3);
      scene.options.set_real("tolerance", 1e-13);
      set_law(pair, law, 0.4, 0.15, 0.7);
      pair.contact->solve();
      if (reference.empty()) reference = pair.tractions();
      const double off = largest_difference(pair.tractions(), reference);
      std::printf("%s, turned by %.1f: tractions off by %.1e (bound 1e-9)\n", law, turn, off);
      EXPECT_LE(off, 1e-9);
    }
    // The scene is mirrored at the rolling direction.
    Vec3 force[2];
    for (const double sign : {1.0, -1.0}) {
      Pair pair(1e4, 0.3, 2e4, 0.1);
      sharp_scene(pair);
      pair.contact->scene.set_creep(-2e-3, sign * 5e-4, sign * 1e-3);
      set_law(pair, law, 0.4, 0.15, sign * 0.7);
      pair.contact->solve();
      Vec3 moment;
      pair.contact->resultant(InAxes::local, force[sign < 0].data(), moment.data());
    }
    const double size = std::abs(force[0][0]);
    const double off = std::max(std::abs(force[0][0] - force[1][0]), std::abs(force[0][1] + force[1][1])) / size;
    std::printf("%s, mirrored: forces off by %.1e (bound 1e-9)\n", law, off);
    EXPECT_LE(off, 1e-9);
    EXPECT_GT(std::abs(force[0][1]), 0.05 * size);
  }
}

// Axes turned by 0 and 90 degrees give no lateral force; those at 45 degrees do where slip is normal to the ellipse:
// nearly every node slides along the creepage, and its traction is not along that.
TEST(orthotropic, a_lateral_force_at_45_degrees) {
  for (const char* law : both)
    for (const int eighths : {0, 1, 2}) {
      Pair pair(1, 0.28, 1, 0.28);
      sharp_scene(pair);
      pair.contact->scene.set_creep(-8e-3, 0, 0);
      set_law(pair, law, 0.4, 0.2, eighths * quarter);
      pair.contact->solve();
      Vec3 force, moment;
      pair.contact->resultant(InAxes::local, force.data(), moment.data());
      std::printf("%s at %2d degrees: Fx/Fn %.4f, Fy/Fn %.4f, laws %.1e (bound 1e-9)\n", law, 45 * eighths,
                  -force[0] / force[2], -force[1] / force[2], pair.worst_law());
      EXPECT_LE(pair.worst_law(), 1e-9);
      const double most = std::abs(force[1] / force[2]);
      if (eighths == 1 && law == both[0])
        EXPECT_GT(most, 0.1);
      else
        EXPECT_LE(most, eighths == 1 ? 1e-3 : 1e-9);
    }
}

// Every node slides under a creepage in one direction: the traction is the ellipse's point whose normal is that
// direction, (mu1^2 cos, mu2^2 sin) over its length.
TEST(orthotropic, sliding_in_one_direction_has_the_closed_form) {
  const double mu1 = 0.4, mu2 = 0.2, angle = 0.5;
  for (const double direction : {0.0, 0.8, 2.0, -1.3}) {
    Pair pair(1e4, 0.3, 1e4, 0.3);
    sharp_scene(pair);
    const double far = 1e3;
    pair.contact->scene.set_creep(far * std::cos(direction), far * std::sin(direction), 0);
    set_law(pair, "orthotropic", mu1, mu2, angle);
    pair.contact->solve();
    Vec3 force, moment;
    pair.contact->resultant(InAxes::local, force.data(), moment.data());
    const double a = std::cos(direction - angle), b = std::sin(direction - angle);
    const double length = std::hypot(mu1 * a, mu2 * b), x = -mu1 * mu1 * a / length, y = -mu2 * mu2 * b / length;
    const double f1 = x * std::cos(angle) - y * std::sin(angle), f2 = x * std::sin(angle) + y * std::cos(angle);
    const double off = std::hypot(-force[0] / force[2] - f1, -force[1] / force[2] - f2);
    std::printf("sliding at %.1f: force over load off by %.1e (bound 1e-6)\n", direction, off);
    EXPECT_LE(off, 1e-6);
  }
}

}  // namespace
}  // namespace rollcon
