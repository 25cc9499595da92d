/// Compares the power of friction from the balance of work with the sum of traction times slip at nodes.

#include "contact/time_step_case.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

struct Rolling {
  double young2, poisson2;
  double creep[3];
};

constexpr Rolling scenes[] = {{2e5, 0.3, {1e-3, 0, 0}},
                              {2e5, 0.3, {3e-4, -4e-4, 1.5e-3}},
                              {7e4, 0.4, {1e-3, 0, 0}},
                              {7e4, 0.4, {3e-4, -4e-4, 1.5e-3}},
                              {1e4, -2, {3e-4, -4e-4, 1.5e-3}}};

std::unique_ptr<Pair> solved(const Rolling& r, int n, double speed = 1) {
  auto pair = std::make_unique<Pair>(r.poisson2 < -1 ? 1e4 : 2e5, 0.3, r.young2, r.poisson2);
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, n);
  pair->frame(frames::rectangle(ElementType::quad4, lines, lines));
  Scene& scene = pair->contact->scene;
  scene.set_gap_quadratic(0.01, 0.013, 0);
  pair->friction(0.3);
  scene.set_speed(speed);
  scene.prescribe(3, 1, 0.01);
  scene.set_creep(r.creep[0], r.creep[1], r.creep[2]);
  if (pair->contact->solve() != Status::ok) throw std::runtime_error("not solved");
  return pair;
}

TEST(power, of_the_balance_is_right_on_coarse_grids) {
  for (const Rolling& r : scenes) {
    // Both ways meet as the grid is refined, the sum at nodes from below, and slowly.
    const auto fine = solved(r, 96), coarse = solved(r, 32);
    const double limit = fine->contact->stat("friction_power_balance");
    const double balance = coarse->contact->stat("friction_power_balance") / limit - 1;
    const double nodal = coarse->contact->stat("friction_power") / limit - 1;
    const double nodal_fine = fine->contact->stat("friction_power") / limit - 1;
    std::printf("balance %+.3f (bound 0.04), at nodes %+.3f, on the finer grid %+.3f\n", balance, nodal, nodal_fine);
    EXPECT_LT(std::abs(balance), 0.04);
    EXPECT_LT(std::abs(balance), std::abs(nodal));
    EXPECT_LT(nodal, 0);
    EXPECT_GT(nodal_fine, 0.55 * nodal) << "the sum at nodes goes to the balance";
  }
}

TEST(power, is_force_times_speed_and_nothing_in_free_rolling_of_equal_bodies) {
  const double one = solved(scenes[1], 20)->contact->stat("friction_power_balance");
  EXPECT_NEAR(solved(scenes[1], 20, 7)->contact->stat("friction_power_balance"), 7 * one, 1e-9 * one);
  EXPECT_NEAR(solved({2e5, 0.3, {0, 0, 0}}, 20)->contact->stat("friction_power_balance"), 0, 1e-9 * one);
  // Unlike bodies lose power though no force drives them.
  EXPECT_GT(solved({7e4, 0.4, {0, 0, 0}}, 20)->contact->stat("friction_power_balance"), 0.01 * one);
}

TEST(power, counts_slip_given_as_a_field_like_creepage) {
  const double given = solved(scenes[2], 20)->contact->stat("friction_power_balance");
  const auto pair = solved(scenes[2], 20);
  const auto n = static_cast<std::size_t>(pair->contact->nodes());
  std::vector<double> slip(2 * n, 0.0);
  for (std::size_t k = 0; k < n; ++k) slip[2 * k] = scenes[2].creep[0];
  pair->contact->scene.set_creep(0, 0, 0);
  pair->contact->scene.set_creep_field(static_cast<std::int64_t>(n), slip.data());
  ASSERT_EQ(pair->contact->solve(), Status::ok);
  const double field = pair->contact->stat("friction_power_balance");
  std::printf("as a field %.8g, as creepage %.8g\n", field, given);
  EXPECT_NEAR(field, given, 1e-6 * given);
}

TEST(power_long, does_not_depend_on_the_kind_of_element) {
  const double limit = solved(scenes[2], 96)->contact->stat("friction_power_balance");
  for (const ElementType type :
       {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    Pair pair(2e5, 0.3, 7e4, 0.4);
    // The type quad8 knows slip least (docs/theory.md): 0.23 off with 10 elements.
    const int elements = type == ElementType::quad8 ? 16 : is_quadratic(type) ? 10 : 20;
    const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, elements);
    pair.frame(frames::perturb(frames::rectangle(type, lines, lines), 0.1, 5));
    pair.contact->scene.set_gap_quadratic(0.01, 0.013, 0);
    pair.friction(0.3);
    pair.contact->scene.prescribe(3, 1, 0.01);
    pair.contact->scene.set_creep(1e-3, 0, 0);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double balance = pair.contact->stat("friction_power_balance") / limit - 1;
    std::printf("%d: %+.3f (bound 0.15)\n", static_cast<int>(type), balance);
    EXPECT_LT(std::abs(balance), 0.15);
  }
}

// A gap so large that a node never touches says nothing about the slope of the surface there.
TEST(power, takes_no_slope_from_nodes_that_are_never_to_touch) {
  const auto pair = solved(scenes[2], 20);
  const double before = pair->contact->stat("friction_power_balance");
  std::vector<double> gap;
  const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 20);
  for (const Vec3& x : frames::rectangle(ElementType::quad4, lines, lines).node)
    gap.push_back(x[1] > 0.1 ? 1e200 : 0.01 * x[0] * x[0] + 0.013 * x[1] * x[1]);
  pair->contact->scene.set_gap(static_cast<std::int64_t>(gap.size()), gap.data());
  ASSERT_EQ(pair->contact->solve(), Status::ok);
  const double after = pair->contact->stat("friction_power_balance");
  std::printf("whole %.4g, half of the surface gone %.4g\n", before, after);
  EXPECT_GT(after, 0.2 * before);
  EXPECT_LT(after, 2 * before);
}

// Friction loses the work that forces put in around a closed loop of load.
TEST(power, of_steps_adds_up_to_the_work_of_a_closed_loop) {
  for (const bool rolling : {false, true}) {
    double error[2] = {};
    for (const int steps : {24, 48}) {
      Spheres s(16);
      s.scene().set_speed(0.05 * s.a);
      s.scene().set_step(rolling ? rolling_step : shift_step, 24.0 / steps);
      const double unit = s.mu * s.load, distance = rolling ? 0.05 * s.a * 24.0 / steps : 1;
      double put_in = 0, balance = 0, nodal = 0, f = 0;
      for (int k = 1; k <= 5 * steps / 4; ++k) {
        const double q = 0.75 * std::sin(2 * std::numbers::pi * k / steps);
        s.scene().prescribe(1, 2, -q * unit);
        ASSERT_EQ(s.contact().solve(), Status::ok);
        const double before = f;
        f = -q * unit;
        if (k <= steps / 4) continue;
        put_in -= 0.5 * (f + before) * s.creep() * distance;
        balance += s.contact().stat("friction_power_balance") * 24.0 / steps;
        nodal += s.contact().stat("friction_power") * 24.0 / steps;
      }
      error[steps == 48] = balance / put_in - 1;
      std::printf("%s, %d steps: put in %.5e, lost %.5e (%+.2f %%), at nodes %.5e\n", rolling ? "rolling" : "shift",
                  steps, put_in, balance, 100 * error[steps == 48], nodal);
    }
    EXPECT_LT(std::abs(error[1]), rolling ? 0.08 : 0.01);
    EXPECT_LT(std::abs(error[1]), 0.7 * std::abs(error[0])) << "of first order in the step";
  }
}

TEST(power, of_steps_tends_to_that_of_steady_rolling) {
  for (const Rolling& r : {scenes[1], scenes[3], scenes[4]}) {
    const auto pair = solved(r, 20);
    const double steady = pair->contact->stat("friction_power_balance");
    pair->contact->scene.set_step(rolling_step, 0.6 * 2.6 / 20);
    ASSERT_EQ(pair->contact->solve(), Status::ok);
    const double first = pair->contact->stat("friction_power_balance") / steady - 1;
    std::printf("a step from the steady state: %.1e (bound 1e-6)\n", first);
    EXPECT_LT(std::abs(first), 1e-6);
    pair->contact->reset();
    double last = 0;
    for (int k = 0; k < 60; ++k) {
      ASSERT_EQ(pair->contact->solve(), Status::ok);
      last = pair->contact->stat("friction_power_balance") / steady - 1;
      if (k == 0) std::printf("first step from rest %+.3f, ", last);
    }
    std::printf("after 60 steps from rest: %.1e (bound 3e-3)\n", last);
    EXPECT_LT(std::abs(last), 3e-3);
  }
}

// Nothing slips: forces only load the bodies.
TEST(power, of_steps_is_nothing_where_all_nodes_stick) {
  Spheres s(20);
  const double mu = 1e3;
  s.scene().set_friction("coulomb", 1, &mu);
  s.scene().set_step(shift_step, 1);
  for (int k = 1; k <= 3; ++k) {
    s.scene().prescribe(1, 2, -0.2 * k * s.load);
    ASSERT_EQ(s.contact().solve(), Status::ok);
    const double put_in = std::abs(0.2 * s.load * s.creep()), lost = s.contact().stat("friction_power_balance");
    std::printf("lost %.1e of %.1e put in (bound 1e-9)\n", lost, put_in);
    EXPECT_LT(std::abs(lost), 1e-9 * put_in);
  }
}

}  // namespace
}  // namespace rollcon
