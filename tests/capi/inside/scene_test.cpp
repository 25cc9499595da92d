/// Tests what a scene counts as a change, and what its axes are.

#include "contact/scene/scene.hpp"

#include <random>

#include "support/error.hpp"
#include "support/testing.hpp"

using namespace rollcon;

namespace {

bool same(const Revisions& a, const Revisions& b) {
  return a.mesh == b.mesh && a.axes == b.axes && a.gap == b.gap && a.kinematics == b.kinematics && a.load == b.load &&
         a.friction == b.friction;
}

void set_triangle(Scene& scene) {
  const double x[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::int32_t nodes[3] = {0, 1, 2};
  scene.set_frame_nodes(3, x, 3, 1);
  scene.add_frame_elements(203, 1, nodes, 0, 0);
}

/// Sets all values of a time loop, times f.
void set_all(Scene& scene, double f) {
  const double v[6] = {f, f, f, f, f, f};
  const double origin[3] = {f, 0, 0}, rolling[3] = {f, 1, 0}, normal[3] = {0, 0.1, f};
  scene.set_axes(origin, rolling, normal);
  scene.set_gap(3, v);
  scene.set_speed(f);
  scene.set_creep(f, f, f);
  scene.set_creep_field(3, v);
  scene.prescribe(3, 2, f);
  scene.set_friction("coulomb", 1, v);
  scene.set_friction_field(3, v);
  scene.options.set_real("tolerance", 1e-8 * f);
  scene.options.set_int("warm_start", 0);
  scene.options.set_text("convection", "godunov");
}

}  // namespace

TEST(scene, equal_values_set_again_are_no_change) {
  Scene scene;
  set_triangle(scene);
  set_all(scene, 1);
  const Revisions before = scene.revision;
  const std::int64_t options_before = scene.options.revision;
  set_all(scene, 1);
  EXPECT_TRUE(same(scene.revision, before));
  EXPECT_EQ(scene.options.revision, options_before);
  set_all(scene, 2);
  EXPECT_GT(scene.revision.axes, before.axes);
  EXPECT_GT(scene.revision.gap, before.gap);
  EXPECT_GT(scene.revision.kinematics, before.kinematics);
  EXPECT_GT(scene.revision.load, before.load);
  EXPECT_GT(scene.revision.friction, before.friction);
  EXPECT_EQ(scene.revision.mesh, before.mesh);
  EXPECT_EQ(scene.options.revision, options_before + 1);
}

TEST(scene, refused_values_are_no_change) {
  Scene scene;
  set_triangle(scene);
  set_all(scene, 1);
  const Revisions before = scene.revision;
  const double bad[6] = {1, 1, 1, 1, 1, NAN};
  const std::int32_t nodes[3] = {0, 1, 3};
  EXPECT_THROW(scene.set_frame_nodes(2, bad, 3, 1), Error);
  EXPECT_THROW(scene.add_frame_elements(203, 1, nodes, 0, 0), Error);
  EXPECT_THROW(scene.set_axes(bad, bad, bad), Error);
  EXPECT_THROW(scene.set_gap(3, bad + 3), Error);
  EXPECT_THROW(scene.set_creep_field(3, bad), Error);
  EXPECT_THROW(scene.set_friction_field(3, bad + 3), Error);
  EXPECT_THROW(scene.set_creep(5, 5, NAN), Error);
  EXPECT_TRUE(same(scene.revision, before));
  EXPECT_EQ(scene.load(Direction::longitudinal).value, 1);
  EXPECT_EQ(scene.mesh().nodes(), 3);
  EXPECT_EQ(scene.mesh().elements(), 1);
  EXPECT_EQ(scene.gap(2, 0, 0), 1);
}

TEST(scene, new_nodes_forget_what_belonged_to_the_old_ones) {
  Scene scene;
  set_triangle(scene);
  set_all(scene, 1);
  set_triangle(scene);
  EXPECT_FALSE(scene.has_gap());
  EXPECT_TRUE(scene.creep_field().empty());
  EXPECT_EQ(scene.mesh().elements(), 1);
  EXPECT_THROW(scene.require_complete(), Error);
  scene.set_gap_quadratic(1, 2, 3);
  EXPECT_NO_THROW(scene.require_complete());
  set_triangle(scene);
  EXPECT_NO_THROW(scene.require_complete()) << "a quadratic gap fits every frame";
  EXPECT_EQ(scene.gap(0, 2, 3), 1 * 4 + 2 * 9 + 3 * 6);
}

TEST(scene, gap_of_another_kind_replaces_the_earlier) {
  Scene scene;
  set_triangle(scene);
  const double array[3] = {7, 8, 9};
  scene.set_gap_quadratic(1, 1, 0);
  scene.set_gap(3, array);
  EXPECT_EQ(scene.gap(1, 5, 5), 8);
  scene.set_gap_quadratic(1, 1, 0);
  EXPECT_EQ(scene.gap(1, 5, 5), 50);
  const std::int64_t before = scene.revision.gap;
  scene.set_gap(3, array);
  EXPECT_EQ(scene.gap(1, 5, 5), 8);
  EXPECT_GT(scene.revision.gap, before);
}

TEST(scene, axes_are_right_handed_and_orthonormal_for_any_two_directions) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal_number;
  std::uniform_real_distribution<double> exponent(-300, 300);
  const double origin[3] = {0, 0, 0};
  double worst = 0;
  for (int k = 0; k < 2000; ++k) {
    double rolling[3], normal[3];
    const double size1 = std::pow(10, exponent(random)), size2 = std::pow(10, exponent(random));
    // Every other pair is nearly parallel.
    const double apart = k % 2 ? 1e-6 : 1;
    for (int i = 0; i < 3; ++i) normal[i] = normal_number(random);
    for (int i = 0; i < 3; ++i) rolling[i] = normal[i] + apart * normal_number(random);
    for (int i = 0; i < 3; ++i) {
      normal[i] *= size1;
      rolling[i] *= size2;
    }
    Scene scene;
    scene.set_axes(origin, rolling, normal);
    const Vec3 t[3] = {scene.axes().t1, scene.axes().t2, scene.axes().n};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        double product = 0;
        for (std::size_t i = 0; i < 3; ++i) product += t[a][i] * t[b][i];
        worst = std::max(worst, std::abs(product - (a == b)));
      }
      const Vec3 &u = t[a], &v = t[(a + 1) % 3], &w = t[(a + 2) % 3];
      worst = std::max(worst, std::abs(u[1] * v[2] - u[2] * v[1] - w[0]));
    }
    double forward = 0;
    for (std::size_t i = 0; i < 3; ++i) forward += t[0][i] * (rolling[i] / size2);
    EXPECT_GT(forward, 0) << "t1 points where rolling points";
  }
  std::printf("axes off orthonormal by %.1e (bound 1e-15)\n", worst);
  EXPECT_LT(worst, 1e-15);
}
