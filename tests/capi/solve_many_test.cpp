/// Tests that results of lists of load cases are those of single solves.

#include "solve_many_fixture.hpp"

using namespace capi_test;

class solve_many : public CaseLists {};

TEST_F(solve_many, results_are_those_of_single_solves) {
  for (const std::int32_t longitudinal : {ROLLCON_BY_MOTION, ROLLCON_BY_FORCE}) {
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, longitudinal,
                                        longitudinal == ROLLCON_BY_FORCE ? 8.0 : 1e-3));
    std::vector<std::int32_t> parameters = three;
    parameters.push_back(ROLLCON_FRICTION);
    std::vector<double> values;
    const std::vector<double> some = scattered(20);
    for (std::size_t i = 0; i < 20; ++i) {
      values.insert(values.end(), some.begin() + 3 * static_cast<std::ptrdiff_t>(i),
                    some.begin() + 3 * static_cast<std::ptrdiff_t>(i + 1));
      values.push_back(0.8 + 0.05 * static_cast<double>(i));
    }
    const Table t = table(parameters, values, 2);
    double worst = 0, worst_slope = 0;
    for (std::size_t i = 0; i < 20; ++i) {
      const double* v = &values[4 * i];
      const double mu = 0.1 * v[3];
      ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_LATERAL, ROLLCON_BY_MOTION, v[0]), 0);
      ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, v[1]), 0);
      ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_SPIN, ROLLCON_BY_MOTION, v[2]), 0);
      ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &mu), 0);
      ASSERT_EQ(rollcon_contact_solve(contact), t.status[i]);
      double f[3], m[3], approach = 0, creep[3], number = 0;
      ASSERT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, f, m), 0);
      ASSERT_EQ(rollcon_contact_get_motion(contact, &approach, creep), 0);
      for (std::size_t c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(t.force[3 * i + c] - f[c]) / load);
        worst = std::max(worst, std::abs(t.moment[3 * i + c] - m[c]) / load);
        worst = std::max(worst, std::abs(t.creep[3 * i + c] - creep[c]) / 1e-3);
      }
      worst = std::max(worst, std::abs(t.approach[i] / approach - 1));
      for (const auto& [k, name] :
           {std::pair{1, "friction_power"}, std::pair{2, "max_pressure"}, std::pair{3, "contact_area"},
            std::pair{4, "nodes_contact"}, std::pair{5, "friction_power_balance"}}) {
        ASSERT_EQ(rollcon_contact_get_stat(contact, name, &number), 0);
        worst = std::max(
            worst, std::abs(t.statistics[name_count * i + static_cast<std::size_t>(k)] - number) / std::abs(number));
      }
      std::vector<double> traction(3 * nodes());
      ASSERT_EQ(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes, traction.data()), 0);
      for (std::size_t k = 0; k < traction.size(); ++k)
        worst = std::max(worst, std::abs(t.tractions[3 * nodes() * i + k] - traction[k]) / (load / 3));
      for (std::size_t j = 0; j < 4; ++j) {
        double df[3], dm[3], da = 0, dc[3];
        ASSERT_EQ(rollcon_contact_get_sensitivity(contact, parameters[j], df, dm, &da, dc), 0);
        const double* d = &t.derivatives[10 * (4 * i + j)];
        const double scale = std::abs(df[0]) + std::abs(df[1]) + std::abs(df[2]) + std::abs(dc[0]) * load;
        const double unit = j == 3 ? v[3] : 1;
        for (std::size_t c = 0; c < 3; ++c)
          worst_slope =
              std::max({worst_slope, std::abs(d[c] * unit - df[c]) / scale, std::abs(d[3 + c] * unit - dm[c]) / scale,
                        std::abs(d[7 + c] * unit - dc[c]) * load / scale});
        worst_slope = std::max(worst_slope, std::abs(d[6] * unit - da) * load / scale);
      }
      const double former = 0.1;
      ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &former), 0);
    }
    std::printf("20 cases, longitudinal by %s: off single solves by %.1e (bound 1e-7), slopes %.1e (bound 1e-5)\n",
                longitudinal == ROLLCON_BY_FORCE ? "force" : "motion", worst, worst_slope);
    EXPECT_LT(worst, 1e-7);
    EXPECT_LT(worst_slope, 1e-5);
  }
}

TEST_F(solve_many, equal_cases_are_solved_once_and_get_the_same_results) {
  const std::vector<double> few = grid();
  std::vector<double> twice = few;
  twice.insert(twice.end(), few.begin(), few.end());
  const std::size_t n = few.size() / 3;
  std::vector<std::size_t> at(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i) at[i] = i % n;
  for (double& v : twice)
    if (v == 0) v = -0.0;  // this is no other value
  EXPECT_EQ(differences(table(three, twice, 2), table(three, few, 2), at), 0);
}

TEST_F(solve_many, a_case_that_fails_leaves_the_others_alone) {
  // The traction is in fractions of what friction can carry; 1.2 and 2 have no solution.
  ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_LONGITUDINAL, ROLLCON_BY_FORCE, 0));
  const std::vector<std::int32_t> parameters{ROLLCON_LONGITUDINAL, ROLLCON_FRICTION};
  const double most = 0.1 * load;
  const std::vector<double> good{0.2 * most, 1, 0.5 * most, 1, -0.7 * most, 1, 0, 0};
  std::vector<double> values = good;
  values.insert(values.end(), {1.2 * most, 1, 2 * most, 1, 0.1 * most, 0});
  const Table t = table(parameters, values, 2, ROLLCON_NOT_CONVERGED);
  const Table only = table(parameters, good, 2);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(t.status[i], only.status[i]);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(t.force[3 * i + c], only.force[3 * i + c], 1e-9 * load) << i;
  }
  for (std::size_t i = 4; i < 7; ++i) {
    EXPECT_EQ(t.status[i], ROLLCON_ERR_LOAD);
    EXPECT_TRUE(std::isnan(t.force[3 * i]) && std::isnan(t.approach[i]) && std::isnan(t.statistics[name_count * i]) &&
                std::isnan(t.derivatives[20 * i]) && std::isnan(t.tractions[3 * nodes() * i]));
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(t.force[3 * i], good[2 * i], 1e-8 * load);
  EXPECT_EQ(t.force[9], 0) << "no friction, no force";
  EXPECT_TRUE(std::isnan(t.derivatives[20 * 3 + 10])) << "by friction at 0";
}

TEST_F(solve_many, lists_may_be_empty_and_cases_open) {
  std::vector<double> force;
  EXPECT_OK(forces({ROLLCON_NORMAL}, 0, {}, force));
  EXPECT_EQ(forces({ROLLCON_NORMAL}, 3, {load, 0, 0.5 * load}, force), ROLLCON_NO_CONTACT);
  EXPECT_NEAR(force[2], -load, 1e-8 * load);
  EXPECT_EQ(force[5], 0);
  EXPECT_NEAR(force[8], -0.5 * load, 1e-8 * load);
  // All cases without parameters are the scene itself.
  EXPECT_OK(rollcon_contact_solve_many(contact, nullptr, 2, nullptr, "force", 3, force.data(), nullptr, nullptr));
  EXPECT_NEAR(force[5], -load, 1e-8 * load);
  EXPECT_EQ(forces({ROLLCON_NORMAL}, 1, {4 * load}, force), ROLLCON_RIM_CONTACT);
  // The status of a contact of a few nodes goes before that of all that are only cut off or open.
  EXPECT_EQ(forces({ROLLCON_NORMAL}, 4, {load, 0, 4 * load, 1e-3 * load}, force), ROLLCON_COARSE);
}

TEST_F(solve_many, the_contact_keeps_scene_and_solution) {
  ASSERT_OK(rollcon_contact_solve(contact));
  std::vector<double> before(3 * nodes()), after(3 * nodes()), force;
  double slope[3], again[3], number = 0;
  ASSERT_EQ(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes, before.data()), 0);
  ASSERT_EQ(rollcon_contact_get_sensitivity(contact, ROLLCON_SPIN, slope, nullptr, nullptr, nullptr), 0);
  ASSERT_OK(forces(three, 60, grid(), force));
  ASSERT_EQ(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes, after.data()), 0);
  EXPECT_EQ(before, after);
  ASSERT_EQ(rollcon_contact_get_sensitivity(contact, ROLLCON_SPIN, again, nullptr, nullptr, nullptr), 0);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(slope[c], again[c]);
  ASSERT_EQ(rollcon_contact_get_stat(contact, "law_equilibrium", &number), 0);
  EXPECT_LT(number, 1e-9);
  // The next solve is warm, of the scene that it would have had without the list.
  ASSERT_OK(rollcon_contact_solve(contact));
  ASSERT_EQ(rollcon_contact_get_stat(contact, "iterations", &number), 0);
  EXPECT_EQ(number, 0);
  // The last solution is another scene's if the scene changed since.
  ASSERT_EQ(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 0.9 * load), 0);
  ASSERT_OK(forces(three, 60, grid(), force));
  EXPECT_FAILS(rollcon_contact_get_tractions(contact, ROLLCON_LOCAL, frame.nodes, after.data()), STATE, "solve");
}

TEST_F(solve_many, refuses_what_it_cannot_take) {
  std::vector<double> room(3 * nodes() + 8, 7);
  std::int64_t needed = 0;
  const auto call = [&](const char* parameters, std::int64_t cases, const double* v, const char* columns,
                        std::int64_t capacity) {
    return rollcon_contact_solve_many(contact, parameters, cases, v, columns, capacity, room.data(), &needed, nullptr);
  };
  const auto refused = [&](std::int32_t status, std::int32_t expected, const char* word) {
    EXPECT_EQ(status, expected);
    EXPECT_NE(error().find(word), std::string::npos) << error();
    EXPECT_EQ(error().substr(0, 26), "rollcon_contact_solve_many");
    for (const double v : room) EXPECT_EQ(v, 7);
  };
  const double good = load, negative = -1, not_a_number = std::nan(""), two[2] = {1, 1};
  refused(call("normal cost", 1, two, "force", 3), ROLLCON_ERR_ARGUMENT, "parameters has 'cost'");
  refused(call("NORMAL", 1, &good, "force", 3), ROLLCON_ERR_ARGUMENT, "allowed: longitudinal");
  refused(call(" spin  spin", 1, two, "force", 3), ROLLCON_ERR_ARGUMENT, "'spin' twice");
  refused(call("normal", -1, &good, "force", 3), ROLLCON_ERR_ARGUMENT, "n_cases is -1");
  refused(call("", INT64_MAX, nullptr, "", 0), ROLLCON_ERR_ARGUMENT, "n_cases is 9223372036854775807");
  refused(call("normal", 2, two, "force", INT64_MAX), ROLLCON_ERR_ARGUMENT, "address space");
  // No machine's memory holds this list, even without anything to be written.
  refused(call("", std::int64_t{1} << 40, nullptr, "", 0), ROLLCON_ERR_MEMORY, "a list of 1099511627776 cases takes");
  refused(call("normal", 1, nullptr, "force", 3), ROLLCON_ERR_ARGUMENT, "values is NULL");
  refused(call("normal", 1, &negative, "force", 3), ROLLCON_ERR_ARGUMENT, "case 0");
  refused(call("friction", 1, &negative, "force", 3), ROLLCON_ERR_ARGUMENT, "factor on friction");
  refused(call("normal", 1, &not_a_number, "force", 3), ROLLCON_ERR_NONFINITE, "case 0");
  refused(call("normal", 1, &good, " iterations  cost", 2), ROLLCON_ERR_OPTION,
          "columns has 'cost'; allowed: force, moment");
  refused(call("normal", 1, &good, "force", -1), ROLLCON_ERR_ARGUMENT, "capacity is -1");
  refused(call("normal", 1, &good, "", -1), ROLLCON_ERR_ARGUMENT, "capacity is -1");
  EXPECT_FAILS(rollcon_contact_solve_many(contact, "normal", 1, &good, "force", 3, nullptr, nullptr, nullptr), ARGUMENT,
               "results is NULL");
  const auto traction_columns = static_cast<std::int64_t>(3 * nodes());
  refused(call("normal", 1, &good, "tractions approach", traction_columns), ROLLCON_ERR_CAPACITY, "needed: 508");
  EXPECT_EQ(needed, traction_columns + 1);
  // Asking for the need solves nothing.
  needed = 0;
  EXPECT_OK(call("normal spin", 1, two, "derivatives tractions force", 0));
  EXPECT_EQ(needed, 20 + traction_columns + 3);
  for (const double v : room) EXPECT_EQ(v, 7);
  // Room beyond the columns is not written; a column may come twice.
  EXPECT_OK(call("normal", 1, &good, "force approach  force ", 8));
  EXPECT_EQ(room[7], 7);
  EXPECT_TRUE(same(&room[0], &room[4], 3));
  EXPECT_OK(call("normal", 1, &good, nullptr, 0));
}

TEST_F(solve_many, published_procedures_solve_lists_too) {
  if (!rollcon_has_feature("procedures")) GTEST_SKIP() << "this build has no published solution procedures";
  const std::vector<double> values = grid();
  const Table standard = table(three, values, 2);
  for (const char* procedure : {"jacobian=b_derivative", "jacobian=b_derivative system=monolithic"}) {
    ASSERT_OK(rollcon_contact_set_procedure(contact, procedure));
    const Table one = table(three, values, 1), two = table(three, values, 2);
    EXPECT_EQ(differences(one, two, in_order(60)), 0);
    double worst = 0, slopes = 0;
    for (std::size_t i = 0; i < one.force.size(); ++i)
      worst = std::max(worst, std::abs(one.force[i] - standard.force[i]) / load);
    for (std::size_t i = 0; i < one.derivatives.size(); ++i)
      slopes = std::max(slopes, std::abs(one.derivatives[i] - standard.derivatives[i]) / (load / 1e-3));
    std::printf("%s: off the standard iteration by %.1e (bound 1e-7), slopes %.1e (bound 1e-5)\n", procedure, worst,
                slopes);
    EXPECT_LT(worst, 1e-7);
    EXPECT_LT(slopes, 1e-5);
  }
}
