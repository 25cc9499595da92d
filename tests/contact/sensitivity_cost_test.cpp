/// Tests what derivatives cost, and that asking for them changes nothing.

#include <algorithm>
#include <cstdio>

#include "contact/sensitivity_case.hpp"

namespace rollcon {
namespace {

using namespace sensitivity_test;

// Returns the seconds of an iteration of the part that ends the solve.
double seconds_of_an_iteration(const RollingPair& pair) {
  constexpr const char* columns = "phase iteration seconds";
  std::int64_t count = 0;
  must(rollcon_contact_get_history(pair.handle(), columns, 0, nullptr, &count));
  std::vector<double> rows(static_cast<std::size_t>(3 * count));
  must(rollcon_contact_get_history(pair.handle(), columns, count, rows.data(), nullptr));
  const double* last = &rows[rows.size() - 3];
  const double* first = last;
  while (first != rows.data() && first[-3] == last[0]) first -= 3;
  return (last[2] - first[2]) / (last[1] - first[1]);
}

struct Cost {
  double iteration = INFINITY, first = INFINITY, all = INFINITY;  ///< seconds, least of several
  int first_krylov = 0, all_krylov = 0;
};

// Asks for all five, one after the other, each twice; counts after each stage.
void ask_for_all(const RollingPair& pair, bool coupled, bool lu, Cost& cost) {
  const auto count = [&](const char* what) {
    return static_cast<int>(pair.stat((std::string("sensitivity_") + what).c_str()));
  };
  EXPECT_EQ(count("right_sides"), 0) << "nothing before it is asked for";
  EXPECT_EQ(count("factorizations"), 0);
  derivatives(pair, ROLLCON_SPIN);
  EXPECT_EQ(count("right_sides"), 1);
  // GMRES goes on with the solve's factors unless they are too old.
  EXPECT_GE(count("factorizations"), lu ? 1 : 0);
  EXPECT_LE(count("factorizations"), 1);
  cost.first = std::min(cost.first, pair.stat("seconds_sensitivity"));
  cost.first_krylov = count("linear_iterations");
  for (const std::int32_t p : parameters) derivatives(pair, p);
  // Pressures that stand alone need one system of them and one of the tangential tractions.
  const int systems = coupled ? 1 : 2, right_sides = coupled ? 5 : 6;
  EXPECT_EQ(count("right_sides"), right_sides);
  EXPECT_GE(count("factorizations"), lu ? systems : 0);
  EXPECT_LE(count("factorizations"), systems);
  const double all = pair.stat("seconds_sensitivity");
  for (const std::int32_t p : parameters) derivatives(pair, p);
  EXPECT_EQ(count("right_sides"), right_sides) << "kept";
  EXPECT_EQ(pair.stat("seconds_sensitivity"), all);
  cost.all = std::min(cost.all, all);
  cost.all_krylov = count("linear_iterations");
  EXPECT_LE(cost.all_krylov, lu ? 0 : 25 * right_sides);
}

TEST(sensitivity, costs_one_factorisation_and_its_right_sides) {
  for (const bool coupled : {false, true})
    for (const char* solver : {"lu", "gmres"}) {
      auto made = half_spaces(coupled ? std::optional<Elastic>{} : steel, 20);
      made->option("linear_solver", solver).option("operators", "dense");
      Setting s(std::move(made), with({true, false, true, false}));
      RollingPair& pair = *s.pair;
      pair.option("tolerance", 1e-10);
      Cost cost;
      for (int repeat = 0; repeat < 5; ++repeat) {
        pair.reset();
        ASSERT_EQ(pair.solve(), ROLLCON_OK);
        const double kernels = pair.stat("kernel_evaluations");
        const double factors = pair.stat("factorizations");
        cost.iteration = std::min(cost.iteration, seconds_of_an_iteration(pair));
        ask_for_all(pair, coupled, std::string(solver) == "lu", cost);
        EXPECT_EQ(pair.stat("kernel_evaluations"), kernels);
        EXPECT_EQ(pair.stat("factorizations"), factors) << "those of the solve";
        EXPECT_EQ(pair.stat("compliance_assemblies"), 1);
      }
      std::printf(
          "%-9s %-5s %g unknowns: the first takes %.2f, all five %.2f Newton iterations of %.2f ms; %d and %d Krylov "
          "iterations (at most 25 per right side)\n",
          coupled ? "coupled" : "decoupled", solver, pair.stat("unknowns"), cost.first / cost.iteration,
          cost.all / cost.iteration, 1e3 * cost.iteration, cost.first_krylov, cost.all_krylov);
    }
}

TEST(sensitivity, asking_does_not_change_the_next_solve) {
  for (const bool coupled : {false, true})
    for (const char* solver : {"lu", "gmres"}) {
      std::vector<double> work[2];
      Values result[2];
      for (const std::size_t asked : {0U, 1U}) {
        auto made = half_spaces(coupled ? std::optional<Elastic>{} : steel, 16);
        made->option("linear_solver", solver);
        Setting s(std::move(made), rolling);
        for (int step = 1; step <= 3; ++step) {
          for (const std::int32_t p : parameters)
            if (asked == 1) derivatives(*s.pair, p);
          s.pair->creep((1 + 0.1 * step) * rolling.along, rolling.across, rolling.spin);
          ASSERT_EQ(s.pair->solve(), ROLLCON_OK);
          for (const char* stat : {"iterations", "linear_iterations", "factorizations"})
            work[asked].push_back(s.pair->stat(stat));
        }
        result[asked] = observe(*s.pair);
      }
      EXPECT_EQ(work[0], work[1]);
      double worst = 0;
      for (std::size_t i = 0; i < result[0].size(); ++i)
        worst = std::max(worst, std::abs(result[1][i] - result[0][i]) / std::abs(result[0][2]));
      expect_error("results after asking", worst, 1e-13);
    }
}

}  // namespace
}  // namespace rollcon
