// Tests the fourth example of Rodriguez-Tembleque and Abascal: a boundary-element wheel on a rigid rail head given by a
// surface mesh. The profiles are rollcon's (docs/examples.md).

#include <algorithm>

#include "support/example4.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace example4 = scenes::example4;

TEST(WheelOnRail, carries_the_load_of_the_paper) {
  auto pair = example4::pair(ElementType::quad4, "characteristic");
  pair->friction(0);
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  const double load = -pair->solution().force[2];
  expect_error("wheel on rail: force at 0.015 mm, the paper's 457 N", relative(load, 457), 0.02);
  // The gap is quadratic to a good part of a per mille; Hertz's contact is for a half-space, which the rim, held 60 mm
  // below the tread, is not quite.
  const Hertz hertz =
      closed_forms::hertz_from_approach(1 / (2 * example4::radius), 1 / (2 * example4::rail),
                                        closed_forms::effective_modulus(example4::material), example4::depth);
  expect_error("wheel on rail: force, half-space of the same radii", relative(load, hertz.load), 0.06);
  const Hertz same_load =
      closed_forms::hertz_from_load(hertz.A, hertz.B, closed_forms::effective_modulus(example4::material), load);
  expect_error("wheel on rail: p0, half-space at the same force", relative(pair->stat("max_pressure"), same_load.p0),
               0.03);

  pair->friction(example4::mu).tangential_force(ROLLCON_LONGITUDINAL, example4::force_ratio * example4::mu * load);
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  const Solution s = pair->solution();
  expect_error("wheel on rail: force when friction acts as well", relative(-s.force[2], load), 0.01);
  EXPECT_GT(pair->stat("nodes_stick"), 0);
  EXPECT_GT(pair->stat("nodes_slip"), 0);
  for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
    expect_error(std::string("wheel on rail: ") + law, pair->stat(law), 1e-8);
}

}  // namespace
}  // namespace rollcon::validation
