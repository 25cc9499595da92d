/// Tests that what discards a solution discards all that was known of it: results, derivatives, estimates, iteration
/// log.

#include "contact/cases/solve_many.hpp"
#include "contact/solver.hpp"
#include "contact/time_step_case.hpp"

namespace rollcon::contact_test {
namespace {

/// Solves, and asks for everything that a solution gives.
void solve_and_ask(KalkerSpheres& s, double creep) {
  s.scene().set_creep(creep, 0, 0);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  double force[3];
  s.contact().sensitivity(Parameter::normal, force, nullptr, nullptr, nullptr);
  for (const char* name : {"error_estimate", "law_slip", "nodes_slip"}) s.contact().stat(name);
  EXPECT_FALSE(s.contact().history().empty());
}

void expect_gone(Contact& c) {
  double v[3];
  EXPECT_THROW(c.resultant(InAxes::local, v, nullptr), Error);
  EXPECT_THROW(c.sensitivity(Parameter::normal, v, nullptr, nullptr, nullptr), Error);
  EXPECT_THROW(c.stat("error_estimate"), Error);
  EXPECT_TRUE(c.history().empty());
  EXPECT_TRUE(c.error_function().empty());
}

/// Expects results, derivatives and estimates of a contact that solved nothing else.
void expect_like_new(KalkerSpheres& s, double creep) {
  KalkerSpheres fresh(16);
  solve_and_ask(fresh, creep);
  double here[3], there[3];
  for (const Parameter p : {Parameter::normal, Parameter::longitudinal}) {
    s.contact().sensitivity(p, here, nullptr, nullptr, nullptr);
    fresh.contact().sensitivity(p, there, nullptr, nullptr, nullptr);
    EXPECT_NEAR(here[0], there[0], 1e-6 * std::abs(there[0]));
  }
  for (const char* name : {"error_estimate", "friction_power", "nodes_slip", "nodes_stick"})
    EXPECT_NEAR(s.contact().stat(name), fresh.contact().stat(name), 1e-6 * std::abs(fresh.contact().stat(name)))
        << name;
}

class solution_gone : public testing::Test {
 protected:
  KalkerSpheres s{16};
};

TEST_F(solution_gone, after_a_reset) {
  solve_and_ask(s, -2e-4);
  s.contact().reset();
  expect_gone(s.contact());
  solve_and_ask(s, -4e-4);
  expect_like_new(s, -4e-4);
}

TEST_F(solution_gone, after_a_refused_solve) {
  solve_and_ask(s, -2e-4);
  s.scene().prescribe(1, 2, -2 * KalkerSpheres::mu * KalkerSpheres::load);
  EXPECT_THROW(s.contact().solve(), Error);
  double v[3];
  EXPECT_THROW(s.contact().resultant(InAxes::local, v, nullptr), Error);
  EXPECT_THROW(s.contact().stat("error_estimate"), Error);
  s.scene().prescribe(1, 1, 0);
  solve_and_ask(s, -4e-4);
  expect_like_new(s, -4e-4);
}

TEST_F(solution_gone, when_another_past_is_restored) {
  s.scene().set_step(rolling_step, 0.5);
  for (int k = 0; k < 2; ++k) solve_and_ask(s, -2e-4);
  std::vector<double> past(static_cast<std::size_t>(s.contact().past_get(0, nullptr)));
  s.contact().past_get(std::ssize(past), past.data());
  s.contact().past_set(std::ssize(past), past.data());
  expect_gone(s.contact());
}

TEST_F(solution_gone, when_another_is_gone_back_to) {
  solve_and_ask(s, -2e-4);
  const Solution kept = s.contact().solver->solution();
  solve_and_ask(s, -8e-4);
  s.scene().set_creep(-2e-4, 0, 0);
  s.contact().solver->return_to(kept);
  EXPECT_TRUE(s.contact().history().empty());
  EXPECT_TRUE(s.contact().error_function().empty());
  expect_like_new(s, -2e-4);
}

TEST_F(solution_gone, when_a_list_is_solved_after_a_change) {
  const Parameter parameter = Parameter::longitudinal;
  const double value = -3e-4;
  const CaseList list{{&parameter, 1}, 1, &value};
  std::int32_t status = -1;
  solve_and_ask(s, -2e-4);
  EXPECT_EQ(s.contact().solve_many(list, {.status = &status, .column = {}}), Status::ok);
  EXPECT_FALSE(s.contact().history().empty()) << "nothing has changed: the solution is still there";
  expect_like_new(s, -2e-4);
  s.scene().set_creep(-5e-4, 0, 0);
  EXPECT_EQ(s.contact().solve_many(list, {.status = &status, .column = {}}), Status::ok);
  expect_gone(s.contact());
}

TEST_F(solution_gone, when_friction_is_judged_before_a_solve) {
  solve_and_ask(s, -2e-4);
  s.contact().solver->frictionless_share();
  expect_gone(s.contact());
}

}  // namespace
}  // namespace rollcon::contact_test
