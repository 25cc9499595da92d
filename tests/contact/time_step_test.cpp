// Compares shift and rolling in time steps with closed forms and published numbers (Cattaneo 1938, Mindlin &
// Deresiewicz 1953, Spence 1975, Kalker 1990).

#include "contact/host.hpp"
#include "contact/time_step_case.hpp"

namespace rollcon::contact_test {
namespace {

TEST(TimeStep, cattaneo_shift) {
  for (const char* operators : {"dense", "fft", "table"}) {
    Spheres s(32, operators);
    s.scene().set_step(shift_step, 1);
    s.scene().prescribe(1, 2, -7.0 / 8 * s.mu * s.load);
    ASSERT_EQ(s.contact().solve(), Status::ok);
    const double exact = s.shift(7.0 / 8), found = s.creep();
    std::printf("%s: shift %.6e, closed form %.6e: off by %.2f %% (bound 1)\n", operators, found, exact,
                100 * std::abs(found / exact - 1));
    EXPECT_NEAR(std::abs(found), exact, 0.01 * exact);
    EXPECT_LT(s.pair.worst_law(), 1e-5);
    // The nodes within half the radius stick.
    const double stick = s.contact().stat("nodes_stick"), all = stick + s.contact().stat("nodes_slip");
    std::printf("stick %.0f of %.0f nodes: %.3f (0.25)\n", stick, all, stick / all);
    EXPECT_NEAR(stick / all, 0.25, 0.02);
  }
}

// Every branch of the loop follows from the first by Masing's rule, and so does its area, the work lost in a cycle.
TEST(TimeStep, mindlin_loop) {
  constexpr int quarter = 12;
  constexpr double most = 0.75;
  Spheres s(32);
  s.scene().set_step(shift_step, 1);
  const double unit = s.mu * s.load;
  double shift = 0, before = 0, q = 0, cycle = 0, friction = 0, worst = 0;
  const double scale = s.shift(most);
  const auto step_to = [&](double next, bool closed) {
    s.scene().prescribe(1, 2, -next * unit);
    ASSERT_EQ(s.contact().solve(), Status::ok);
    before = shift;
    shift += s.creep();
    if (closed) {
      cycle += 0.5 * (q + next) * unit * (shift - before);
      friction += s.contact().stat("friction_power");
    }
    q = next;
  };
  const auto off = [&](double exact) { worst = std::max(worst, std::abs(shift - exact) / scale); };
  for (int k = 1; k <= quarter; ++k) step_to(most * k / quarter, false), off(s.shift(q));
  for (int k = 1; k <= 2 * quarter; ++k)
    step_to(most - most * k / quarter, true), off(s.shift(most) - 2 * s.shift((most - q) / 2));
  for (int k = 1; k <= 2 * quarter; ++k)
    step_to(-most + most * k / quarter, true), off(-s.shift(most) + 2 * s.shift((q + most) / 2));
  const double whole = s.shift(1);  // 3 mu P (2 - nu) / (8 G a)
  const double exact =
      4 * unit * whole * (1.2 * (1 - std::pow(1 - most, 5.0 / 3)) - most * (1 + std::pow(1 - most, 2.0 / 3)));
  std::printf(
      "loop: off by %.2f %% of the largest shift; work of a cycle %.5e, closed form %.5e (%.2f %%), friction %.5e\n",
      100 * worst, cycle, exact, 100 * (cycle / exact - 1), friction);
  EXPECT_LT(worst, 0.01);
  EXPECT_NEAR(cycle, exact, 0.01 * exact);
  // Friction's own work, at the end of steps, is of first order in the step.
  EXPECT_NEAR(friction, exact, 0.1 * exact);
}

// An elastic sphere is pressed on a rigid plane; the load grows with the cube of the steps.
TEST(TimeStep, spence_compression) {
  constexpr double load = 0.47052, radius = 121.5;
  const auto press = [&](int steps, double& ratio, double& pressure, double& depth) {
    Pair pair(1, 0, 1, -2);
    const std::vector<double> lines = frames::uniform_lines(-4.1, 4.1, 41);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    Scene& scene = pair.contact->scene;
    scene.set_gap_quadratic(0.5 / radius, 0.5 / radius, 0);
    pair.friction(0.2986);
    scene.set_step(shift_step, 1);
    for (int k = 1; k <= steps; ++k) {
      scene.prescribe(3, 2, load * std::pow(static_cast<double>(k) / steps, 3));
      const Status status = pair.contact->solve();
      ASSERT_TRUE(status == Status::ok || status == Status::coarse);
    }
    const double stick = pair.contact->stat("nodes_stick"), slip = pair.contact->stat("nodes_slip");
    ratio = std::sqrt(stick / (stick + slip));
    pressure = pair.contact->stat("max_pressure");
    pair.contact->motion(&depth, nullptr);
  };
  double ratio, pressure, depth, ratio1, pressure1, depth1;
  press(35, ratio, pressure, depth);
  press(1, ratio1, pressure1, depth1);
  std::printf("35 steps: c/a %.3f (Spence 0.5, bound 0.015), pmax %.5f (.02392, 1 %%), approach %.5f (.09874, 1 %%)\n",
              ratio, pressure, depth);
  std::printf("one step: c/a %.3f, pmax %.5f, approach %.5f\n", ratio1, pressure1, depth1);
  EXPECT_NEAR(ratio, 0.5, 0.015);
  EXPECT_NEAR(pressure, 0.02392, 0.01 * 0.02392);
  EXPECT_NEAR(depth, 0.09874, 0.01 * 0.09874);
  EXPECT_LT(ratio1, 0.9 * ratio);
}

// Cattaneo's shift is followed by rolling under its force: Kalker's transient.
TEST(TimeStep, from_cattaneo_to_carter) {
  constexpr double step = 0.25;
  KalkerSpheres s(34);
  s.scene().prescribe(1, 2, -0.657 * s.mu * s.load);
  s.scene().set_step(shift_step, 1);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  s.scene().set_speed(1);
  s.scene().set_step(rolling_step, step);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  const double onset = s.creep();
  std::int64_t iterations = 0;
  for (int k = 1; k < 80; ++k) {
    ASSERT_EQ(s.contact().solve(), Status::ok);
    iterations += static_cast<std::int64_t>(s.contact().stat("tangential_iterations"));
  }
  const double last = s.creep();
  std::printf("onset %.6f (.001824), after 20 mm %.6f (.003101), steps %.0f, %.1f iterations a step\n", onset, last,
              s.contact().stat("steps"), static_cast<double>(iterations) / 79);
  EXPECT_NEAR(std::abs(onset), 0.001824, 0.01 * 0.001824);
  EXPECT_NEAR(std::abs(last), 0.003101, 0.01 * 0.003101);
  EXPECT_EQ(s.contact().stat("steps"), 81);
  EXPECT_NEAR(s.contact().stat("step_time"), 1 + 80 * step, 1e-12);
}

// A step over the distance that the characteristic scheme looks upstream has the steady solution for its limit.
TEST(TimeStep, steady_limit) {
  for (const char* operators : {"dense", "fft", "table"})
    for (const bool by_force : {false, true}) {
      KalkerSpheres s(16, operators);
      s.scene().options.set_real("tolerance", 1e-12);
      s.scene().options.set_real("accuracy", 1e-9);
      if (by_force)
        s.scene().prescribe(1, 2, -0.5 * s.mu * s.load), s.scene().prescribe(4, 1, 3e-4);
      else
        s.scene().set_creep(-1e-3, 5e-4, 3e-4);
      ASSERT_EQ(s.contact().solve(), Status::ok);
      const std::vector<double> steady = s.pair.tractions();
      s.contact().reset();
      s.scene().set_step(rolling_step, characteristic_step * 8.5 / 16);
      for (int k = 0; k < 400; ++k) ASSERT_EQ(s.contact().solve(), Status::ok);
      const double off = largest_difference(steady, s.pair.tractions());
      std::printf("%s, %s: off the steady tractions by %.1e (bound 1e-6)\n", operators,
                  by_force ? "force given" : "creepage given", off);
      EXPECT_LT(off, 1e-6);
    }
}

// The force over the distance rolled from rest has errors that fall with the step, to first order at least.
TEST(TimeStep, order_in_the_step) {
  const auto force_after = [](int steps) {
    KalkerSpheres s(24, "table");
    s.scene().set_creep(-1.5e-3, 0, 0);
    s.scene().set_step(rolling_step, 3.5 / steps);
    for (int k = 0; k < steps; ++k) EXPECT_EQ(s.contact().solve(), Status::ok);
    double f[3];
    s.contact().resultant(InAxes::local, f, nullptr);
    return f[0] / (s.mu * s.load);
  };
  const double exact = force_after(256);
  double before = 0;
  for (const int steps : {4, 8, 16, 32}) {
    const double off = std::abs(force_after(steps) / exact - 1);
    std::printf("%d steps over the radius: off by %.2e, order %.2f\n", steps, off,
                before > 0 ? std::log2(before / off) : 0.0);
    if (before > 0) {
      EXPECT_GT(std::log2(before / off), 0.8);
    }
    before = off;
  }
  EXPECT_LT(before, 0.02);
}

/// Loads N and Q = N / 4 grow from nothing, without slip: shift over approach is (2 - nu) / (8 (1 - nu)), q is p / 4
/// (Mindlin and Deresiewicz).
struct ObliqueLoad {
  double shift = 0;            ///< sum over the steps, relative to the closed form
  double first = 0;            ///< that of the first step
  double worst = 0;            ///< difference of q and p / 4 over the largest p / 4
  double growth = 0, law = 0;  ///< least step_growth, worst residual of the laws
};

ObliqueLoad apply_obliquely(const char* operators, int steps, double power) {
  Spheres s(32, operators);
  s.pair.friction(0.6);
  s.scene().set_step(shift_step, 1);
  ObliqueLoad o{.growth = 1};
  for (int k = 1; k <= steps; ++k) {
    const double load = s.load * std::pow(static_cast<double>(k) / steps, power);
    s.scene().prescribe(3, 2, load);
    s.scene().prescribe(1, 2, -0.25 * load);
    EXPECT_TRUE(is_answer(s.contact().solve()));
    o.shift += std::abs(s.creep());
    if (k == 1) o.first = o.shift;
    o.growth = std::min(o.growth, s.contact().stat("step_growth"));
  }
  double approach = 0;
  s.contact().motion(&approach, nullptr);
  const double exact = 0.25 * approach * (2 - s.nu) / (2 * (1 - s.nu));
  o.shift /= exact;
  o.first /= exact;
  o.law = s.pair.worst_law();
  const std::vector<double> traction = s.pair.tractions();
  for (std::size_t k = 0; k < traction.size(); k += 3)
    o.worst = std::max(o.worst, std::abs(std::abs(traction[k]) + 0.25 * traction[k + 2]) / (0.25 * s.p0));
  return o;
}

TEST(TimeStep, particles_that_touch_within_a_step) {
  for (const char* operators : {"dense", "fft"}) {
    const ObliqueLoad o = apply_obliquely(operators, 20, 3);
    std::printf("%s: shift off by %.2f %% (bound 0.2), q by %.1f %% of its largest (4), laws %.1e (1e-6)\n", operators,
                100 * (o.shift - 1), 100 * o.worst, o.law);
    EXPECT_NEAR(o.shift, 1, 0.002);
    EXPECT_LT(o.worst, 0.04);
    EXPECT_LT(o.law, 1e-6);
    EXPECT_GT(o.growth, 0.05);
  }
}

// The first step from rest presses before it shifts, as Cattaneo's does: its shift misses three eighths of itself.
TEST(TimeStep, first_step_from_rest_presses_before_it_shifts) {
  for (const int steps : {5, 20}) {
    const ObliqueLoad o = apply_obliquely("dense", steps, 1);
    const double told = 0.375 * o.first;
    std::printf("%d steps: shift %.2f %% too small, first step %.2f %% (bounds: 0.8 to 1.25 times)\n", steps,
                100 * (1 - o.shift), 100 * told);
    EXPECT_GT(told, 0.8 * (1 - o.shift));
    EXPECT_LT(told, 1.25 * (1 - o.shift));
  }
}

// A steady solve after a step in which particles touched is that of a contact without steps.
TEST(TimeStep, steady_rolling_after_a_growing_contact) {
  KalkerSpheres stepped(16), fresh(16);
  for (KalkerSpheres* s : {&stepped, &fresh}) {
    s->scene().options.set_real("tolerance", 1e-10);
    s->scene().set_creep(-1e-3, 3e-4, 0);
  }
  stepped.scene().set_step(shift_step, 1);
  for (const double part : {0.2, 1.0}) {
    stepped.scene().prescribe(3, 2, part * stepped.load);
    ASSERT_TRUE(is_answer(stepped.contact().solve()));
  }
  stepped.scene().set_step(0, 0);
  for (KalkerSpheres* s : {&stepped, &fresh}) ASSERT_EQ(s->contact().solve(), Status::ok);
  const double off = largest_difference(fresh.pair.tractions(), stepped.pair.tractions());
  std::printf("tractions differ by %.1e (bound 1e-6)\n", off);
  EXPECT_LT(off, 1e-6);
}

// Rolling steps tell what part of a circle's area rolled in, 2 d / (pi a).
TEST(TimeStep, area_that_rolls_in) {
  KalkerSpheres s(34);
  s.scene().set_creep(-1e-3, 0, 0);
  for (const double step : {0.1, 0.5}) {
    s.scene().set_step(rolling_step, step);
    for (int k = 0; k < 2; ++k) ASSERT_EQ(s.contact().solve(), Status::ok);
    const double found = s.contact().stat("step_growth"), exact = 2 * step / (std::numbers::pi * s.a);
    std::printf("step %.1f: %.4f of the area rolls in (%.4f, bound 5 %%)\n", step, found, exact);
    EXPECT_NEAR(found, exact, 0.05 * exact);
  }
  EXPECT_GT(s.contact().stat("stick_area"), 0.1 * s.contact().stat("contact_area"));
  EXPECT_LT(s.contact().stat("stick_area"), s.contact().stat("contact_area"));
}

// The material travels so far that a lattice's offsets are no numbers any more.
TEST(TimeStep, steps_that_overflow_are_refused) {
  for (const double dt : {1e30, 1e160, 1e300}) {
    KalkerSpheres spheres(12);
    spheres.pair.friction(KalkerSpheres::mu);
    spheres.scene().set_creep(1e-3, 0, 0);
    spheres.contact().solve();
    spheres.scene().set_step(rolling_step, dt);
    try {
      spheres.contact().solve();
      ADD_FAILURE() << dt;
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::err_argument);
      EXPECT_NE(std::string(error.what()).find("V dt = "), std::string::npos) << error.what();
    }
    spheres.scene().set_step(rolling_step, 1);
    EXPECT_EQ(spheres.contact().solve(), Status::ok) << dt;
  }
}

// The steps take 35 mm, five times the contact: all material is new, and what it brings along is what is left of
// displacements so far away.
TEST(TimeStep, steps_longer_than_the_contact) {
  KalkerSpheres s(24);
  s.scene().set_creep(-1e-4, 2e-5, 1e-5);
  s.scene().set_step(rolling_step, 5 * 2 * 3.5);
  std::vector<double> before;
  double off = 1;
  for (int k = 0; k < 6; ++k) {
    ASSERT_EQ(s.contact().solve(), Status::ok);
    const std::vector<double> now = s.pair.tractions();
    if (!before.empty()) {
      const double change = largest_difference(before, now);
      std::printf("step %d: tractions change by %.1e\n", k, change);
      EXPECT_LT(change, 0.5 * off);
      off = change;
    }
    before = now;
  }
  EXPECT_LT(off, 1e-3);
}

}  // namespace
}  // namespace rollcon::contact_test
