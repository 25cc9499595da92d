/// Tests the Hertzian contact that stands for a contact, and creep forces of tables from it.

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;

constexpr Elastic steel{.shear = 82000, .poisson = 0.28};

struct Case {
  std::array<double, 9> input{};
  std::array<double, 2> center{};
};

Case of(const RollingPair& pair) {
  Case c;
  EXPECT_EQ(rollcon_contact_get_equivalent_ellipse(pair.handle(), c.input.data(), c.center.data()), ROLLCON_OK)
      << rollcon_last_error();
  return c;
}

std::int32_t refusal(const RollingPair& pair) {
  double input[9], center[2];
  return rollcon_contact_get_equivalent_ellipse(pair.handle(), input, center);
}

TEST(equivalent_ellipse, of_a_hertzian_contact_is_its_own) {
  const auto hertz = closed_forms::hertz_from_axes(8, 4, 1000, closed_forms::effective_modulus(steel, steel));
  RollingPair pair(steel, steel);
  pair.rectangle(ElementType::quad4, 48, 48, 8.8, 4.4).gap_quadratic(hertz.A, hertz.B).load(hertz.load);
  pair.friction(0.3).creep(4e-4, -2e-4, 3e-5).solve();
  const Case c = of(pair);
  const std::array<double, 9> expected{82000, 0.28, 0.3, 8, 4, hertz.load, 4e-4, -2e-4, 3e-5};
  const char* name[9] = {"shear", "poisson", "friction", "a", "b", "load", "longitudinal", "lateral", "spin"};
  for (std::size_t i = 0; i < 9; ++i)
    expect_error(name[i], c.input[i] / expected[i] - 1, i == 3 || i == 4 ? 5e-3 : 1e-9);
  expect_error("center", std::hypot(c.center[0], c.center[1]), 1e-9);
}

// The contact is seen from axes at another place: the creepages are those at its centre.
TEST(equivalent_ellipse, follows_its_contact) {
  const auto hertz = closed_forms::hertz_from_axes(6, 6, 1000, closed_forms::effective_modulus(steel, steel));
  constexpr double x = 1.5, y = -2, spin = 1e-4;
  RollingPair pair(steel, steel);
  pair.rectangle(ElementType::quad4, 40, 40, 10, 10).friction(0.25).creep(1e-3, 5e-4, spin).load(hertz.load);
  pair.gap_quadratic(hertz.A, hertz.B).solve();
  const auto nodes = pair.solution();
  std::vector<double> gap;
  for (std::size_t k = 0; k < nodes.nodes(); ++k)
    gap.push_back(hertz.A * (nodes.x[k] - x) * (nodes.x[k] - x) + hertz.B * (nodes.y[k] - y) * (nodes.y[k] - y));
  pair.gap(gap).solve();
  const Case c = of(pair);
  expect_error("center", std::hypot(c.center[0] - x, c.center[1] - y), 1e-9);
  expect_error("longitudinal", c.input[6] - (1e-3 - spin * c.center[1]), 1e-12);
  expect_error("lateral", c.input[7] - (5e-4 + spin * c.center[0]), 1e-12);
  expect_error("spin", c.input[8] - spin, 1e-12);
}

TEST(equivalent_ellipse, takes_mean_flexibilities) {
  const Elastic soft{.shear = 20000, .poisson = 0.4};
  for (const std::optional<Elastic>& other : {std::optional<Elastic>{}, std::optional<Elastic>{soft}}) {
    const double modulus =
        other ? closed_forms::effective_modulus(steel, *other) : 2 * closed_forms::effective_modulus(steel, steel);
    const auto hertz = closed_forms::hertz_from_axes(6, 3, 1000, modulus);
    RollingPair pair(steel, other);
    pair.rectangle(ElementType::quad4, 24, 24, 6.6, 3.3).gap_quadratic(hertz.A, hertz.B).load(hertz.load);
    pair.friction(0).solve();
    const double flexible = (1 / steel.shear + (other ? 1 / soft.shear : 0)) / 2;
    const double sideways = (steel.poisson / steel.shear + (other ? soft.poisson / soft.shear : 0)) / 2;
    const Case c = of(pair);
    expect_error("shear", c.input[0] * flexible - 1, 1e-12);
    expect_error("poisson", c.input[1] - sideways / flexible, 1e-12);
    // The pressure strains both: the mean of d(u1 - u2)/dx over the pressure comes from differences of the
    // displacements.
    const auto s = pair.solution();
    const double step = 1e-3 * c.input[3];
    std::vector<double> ahead, behind;
    for (std::size_t k = 0; k < s.nodes(); ++k) {
      ahead.insert(ahead.end(), {s.x[k] + step, s.y[k]});
      behind.insert(behind.end(), {s.x[k] - step, s.y[k]});
    }
    double strain = 0;
    for (const int body : {1, 2}) {
      const auto u = pair.displacements_at(body, ahead), v = pair.displacements_at(body, behind);
      for (std::size_t k = 0; k < s.nodes(); ++k)
        strain += (body == 1 ? 1 : -1) * s.pressure[k] * s.weight[k] * (u[3 * k] - v[3 * k]) / (2 * step * c.input[5]);
    }
    expect_error("strain on top of no creepage", c.input[6] / -strain - 1, 0.03);
  }
}

TEST(equivalent_ellipse, falling_friction_is_that_at_the_rigid_slip) {
  RollingPair pair(steel, steel);
  pair.rectangle(ElementType::quad4, 16, 16, 6, 6).gap_quadratic(2e-3, 2e-3).load(20000).creep(2e-3, 0, 0).speed(20);
  const double law[] = {0.2, 0.4, 0.04};  // 0.2 + 0.4 / 2 at a slip speed of 0.04, which is 20 times the creepage
  ASSERT_EQ(rollcon_contact_set_friction(pair.handle(), "exponential", 3, law), ROLLCON_OK) << rollcon_last_error();
  pair.solve();
  expect_error("friction", of(pair).input[2] - 0.4, 1e-12);
}

TEST(equivalent_ellipse, what_is_no_ellipse_is_refused) {
  RollingPair pair(steel, steel);
  pair.rectangle(ElementType::quad4, 40, 12, 20, 3).friction(0.3).load(1000);
  pair.gap_quadratic(1e-3, 1e-3).solve();
  EXPECT_EQ(refusal(pair), ROLLCON_OK);
  const auto s = pair.solution();
  std::vector<double> gap;
  for (std::size_t k = 0; k < s.nodes(); ++k)
    gap.push_back(1e-2 * (std::pow(std::abs(s.x[k]) - 15, 2) + s.y[k] * s.y[k]));
  pair.gap(gap).solve();
  EXPECT_EQ(refusal(pair), ROLLCON_ERR_STATE);
  EXPECT_NE(std::string(rollcon_last_error()).find("no single patch"), std::string::npos) << rollcon_last_error();
  ASSERT_EQ(rollcon_contact_set_layer(pair.handle(), 1e-6, 0, 0), ROLLCON_OK);
  pair.gap_quadratic(1e-3, 1e-3).solve();
  EXPECT_EQ(refusal(pair), ROLLCON_ERR_UNSUPPORTED);
  ASSERT_EQ(rollcon_contact_set_layer(pair.handle(), 0, 0, 0), ROLLCON_OK);
  const double law[] = {0.3, 0.2, 0};
  ASSERT_EQ(rollcon_contact_set_friction(pair.handle(), "orthotropic", 3, law), ROLLCON_OK) << rollcon_last_error();
  pair.gap_quadratic(1e-3, 1e-3).solve();
  EXPECT_EQ(refusal(pair), ROLLCON_ERR_UNSUPPORTED);
}

}  // namespace
}  // namespace rollcon
