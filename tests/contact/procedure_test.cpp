/// Tests solution procedures from options, and the adaptive tolerance of their linear systems.

#include "contact/scene/procedure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace rollcon {
namespace {

using Texts = std::vector<std::pair<const char*, const char*>>;

Options with(const Texts& texts) {
  Options o;
  std::string procedure;
  for (const auto& [name, value] : texts)
    if (std::any_of(procedure_table().begin(), procedure_table().end(),
                    [&](const Setting& s) { return std::string(s.name) == name; }))
      procedure += std::string(name) + "=" + value + " ";
    else
      o.set_text(name, value);
  o.set_procedure(procedure.c_str());
  return o;
}

TEST(procedure, standard_is_condensed_and_exact) {
  const Procedure p = choose_procedure(Options{});
  EXPECT_TRUE(p.standard());
  EXPECT_FALSE(p.monolithic);
  EXPECT_EQ(p.jacobian, Jacobian::exact);
  EXPECT_EQ(p.linear, LinearMethod::automatic);
  EXPECT_EQ(p.preconditioner, Preconditioner::automatic);
  EXPECT_EQ(p.line_search, LineSearch::automatic);
  EXPECT_EQ(p.eta, 0);
  EXPECT_FALSE(choose_procedure(with({{"system", "monolithic"}})).standard());
  EXPECT_FALSE(choose_procedure(with({{"jacobian", "b_derivative"}})).standard());
}

TEST(procedure, takes_every_name) {
  for (const auto& [name, wanted] : {std::pair{"exact", Jacobian::exact},
                                     {"b_derivative", Jacobian::b_derivative},
                                     {"simplified", Jacobian::simplified}})
    EXPECT_EQ(choose_procedure(with({{"jacobian", name}})).jacobian, wanted) << name;
  for (const auto& [name, wanted] : {std::pair{"auto", SlipEstimate::jacobi},
                                     {"jacobi", SlipEstimate::jacobi},
                                     {"pseudo_temporal", SlipEstimate::pseudo_temporal},
                                     {"extrapolation", SlipEstimate::extrapolation}})
    for (const char* scheme : {"godunov", "least_squares"}) {
      const Procedure p =
          choose_procedure(with({{"jacobian", "reduced"}, {"slip_estimate", name}, {"convection", scheme}}));
      EXPECT_EQ(p.jacobian, Jacobian::reduced);
      EXPECT_EQ(p.estimate, wanted) << name;
    }
  for (const auto& [name, wanted] : {std::pair{"auto", LinearMethod::automatic},
                                     {"lu", LinearMethod::lu},
                                     {"gmres", LinearMethod::gmres},
                                     {"gmres_adaptive", LinearMethod::gmres_adaptive}})
    EXPECT_EQ(choose_procedure(with({{"linear_solver", name}})).linear, wanted) << name;
  for (const auto& [name, wanted] : {std::pair{"none", Preconditioner::none},
                                     {"diagonal", Preconditioner::diagonal},
                                     {"bodies", Preconditioner::bodies}})
    for (const char* solver : {"gmres", "gmres_adaptive"})
      EXPECT_EQ(choose_procedure(with({{"system", "monolithic"}, {"linear_solver", solver}, {"preconditioner", name}}))
                    .preconditioner,
                wanted)
          << name;
  for (const auto& [name, wanted] :
       {std::pair{"auto", LineSearch::automatic}, {"armijo", LineSearch::armijo}, {"off", LineSearch::off}})
    EXPECT_EQ(choose_procedure(with({{"jacobian", "simplified"}, {"line_search", name}})).line_search, wanted) << name;
}

TEST(procedure, one_tolerance_is_that_of_either_gmres) {
  Options o = with({{"linear_solver", "gmres"}});
  EXPECT_EQ(choose_procedure(o).eta_max, 0.01);
  o.set_real("linear_tolerance", 1e-3);
  EXPECT_EQ(choose_procedure(o).eta, 1e-3);
  EXPECT_EQ(choose_procedure(o).eta_max, 0.01);
  o.set_text("linear_solver", "gmres_adaptive");
  EXPECT_EQ(choose_procedure(o).eta, 0);
  EXPECT_EQ(choose_procedure(o).eta_max, 1e-3);
}

TEST(adaptive_tolerance, begins_with_the_largest) {
  EXPECT_EQ(adaptive_tolerance(0.5, 1e-3, 0, 0), 0.5);
  EXPECT_EQ(adaptive_tolerance(0.1, 1e-3, 1, 0), 0.1);
}

TEST(adaptive_tolerance, follows_the_decrease_of_squared_residuals) {
  // The rules (72), (73) give 0.3 * 0.04 = 0.012; the safeguard 0.3 * 0.2^2 = 0.012 is below 0.1 and rests.
  EXPECT_DOUBLE_EQ(adaptive_tolerance(0.5, 0.08, 2, 0.2), 0.012);
  EXPECT_DOUBLE_EQ(adaptive_tolerance(0.5, 2e-6, 2, 0.2), 3e-7);
  EXPECT_EQ(adaptive_tolerance(0.5, 0, 2, 0.2), 0) << "solved";
}

TEST(adaptive_tolerance, is_not_beyond_the_largest) {
  EXPECT_EQ(adaptive_tolerance(0.5, 5, 1, 0.3), 0.5) << "the residual grew";
  EXPECT_EQ(adaptive_tolerance(0.1, 0.5, 1, 0.1), 0.1) << "0.15";
  EXPECT_DOUBLE_EQ(adaptive_tolerance(0.5, 0.5, 1, 0.3), 0.15);
}

TEST(adaptive_tolerance, is_safeguarded_far_from_the_solution) {
  // The safeguard 0.3 * 0.8^2 = 0.192 exceeds 0.1.
  EXPECT_DOUBLE_EQ(adaptive_tolerance(0.9, 1e-6, 1, 0.8), 0.192);
  // The next safeguard 0.3 * 0.192^2 = 0.011 is below 0.1.
  EXPECT_DOUBLE_EQ(adaptive_tolerance(0.9, 1e-6, 1, 0.192), 3e-7);
  EXPECT_DOUBLE_EQ(adaptive_tolerance(0.9, 0.7, 1, 0.8), 0.21) << "the larger";
  // The bound holds for the safeguard too: 0.3 * 0.8^2 = 0.192.
  EXPECT_DOUBLE_EQ(adaptive_tolerance(0.15, 1e-6, 1, 0.8), 0.15);
}

}  // namespace
}  // namespace rollcon
