// Tests that one contact through changes of its scene, solved by published procedures, gives the results of a fresh
// one.

#include "support/example3.hpp"
#include "support/testing.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

namespace example3 = scenes::example3;

SurfaceMesh disc(int rings) {
  const double a = example3::hertz().a;
  return graded_disc(a, a, rings);
}

double difference(const RollingPair& a, const RollingPair& b) {
  return scenes::traction_difference(a.solution(), b.solution());
}

std::array<double, 3> rate_of_creep(const RollingPair& pair) {
  std::array<double, 3> rate{};
  EXPECT_EQ(
      rollcon_contact_get_sensitivity(pair.handle(), ROLLCON_LONGITUDINAL, nullptr, nullptr, nullptr, rate.data()),
      ROLLCON_OK);
  return rate;
}

class ProcedureChanges : public ::testing::TestWithParam<const char*> {
 protected:
  std::unique_ptr<RollingPair> pair(int rings, const char* scheme = "least_squares") const {
    auto p = example3::pair(disc(rings), scheme, 1);
    p->option("procedure", (std::string("jacobian=b_derivative system=") + GetParam()).c_str());
    return p;
  }
};

TEST_P(ProcedureChanges, a_finer_frame) {
  const auto changed = pair(4), fresh = pair(7);
  ASSERT_EQ(changed->solve(), ROLLCON_OK);
  changed->frame(disc(7));
  ASSERT_EQ(changed->solve(), ROLLCON_OK);
  ASSERT_EQ(fresh->solve(), ROLLCON_OK);
  expect_error("tractions on another frame", difference(*changed, *fresh), 1e-9);
}

TEST_P(ProcedureChanges, more_elements_on_the_same_nodes) {
  SurfaceMesh all = disc(6), half = all;
  const std::size_t kept = static_cast<std::size_t>(all.elements()) / 2;
  half.type.resize(kept);
  half.offset.resize(kept + 1);
  half.connectivity.resize(static_cast<std::size_t>(half.offset.back()));
  if (!half.tag.empty()) half.tag.resize(kept);
  const auto changed = pair(6), fresh = pair(6);
  changed->frame(half);
  ASSERT_GE(changed->solve(), ROLLCON_OK);
  changed->frame(all);
  ASSERT_EQ(changed->solve(), ROLLCON_OK);
  ASSERT_EQ(fresh->solve(), ROLLCON_OK);
  expect_error("tractions with all elements", difference(*changed, *fresh), 1e-9);
}

TEST_P(ProcedureChanges, sensitivities_after_another_scheme) {
  const auto changed = pair(6), fresh = pair(6, "godunov");
  ASSERT_EQ(changed->solve(), ROLLCON_OK);
  rate_of_creep(*changed);
  changed->option("convection", "godunov").rolling_at(0.3);
  fresh->rolling_at(0.3);
  ASSERT_EQ(changed->solve(), ROLLCON_OK);
  ASSERT_EQ(fresh->solve(), ROLLCON_OK);
  const auto a = rate_of_creep(*changed), b = rate_of_creep(*fresh);
  expect_error("rate of the creepage with its force", std::abs(a[0] / b[0] - 1), 1e-7);
}

TEST_P(ProcedureChanges, no_friction_any_more) {
  const auto changed = pair(6);
  ASSERT_EQ(changed->solve(), ROLLCON_OK);
  ASSERT_NE(changed->solution().creep[0], 0);
  changed->friction(0).tangential_force(ROLLCON_LONGITUDINAL, 0);
  ASSERT_EQ(changed->solve(), ROLLCON_OK);
  EXPECT_EQ(changed->solution().creep[0], 0);
}

INSTANTIATE_TEST_SUITE_P(systems, ProcedureChanges, ::testing::Values("condensed", "monolithic"));

}  // namespace
}  // namespace rollcon::validation
