/// Tests a few thousand steps of a wheelset's oscillation: each converges in few iterations.

#include <algorithm>

#include "fixture.hpp"
#include "support/wheelset_run.hpp"

using namespace capi_test;
namespace run = rollcon::wheelset_run;

class time_loop : public Api {
 protected:
  /// Makes steel on a softer body, which couples normal and tangential problems, or steel on steel.
  void make_pair(bool dissimilar) {
    rollcon_contact_release(contact);
    for (rollcon_body** body : {&sphere, &plane}) {
      rollcon_body_release(*body);
      ASSERT_EQ(rollcon_body_create(context, ROLLCON_BODY_HALFSPACE, body), ROLLCON_OK);
      const bool soft = dissimilar && body == &plane;
      ASSERT_EQ(rollcon_body_set_elastic(*body, 0, (soft ? 0.8 : 1) * run::young, soft ? 0.45 : run::poisson),
                ROLLCON_OK);
    }
    ASSERT_EQ(rollcon_contact_create(context, sphere, plane, &contact), ROLLCON_OK);
    ASSERT_EQ(run::set_scene(contact, 11), 0);
    ASSERT_EQ(rollcon_contact_set_real(contact, "tolerance", run::tolerance), ROLLCON_OK);
    ASSERT_EQ(rollcon_context_set_threads(context, 1), ROLLCON_OK);
  }

  double statistic(const char* name) {
    double value = -1;
    EXPECT_EQ(rollcon_contact_get_stat(contact, name, &value), ROLLCON_OK);
    return value;
  }
};

TEST_F(time_loop, every_step_converges_in_few_iterations) {
  constexpr int steps = 1500;
  constexpr double most_assemblies = 1;
  for (const bool dissimilar : {false, true})
    for (const run::Drive drive : {run::Drive::creepage, run::Drive::traction}) {
      make_pair(dissimilar);
      double iterations = 0, most = 0, fallbacks = 0;
      int not_ok = 0;
      for (int i = 0; i < steps; ++i) {
        const run::Step s = run::step(i, drive);
        ASSERT_EQ(run::prescribe(contact, s, drive), 0);
        not_ok += rollcon_contact_solve(contact) != ROLLCON_OK;
        const double n = statistic("iterations");
        iterations += i > 0 ? n : 0;
        most = std::max(most, i > 0 ? n : 0);
        fallbacks += statistic("fallbacks");
        if (drive == run::Drive::creepage || i % 100 != 0) continue;
        double force[3];
        ASSERT_EQ(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, nullptr), 0);
        EXPECT_NEAR(force[0], s.longitudinal, 1e-6 * run::load) << i;
      }
      std::printf(
          "%s, longitudinal %s: %.3f iterations per step (bound 3), at most %g, %g fallbacks (bound %d), %d not OK "
          "(bound 0)\n",
          dissimilar ? "dissimilar" : "identical", drive == run::Drive::creepage ? "creepage" : "force",
          iterations / (steps - 1), most, fallbacks, steps / 500, not_ok);
      EXPECT_LE(iterations / (steps - 1), 3);
      EXPECT_LE(fallbacks, steps / 500);
      EXPECT_EQ(not_ok, 0);
      EXPECT_LE(statistic("compliance_assemblies"), most_assemblies);
    }
}
