/// Tests what laws of friction other than Coulomb's have in common with it: frames of the library's choice, error
/// estimates, lists of cases, the plan, and the refusal of the published procedures.

#include "rollcon.h"
#include "support/scene.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using scenes::Elastic;
using scenes::RollingPair;

const Elastic steel{.shear = 82000, .poisson = 0.28};

struct Tried {
  const char* law;
  std::vector<double> parameter;
};
const Tried tried[] = {
    {"orthotropic", {0.3, 0.2, 0.6}},    {"orthotropic_collinear", {0.3, 0.2, 0.6}}, {"exponential", {0.15, 0.15, 3}},
    {"linear", {0.15, 0.1, 3, 0.05, 8}}, {"rational", {0.15, 0.1, 3, 0.05, 8}},
};

void give(RollingPair& pair, const Tried& t) {
  ASSERT_EQ(rollcon_contact_set_friction(pair.handle(), t.law, static_cast<std::int32_t>(t.parameter.size()),
                                         t.parameter.data()),
            ROLLCON_OK)
      << rollcon_last_error();
}

TEST(friction_laws_long, frames_of_the_librarys_choice_are_as_good_as_given_ones) {
  for (const Tried& t : tried)
    for (const bool by_force : {false, true}) {
      std::array<double, 3> answer[2];
      for (const bool chosen : {false, true}) {
        RollingPair pair(steel, steel);
        const auto hertz = closed_forms::hertz_from_axes(5, 5, 1000, closed_forms::effective_modulus(steel, steel));
        if (!chosen) pair.rectangle(ElementType::quad4, 64, 64, 5.5, 5.5);
        pair.gap_quadratic(hertz.A, hertz.B).load(hertz.load).speed(1000).creep(-1.2e-3, 3e-4, 2e-5);
        if (by_force) pair.tangential_force(ROLLCON_LONGITUDINAL, 0.14 * hertz.load);
        give(pair, t);
        const std::int32_t status = pair.solve();
        EXPECT_EQ(status, ROLLCON_OK);
        const scenes::Solution s = pair.solution();
        answer[chosen] = {by_force ? s.creep[0] / 1.2e-3 : s.force[0] / (0.3 * hertz.load),
                          s.force[1] / (0.3 * hertz.load), pair.stat("error_estimate")};
        EXPECT_NE(pair.plan().find("friction: "), std::string::npos);
      }
      const std::string name = std::string(t.law) + (by_force ? ", force given" : ", creepage given");
      for (std::size_t i = 0; i < 2; ++i)
        expect_error(name + (i == 0 ? ": along" : ": across"), answer[1][i] - answer[0][i], 0.02);
      expect_error(name + ": estimate on the chosen frame", answer[1][2], 0.02);
      EXPECT_GT(answer[0][2], 0);
    }
}

// Friction as a column is a factor on the law's coefficients.
TEST(friction_laws, lists_of_cases_are_single_solves) {
  for (const Tried& t : tried) {
    RollingPair pair(steel, Elastic{.shear = 40000, .poisson = 0.4});
    pair.rectangle(ElementType::quad4, 16, 16, 1.3, 1.3).gap_quadratic(0.01, 0.01).approach(0.02).speed(1000);
    give(pair, t);
    const std::vector<double> values = {-2e-3, 5e-4, 1, -2e-3, 5e-4, 0.7, 1e-3, -4e-4, 1.2};
    std::vector<double> results(9);
    std::vector<std::int32_t> status(3);
    std::int64_t width = 0;
    ASSERT_GE(rollcon_contact_solve_many(pair.handle(), "longitudinal lateral friction", 3, values.data(), "force", 3,
                                         results.data(), &width, status.data()),
              0)
        << rollcon_last_error();
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      Tried scaled = t;
      const std::size_t coefficients = t.parameter.size();
      for (std::size_t i = 0; i < coefficients; ++i)
        if (i < 2 || std::string(t.law).rfind("orthotropic", 0) != 0)
          if (i == 0 || i % 2 == 1) scaled.parameter[i] *= values[3 * k + 2];
      give(pair, scaled);
      pair.creep(values[3 * k], values[3 * k + 1], 0);
      pair.reset();
      pair.solve();
      const scenes::Solution s = pair.solution();
      for (std::size_t c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(s.force[c] - results[3 * k + c]) / std::abs(s.force[2]));
    }
    expect_error(std::string(t.law) + ": list against single solves", worst, 1e-9);
  }
}

TEST(friction_laws, published_procedures_refuse) {
  if (!rollcon_has_feature("procedures")) GTEST_SKIP();
  for (const Tried& t : tried) {
    RollingPair pair(steel, steel);
    pair.rectangle(ElementType::quad4, 8, 8, 1.3, 1.3).gap_quadratic(0.01, 0.01).approach(0.02);
    give(pair, t);
    pair.option("procedure", "system=monolithic");
    EXPECT_EQ(rollcon_contact_solve(pair.handle()), ROLLCON_ERR_UNSUPPORTED);
    EXPECT_NE(std::string(rollcon_last_error()).find("Coulomb's law alone"), std::string::npos) << rollcon_last_error();
    pair.friction(0.3);
    EXPECT_GE(pair.solve(), 0);
  }
}

TEST(friction_laws, parameters_are_checked) {
  RollingPair pair(steel, steel);
  const auto refused = [&](const char* law, const std::vector<double>& p, std::int32_t status, const char* words) {
    EXPECT_EQ(rollcon_contact_set_friction(pair.handle(), law, static_cast<std::int32_t>(p.size()), p.data()), status);
    EXPECT_NE(std::string(rollcon_last_error()).find(words), std::string::npos) << rollcon_last_error();
  };
  refused("orthotropic", {0.3, 0.2}, ROLLCON_ERR_ARGUMENT, "3 parameters: mu1, mu2, angle");
  refused("orthotropic", {0.3, -0.2, 0}, ROLLCON_ERR_ARGUMENT, "mu2 is -0.2; allowed: 0 or more");
  refused("orthotropic", {0.3, 0, 0}, ROLLCON_ERR_ARGUMENT, "1000 times");
  refused("orthotropic_collinear", {0.3, 0.2, NAN}, ROLLCON_ERR_NONFINITE, "parameters");
  refused("dry", {0.3}, ROLLCON_ERR_ARGUMENT, "'coulomb', 'orthotropic'");
}

}  // namespace
}  // namespace rollcon
