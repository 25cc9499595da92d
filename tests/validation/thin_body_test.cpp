// A plate of finite elements, thinner than its faces are wide, under a finer frame.

#include <gtest/gtest.h>

#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/volume_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

/// Force of a frictionless rigid paraboloid pressed into a plate [-2, 2]^2 x [-0.1, 0], held at its bottom, of n x n
/// hex20 on top.
double force(int n) {
  surfaces::Block shape;
  shape.line = {frames::uniform_lines(-2, 2, n), frames::uniform_lines(-2, 2, n), frames::uniform_lines(-0.1, 0, 3)};
  scenes::MeshedBody body =
      scenes::meshed(volumes::block(shape, VolumeType::hex20), {.shear = 1 / 2.6, .poisson = 0.3});
  body.held_tag = {5};
  body.contact_tag = {6};
  scenes::RollingPair pair(body, scenes::RigidBody{}, 1);
  const auto x = frames::uniform_lines(-1.05, 0.95, 16), y = frames::uniform_lines(-1.02, 0.98, 16);
  pair.frame(frames::rectangle(ElementType::quad4, x, y)).gap_quadratic(0.05, 0.05);
  pair.friction(0).approach(0.02).speed(1);
  pair.solve();
  return pair.solution().force[2];
}

TEST(ThinBody, coarse_faces_under_a_finer_frame) {
  const double fine = force(32);
  validation::expect_error("faces five times as wide as the plate is thick", std::abs(force(8) / fine - 1), 0.04);
}

}  // namespace
}  // namespace rollcon
