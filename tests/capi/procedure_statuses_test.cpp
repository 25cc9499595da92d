/// Tests statuses, iteration log and sensitivities of the solution procedures.

#include <array>

#include "procedures_fixture.hpp"

using namespace capi_test;

namespace {

struct Stopper {
  int calls = 0, stop_after = 0;
};

std::int32_t stop(const rollcon_event*, void* user) {
  auto& s = *static_cast<Stopper*>(user);
  return ++s.calls >= s.stop_after ? 1 : 0;
}

}  // namespace

class procedure_statuses : public ProcedureScene {
 protected:
  void expect_all_finite() const {
    for (const auto& v : {field(ROLLCON_FIELD_TRACTION, 3), field(ROLLCON_FIELD_GAP, 1), field(ROLLCON_FIELD_SLIP, 2),
                          field(ROLLCON_FIELD_PRESSURE, 1), field(ROLLCON_FIELD_DISPLACEMENT1, 3),
                          field(ROLLCON_FIELD_FRICTION_POWER, 1)})
      for (const double x : v) ASSERT_TRUE(std::isfinite(x));
    const Results r = results();
    for (const double x : {r.force[0], r.force[1], r.force[2], r.moment[2], r.approach, r.creep[0], r.creep[1],
                           r.creep[2], r.law, r.iterations})
      EXPECT_TRUE(std::isfinite(x));
    for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_CONTACT); ++i) {
      char name[64];
      ASSERT_EQ(rollcon_stat_info(ROLLCON_OF_CONTACT, i, sizeof name, name, nullptr, nullptr, nullptr), ROLLCON_OK);
      if (std::string(name).rfind("error_estimate", 0) == 0) continue;
      EXPECT_TRUE(std::isfinite(stat(name))) << name;
    }
  }
};
using procedure_statuses_long = procedure_statuses;

TEST_F(procedure_statuses_long, cancelled_then_solved) {
  const Results reference = standard();
  Stopper stopper;
  for (const Procedure& p : all_procedures())
    for (const int after : {1, 2, 4}) {
      SCOPED_TRACE(p.name() + ", after " + std::to_string(after));
      set(p);
      stopper = {0, after};
      ASSERT_EQ(rollcon_contact_set_progress(contact, stop, &stopper), ROLLCON_OK);
      EXPECT_EQ(solve_cold(), ROLLCON_CANCELLED);
      EXPECT_EQ(stopper.calls, after);
      expect_all_finite();
      ASSERT_EQ(rollcon_contact_set_progress(contact, nullptr, nullptr), ROLLCON_OK);
      ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK) << error();
      EXPECT_LE(difference(results().traction, reference.traction), 1e-6);
    }
}

TEST_F(procedure_statuses, too_few_iterations) {
  ASSERT_EQ(rollcon_contact_set_int(contact, "max_iterations", 2), ROLLCON_OK);
  for (const Procedure& p : all_procedures()) {
    SCOPED_TRACE(p.name());
    set(p);
    EXPECT_EQ(solve_cold(), ROLLCON_NOT_CONVERGED);
    expect_all_finite();
    EXPECT_LE(stat("iterations"), 2);
  }
}

// A linear solution of any accuracy may only cost iterations: what it leaves behind anywhere, in the equations of the
// bodies too, counts as a residual.
TEST_F(procedure_statuses, coarse_linear_solutions_do_not_pass_for_converged) {
  double worst = 0;
  int solved = 0;
  for (const double mu : {0.0, 0.1}) {
    ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &mu), ROLLCON_OK);
    for (const bool force : {false, true}) {
      force ? by_force(ROLLCON_NORMAL, 280) : by_motion(ROLLCON_NORMAL, 0.02);
      const Results reference = standard();
      for (const Procedure& p : all_procedures())
        for (const double eta : {0.9, 1e-2}) {
          if (std::string(p.linear_solver) == "lu") continue;
          SCOPED_TRACE(p.name() + ", tolerance " + std::to_string(eta));
          set(p);
          set("linear_tolerance", eta);
          const std::int32_t status = solve_cold();
          set("linear_tolerance", 0.0);
          ASSERT_TRUE(status == ROLLCON_OK || status == ROLLCON_NOT_CONVERGED) << error();
          if (status != ROLLCON_OK) continue;
          ++solved;
          const Results r = results();
          const double error = std::max(difference(r.traction, reference.traction), difference(r.gap, reference.gap));
          EXPECT_LE(error, 1e-6);
          worst = std::max(worst, error);
        }
    }
  }
  std::printf("%d solved with coarse linear solutions, tractions differ by %.1e (bound 1e-6)\n", solved, worst);
  EXPECT_GT(solved, 100);
}

TEST_F(procedure_statuses_long, bodies_apart_and_no_load) {
  for (const bool force : {false, true})
    for (const Procedure& p : all_procedures()) {
      SCOPED_TRACE(p.name());
      set(p);
      force ? by_force(ROLLCON_NORMAL, 0) : by_motion(ROLLCON_NORMAL, -0.01);
      EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
      EXPECT_EQ(largest(results().traction), 0);
      expect_all_finite();
      // The bodies touch again, and part again from there.
      by_motion(ROLLCON_NORMAL, 0.02);
      ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK);
      force ? by_force(ROLLCON_NORMAL, 0) : by_motion(ROLLCON_NORMAL, -0.01);
      EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_NO_CONTACT);
      EXPECT_EQ(largest(results().traction), 0);
    }
}

TEST_F(procedure_statuses, without_friction) {
  const double none = 0, some = 0.1;
  for (const bool force : {false, true}) {
    if (force) by_force(ROLLCON_NORMAL, 280);
    ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &none), ROLLCON_OK);
    const Results smooth = standard();
    ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &some), ROLLCON_OK);
    const Results rough = standard();
    double worst = 0;
    for (const Procedure& p : all_procedures()) {
      SCOPED_TRACE(p.name());
      set(p);
      for (const double mu : {none, some}) {
        ASSERT_EQ(rollcon_contact_set_friction(contact, "coulomb", 1, &mu), ROLLCON_OK);
        ASSERT_EQ(rollcon_contact_solve(contact), ROLLCON_OK) << error();
        const Results r = results();
        const double error = difference(r.traction, (mu > 0 ? rough : smooth).traction);
        EXPECT_LE(error, 1e-6);
        worst = std::max(worst, error);
        for (std::size_t k = 0; mu == 0 && k < r.state.size(); ++k) {
          ASSERT_EQ(r.traction[3 * k], 0);
          ASSERT_EQ(r.traction[3 * k + 1], 0);
        }
      }
    }
    std::printf("friction off and on again: tractions differ by %.1e (bound 1e-6)\n", worst);
  }
}

TEST_F(procedure_statuses, forces_beyond_friction_are_never_solved) {
  by_force(ROLLCON_NORMAL, 280);
  for (const Procedure& p : all_procedures())
    for (const double part : {1.1, -2.0}) {
      SCOPED_TRACE(p.name() + ", " + std::to_string(part));
      set(p);
      by_force(ROLLCON_LONGITUDINAL, part * 28);
      ASSERT_EQ(rollcon_contact_set_int(contact, "max_iterations", 60), ROLLCON_OK);
      const std::int32_t status = solve_cold();
      EXPECT_TRUE(status == ROLLCON_ERR_LOAD || status == ROLLCON_NOT_CONVERGED) << rollcon_status_string(status);
      if (status >= 0) expect_all_finite();
      by_force(ROLLCON_LONGITUDINAL, 10);
      ASSERT_EQ(rollcon_contact_set_int(contact, "max_iterations", 500), ROLLCON_OK);
      EXPECT_EQ(rollcon_contact_solve(contact), ROLLCON_OK) << "usable afterwards: " << error();
    }
}

TEST_F(procedure_statuses, error_function_falls_to_the_tolerance) {
  constexpr const char* columns = "error_function seconds residual_normal";
  constexpr std::size_t width = 3;
  std::int64_t rows = -1;
  ASSERT_EQ(rollcon_contact_get_history(contact, columns, 0, nullptr, &rows), ROLLCON_OK);
  EXPECT_EQ(rows, 0) << "before a solve";
  for (const Procedure& p : all_procedures()) {
    SCOPED_TRACE(p.name());
    set(p);
    ASSERT_EQ(solve_cold(), ROLLCON_OK);
    ASSERT_EQ(rollcon_contact_get_history(contact, columns, 0, nullptr, &rows), ROLLCON_OK);
    const auto n = static_cast<std::size_t>(rows);
    std::vector<double> table(width * n + 1, -7);
    std::int64_t needed = 0;
    EXPECT_EQ(rollcon_contact_get_history(contact, columns, rows - 1, table.data(), &needed), ROLLCON_ERR_CAPACITY);
    EXPECT_EQ(needed, rows);
    EXPECT_EQ(table[0], -7);
    ASSERT_EQ(rollcon_contact_get_history(contact, columns, rows, table.data(), nullptr), ROLLCON_OK);
    EXPECT_EQ(table[width * n], -7);
    for (std::size_t k = 0; k < n; ++k) {
      const double psi = table[width * k], seconds = table[width * k + 1], residual = table[width * k + 2];
      EXPECT_TRUE(std::isfinite(psi)) << k;
      EXPECT_GE(psi, 0) << k;
      EXPECT_GE(seconds, k > 0 ? table[width * k - 2] : 0);
      // One pair's residual is a part of the sum.
      EXPECT_GE(psi, 0.49 * residual * residual) << k;
    }
    EXPECT_LE(table[width * (n - 1)], 1e-16) << "largest residual 1e-10";
    EXPECT_LT(table[width * (n - 1)], 1e-10 * table[0]);
    std::vector<double> alone(n);
    ASSERT_EQ(rollcon_contact_get_history(contact, "error_function", rows, alone.data(), nullptr), ROLLCON_OK);
    for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(alone[k], table[width * k]);
  }
  EXPECT_FAILS(rollcon_contact_get_history(contact, columns, -1, nullptr, &rows), ARGUMENT, "capacity");
  ASSERT_EQ(rollcon_contact_reset(contact), ROLLCON_OK);
  ASSERT_EQ(rollcon_contact_get_history(contact, columns, 0, nullptr, &rows), ROLLCON_OK);
  EXPECT_EQ(rows, 0) << "forgotten";
}

TEST_F(procedure_statuses, results_that_need_operators_come_without_a_standard_solve_before) {
  set("procedure", "system=monolithic jacobian=b_derivative");
  ASSERT_EQ(solve_cold(), ROLLCON_OK) << error();
  double force[3] = {}, estimate = 0;
  ASSERT_EQ(rollcon_contact_get_sensitivity(contact, ROLLCON_LONGITUDINAL, force, nullptr, nullptr, nullptr),
            ROLLCON_OK)
      << error();
  EXPECT_NE(force[0], 0);
  ASSERT_EQ(rollcon_contact_get_stat(contact, "error_estimate", &estimate), ROLLCON_OK) << error();
  EXPECT_GT(estimate, 0);
  EXPECT_LT(estimate, 1);
}

TEST_F(procedure_statuses, sensitivities_are_those_of_the_standard_one) {
  const auto rates = [&] {
    std::vector<double> all;
    for (std::int32_t parameter = ROLLCON_LONGITUDINAL; parameter <= ROLLCON_FRICTION; ++parameter) {
      std::array<double, 10> v{};
      EXPECT_EQ(rollcon_contact_get_sensitivity(contact, parameter, &v[0], &v[3], &v[6], &v[7]), ROLLCON_OK) << error();
      // Each value is measured by its own size, because they have different dimensions.
      const double scale = std::hypot(v[0], v[1], v[2]);
      for (std::size_t i = 0; i < 3; ++i) all.push_back(v[i] / scale);
      for (std::size_t i = 3; i < 6; ++i) all.push_back(v[i] / scale);
      all.insert(all.end(), {v[6], v[7], v[8], v[9]});
    }
    return all;
  };
  standard();
  const std::vector<double> reference = rates();
  double worst = 0;
  for (const Procedure& p : all_procedures()) {
    SCOPED_TRACE(p.name());
    set(p);
    ASSERT_EQ(solve_cold(), ROLLCON_OK);
    const double error = difference(rates(), reference);
    EXPECT_LE(error, 1e-6);
    worst = std::max(worst, error);
  }
  std::printf("sensitivities differ by %.1e (bound 1e-6)\n", worst);
}
