// Frames of their own laid on boundary-element bodies: graded triangles that match no element of
// the body, against the same frame on a half-space, where its integrals are exact.

#include "support/example3.hpp"
#include "support/graded_disc.hpp"
#include "support/hertz_fit.hpp"
#include "support/surface_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon::validation {
namespace {

namespace example3 = scenes::example3;

TEST(LaidFrame, on_a_block_is_like_on_a_half_space) {
  const closed_forms::Hertz hertz = example3::hertz();
  const SurfaceMesh frame = scenes::graded_disc(hertz.a, hertz.a, 10);
  scenes::MeshedBody body;
  body.mesh = surfaces::zone_block({40, 20, 2.5, 8, 4, 4}, ElementType::quad8);
  body.material = example3::sphere;
  body.held_tag = {3};
  scenes::RollingPair laid(body, scenes::RigidBody{}, 1);
  scenes::RollingPair flat(example3::sphere, std::nullopt, 1);
  const double curvature = 1 / (2 * example3::radius);
  for (scenes::RollingPair* p : {&laid, &flat}) {
    p->frame(frame).gap_quadratic(curvature, curvature).speed(example3::speed);
    p->friction(example3::mu).load(example3::load);
  }
  const double bound = example3::mu * example3::load;
  for (const char* scheme : {"characteristic", "least_squares", "godunov"})
    for (const auto& creep :
         {std::array{-2e-3, 0.0, 0.0}, {0.0, -2e-3, 0.0}, {-1e-3, 5e-4, 1e-3}}) {
      laid.option("convection", scheme).creep(creep[0], creep[1], creep[2]);
      flat.option("convection", scheme).creep(creep[0], creep[1], creep[2]);
      ASSERT_EQ(laid.solve(), ROLLCON_OK);
      ASSERT_EQ(flat.solve(), ROLLCON_OK);
      const scenes::Solution s = laid.solution(), f = flat.solution();
      const std::string name = std::string(scheme) + ", creepages " + std::to_string(creep[0]) +
                               ", " + std::to_string(creep[1]) + ", spin " +
                               std::to_string(creep[2]);
      for (std::size_t c = 0; c < 2; ++c)
        expect_error(name + ": F" + std::to_string(c + 1) + " over mu Fn",
                     (s.force[c] - f.force[c]) / bound, 0.02);
      const scenes::FittedEllipse fit = scenes::fit_hertz(s, hertz.a, hertz.a),
                                  reference = scenes::fit_hertz(f, hertz.a, hertz.a);
      expect_error(name + ": p0", relative(fit.p0, reference.p0), 0.01);
      expect_error(name + ": semi-axis along", relative(fit.a, reference.a), 0.01);
      expect_error(name + ": semi-axis across", relative(fit.b, reference.b), 0.01);
      for (const char* law : {"law_normal", "law_friction", "law_slip"})
        expect_error(name + ": " + law, laid.stat(law), 1e-7);
    }
  EXPECT_NE(laid.plan().find("laid on it"), std::string::npos) << laid.plan();
}

}  // namespace
}  // namespace rollcon::validation
