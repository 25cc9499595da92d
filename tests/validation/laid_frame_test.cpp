// Frames of their own laid on bodies of boundary and of finite elements: graded triangles that match no element of the
// body, against the same frame on a half-space, where its integrals are exact.

#include "support/example3.hpp"
#include "support/graded_disc.hpp"
#include "support/hertz_fit.hpp"
#include "support/surface_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon::validation {
namespace {

namespace example3 = scenes::example3;

struct Case {
  const char* name;
  scenes::MeshedBody (*body)();
  double bound;  ///< of forces over mu Fn; half of it of pressure and semi-axes
};

class LaidFrame : public ::testing::TestWithParam<Case> {};

TEST_P(LaidFrame, on_a_block_is_like_on_a_half_space) {
  const closed_forms::Hertz hertz = example3::hertz();
  const SurfaceMesh frame = scenes::graded_disc(hertz.a, hertz.a, 10);
  scenes::MeshedBody body = GetParam().body();
  body.held_tag = {3};
  body.contact_tag = {2};
  scenes::RollingPair laid(body, scenes::RigidBody{}, 1);
  scenes::RollingPair flat(example3::sphere, std::nullopt, 1);
  const double curvature = 1 / (2 * example3::radius);
  for (scenes::RollingPair* p : {&laid, &flat}) {
    p->frame(frame).gap_quadratic(curvature, curvature).speed(example3::speed);
    p->friction(example3::mu).load(example3::load);
  }
  const double bound = example3::mu * example3::load;
  for (const char* scheme : {"characteristic", "least_squares", "godunov"})
    for (const auto& creep : {std::array{-2e-3, 0.0, 0.0}, {0.0, -2e-3, 0.0}, {-1e-3, 5e-4, 1e-3}}) {
      laid.option("convection", scheme).creep(creep[0], creep[1], creep[2]);
      flat.option("convection", scheme).creep(creep[0], creep[1], creep[2]);
      ASSERT_EQ(laid.solve(), ROLLCON_OK);
      ASSERT_EQ(flat.solve(), ROLLCON_OK);
      const scenes::Solution s = laid.solution(), f = flat.solution();
      const std::string name = std::string(scheme) + ", creepages " + std::to_string(creep[0]) + ", " +
                               std::to_string(creep[1]) + ", spin " + std::to_string(creep[2]);
      for (std::size_t c = 0; c < 2; ++c)
        expect_error(name + ": F" + std::to_string(c + 1) + " over mu Fn", (s.force[c] - f.force[c]) / bound,
                     GetParam().bound);
      const scenes::FittedEllipse fit = scenes::fit_hertz(s, hertz.a, hertz.a),
                                  reference = scenes::fit_hertz(f, hertz.a, hertz.a);
      expect_error(name + ": p0", relative(fit.p0, reference.p0), GetParam().bound / 2);
      expect_error(name + ": semi-axis along", relative(fit.a, reference.a), GetParam().bound / 2);
      expect_error(name + ": semi-axis across", relative(fit.b, reference.b), GetParam().bound / 2);
      for (const char* law : {"law_normal", "law_friction", "law_slip"})
        expect_error(name + ": " + law, laid.stat(law), 1e-7);
    }
  EXPECT_NE(laid.plan().find("laid on it"), std::string::npos) << laid.plan();
}

constexpr auto laid_case_name = [](const auto& param) { return std::string(param.param.name); };

INSTANTIATE_TEST_SUITE_P(
    Bodies, LaidFrame,
    ::testing::Values(Case{
        "hex20",
        [] {
          return scenes::meshed(volumes::zone_block({40, 20, 2.5, 8, 4, 6}, VolumeType::hex20), example3::sphere);
        },
        0.02}),
    laid_case_name);
INSTANTIATE_TEST_SUITE_P(
    Bodies_long, LaidFrame,
    ::testing::Values(Case{
        "quad8",
        [] {
          return scenes::meshed(surfaces::zone_block({40, 20, 2.5, 8, 4, 4}, ElementType::quad8), example3::sphere);
        },
        0.02}),
    laid_case_name);

}  // namespace
}  // namespace rollcon::validation
