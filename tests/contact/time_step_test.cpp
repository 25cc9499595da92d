// Shift and rolling in time steps: closed forms and published numbers (Cattaneo 1938, Mindlin & Deresiewicz 1953,
// Spence 1975, Kalker 1990).

#include <numbers>

#include "contact/scene_fixture.hpp"

namespace rollcon::contact_test {
namespace {

constexpr double pi = std::numbers::pi;

enum : std::int32_t { rolling_step = 1, shift_step = 2 };

/// Two equal spheres of radius 50 (R = 50 of the pair's curvature as in Cattaneo's example), G = 200, nu = 0.42, mu 0.4.
struct Spheres {
  double g = 200, nu = 0.42, mu = 0.4, load = 9.1954;
  double young = 2 * g * (1 + nu);
  double modulus = young / (1 - nu * nu) / 2, radius = 50;
  double a = std::cbrt(3 * load * radius / (4 * modulus));
  double p0 = 3 * load / (2 * pi * a * a);
  Pair pair{young, nu, young, nu};

  explicit Spheres(int n, const char* operators = "auto", double half = 1.2) {
    const std::vector<double> lines = frames::uniform_lines(-half * a, half * a, n);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    scene().set_gap_quadratic(0.5 / radius, 0.5 / radius, 0);
    pair.friction(mu);
    scene().prescribe(3, 2, load);
    scene().options.set_text("operators", operators);
  }
  Scene& scene() { return pair.contact->scene; }
  Contact& contact() { return *pair.contact; }
  /// Cattaneo's and Mindlin's shift of equal bodies under a force Q of mu P, from nothing.
  double shift(double q) const {
    return 3 * mu * load * (2 - nu) / (8 * g * a) * (1 - std::pow(1 - q, 2.0 / 3));
  }
  double creep() {
    double c[3];
    contact().motion(nullptr, c);
    return c[0];
  }
  double force() {
    double f[3];
    contact().resultant(InAxes::local, f, nullptr);
    return f[0];
  }
};

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
    // Stick inside half the radius.
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
  std::printf("loop: off by %.2f %% of the largest shift; work of a cycle %.5e, closed form %.5e (%.2f %%), friction %.5e\n",
              100 * worst, cycle, exact, 100 * (cycle / exact - 1), friction);
  EXPECT_LT(worst, 0.01);
  EXPECT_NEAR(cycle, exact, 0.01 * exact);
  // Friction's own work, at the end of steps: of first order in the step.
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

/// Kalker's two spheres: G = 1, nu = 0.28, a = 3.5, mu = 0.4013.
struct KalkerSpheres {
  static constexpr double g = 1, nu = 0.28, a = 3.5, load = 0.4705, mu = 0.4013;
  Pair pair{2 * g * (1 + nu), nu, 2 * g * (1 + nu), nu};
  explicit KalkerSpheres(int n, const char* operators = "auto", double half = 4.25) {
    const std::vector<double> lines = frames::uniform_lines(-half, half, n);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    scene().set_gap_quadratic(0.002963, 0.002963, 0);
    pair.friction(mu);
    scene().prescribe(3, 2, load);
    scene().options.set_text("operators", operators);
  }
  Scene& scene() { return pair.contact->scene; }
  Contact& contact() { return *pair.contact; }
  double creep(int which = 0) {
    double c[3];
    contact().motion(nullptr, c);
    return c[which];
  }
};

// Cattaneo's shift, then rolling under the same force: Kalker's transient.
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

// A step over the distance that the characteristic scheme looks ahead has the steady solution for its limit.
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

// From rest, the force over the distance rolled: errors fall with the step, to first order at least.
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

// Of 35 mm, five times the contact: all material is new, and what it brings along is what is left of displacements so
// far away.
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

/// Rolling under changing loads, motions, approach, friction and gap.
void change_scene(Scene& scene, int k) {
  const double t = 0.3 * k;
  scene.prescribe(3, 2, KalkerSpheres::load * (1 + 0.3 * std::sin(t)));
  scene.set_creep(-1e-3 * std::cos(t), 4e-4 * std::sin(2 * t), 2e-4 * std::sin(t));
  const double mu = 0.4 + 0.1 * std::cos(t);
  scene.set_friction("coulomb", 1, &mu);
  scene.set_gap_quadratic(0.003 + 2e-4 * std::sin(t), 0.003, 1e-4 * std::cos(t));
}

TEST(TimeStep, everything_changes_from_step_to_step) {
  KalkerSpheres dense(20, "dense"), fft(20, "fft"), table(20, "table");
  double worst = 0, law = 0;
  for (KalkerSpheres* s : {&dense, &fft, &table}) s->scene().options.set_real("accuracy", 1e-9);
  for (int k = 0; k < 25; ++k) {
    for (KalkerSpheres* s : {&dense, &fft, &table}) {
      change_scene(s->scene(), k);
      s->scene().set_step(rolling_step, k % 5 == 0 ? 1.1 : 0.3);
      ASSERT_GE(static_cast<int>(s->contact().solve()), 0);
      law = std::max(law, s->pair.worst_law());
    }
    const std::vector<double> a = dense.pair.tractions();
    for (KalkerSpheres* s : {&fft, &table}) worst = std::max(worst, largest_difference(a, s->pair.tractions()));
  }
  std::printf("three kinds of operators: tractions differ by %.1e (bound 1e-6), laws off by %.1e (1e-6)\n", worst, law);
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(law, 1e-6);
}

// A force that friction cannot carry, a load that is taken off, a solve that is stopped: the past stays.
TEST(TimeStep, failed_steps_leave_the_past) {
  KalkerSpheres s(16), twin(16);
  const auto step = [](KalkerSpheres& k, double share) {
    k.scene().prescribe(1, 2, -share * k.mu * k.load);
    k.scene().set_step(rolling_step, 0.5);
    return k.contact().solve();
  };
  for (KalkerSpheres* k : {&s, &twin}) {
    ASSERT_EQ(step(*k, 0.3), Status::ok);
    ASSERT_EQ(step(*k, 0.6), Status::ok);
  }
  EXPECT_THROW(step(s, 1.2), Error);
  s.scene().options.set_int("max_iterations", 1);
  EXPECT_EQ(step(s, 0.2), Status::not_converged);
  s.scene().options.set_int("max_iterations", 500);
  EXPECT_EQ(s.contact().stat("steps"), 2);
  ASSERT_EQ(step(s, 0.7), Status::ok);
  ASSERT_EQ(step(twin, 0.7), Status::ok);
  const double off = largest_difference(s.pair.tractions(), twin.pair.tractions());
  std::printf("after two failures: tractions off by %.1e (bound 1e-10)\n", off);
  EXPECT_LT(off, 1e-10);
  EXPECT_EQ(s.contact().stat("steps"), 3);
}

TEST(TimeStep, repeated_saved_restored_and_copied) {
  KalkerSpheres s(16), copy(16), other(14);
  s.scene().set_step(rolling_step, 0.5);
  copy.scene().set_step(rolling_step, 0.5);
  EXPECT_THROW(s.contact().repeat_step(), Error);
  EXPECT_THROW(s.contact().save_past(0, nullptr), Error);
  for (int k = 0; k < 5; ++k) {
    change_scene(s.scene(), k);
    ASSERT_GE(static_cast<int>(s.contact().solve()), 0);
  }
  std::vector<double> past(static_cast<std::size_t>(s.contact().save_past(0, nullptr)));
  const auto size = static_cast<std::int64_t>(past.size());
  EXPECT_THROW(s.contact().save_past(size - 1, past.data()), Error);
  ASSERT_EQ(s.contact().save_past(size, past.data()), size);
  const auto next = [](KalkerSpheres& k) {
    change_scene(k.scene(), 5);
    EXPECT_GE(static_cast<int>(k.contact().solve()), 0);
    return k.pair.tractions();
  };
  const std::vector<double> first = next(s);
  s.contact().repeat_step();
  EXPECT_THROW(s.contact().repeat_step(), Error);
  const double repeated = largest_difference(first, next(s));
  s.contact().restore_past(size, past.data());
  EXPECT_EQ(s.contact().save_past(0, nullptr), size);
  const double restored = largest_difference(first, next(s));
  change_scene(copy.scene(), 5);
  copy.contact().restore_past(size, past.data());
  const double copied = largest_difference(first, next(copy));
  std::printf("repeated, restored, copied: tractions off by %.1e, %.1e, %.1e (bound 1e-10)\n", repeated, restored,
              copied);
  for (const double off : {repeated, restored, copied}) EXPECT_LT(off, 1e-10);
  EXPECT_EQ(copy.contact().stat("steps"), 6);
  // Not on another frame, not when changed.
  change_scene(other.scene(), 0);
  EXPECT_THROW(other.contact().restore_past(size, past.data()), Error);
  std::vector<double> bad = past;
  bad[20] += 1e-9;
  EXPECT_THROW(copy.contact().restore_past(size, bad.data()), Error);
  bad = past;
  bad[1] = 99;
  EXPECT_THROW(copy.contact().restore_past(size, bad.data()), Error);
  EXPECT_THROW(copy.contact().restore_past(7, past.data()), Error);
  // The refusals left the past alone.
  copy.contact().repeat_step();
  EXPECT_LT(largest_difference(first, next(copy)), 1e-10);
}

// Half-spaces: the past goes along to a finer frame, or to one that follows the contact.
TEST(TimeStep, past_on_another_frame) {
  const auto rolled = [](bool change) {
    KalkerSpheres s(20, "dense");
    s.scene().options.set_real("accuracy", 1e-8);
    s.scene().set_creep(-1e-3, 3e-4, 0);
    s.scene().set_step(rolling_step, 0.5);
    for (int k = 0; k < 6; ++k) {
      if (change && k == 3) {
        const std::vector<double> lines = frames::uniform_lines(-4.25 * 1.1, 4.25 * 1.1, 22);
        s.pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
      }
      EXPECT_EQ(s.contact().solve(), Status::ok);
    }
    double f[3];
    s.contact().resultant(InAxes::local, f, nullptr);
    return std::array{f[0], f[1], f[2]};
  };
  const auto kept = rolled(false), changed = rolled(true);
  for (std::size_t c = 0; c < 3; ++c) {
    std::printf("force %zu: %.8e kept, %.8e on another frame from the fourth step on (bound 1e-5)\n", c, kept[c],
                changed[c]);
    EXPECT_NEAR(kept[c], changed[c], 1e-5 * std::abs(kept[2]));
  }
}

// A steady state is where steps may start, and a failed one is not.
TEST(TimeStep, from_a_steady_state) {
  KalkerSpheres s(16);
  s.scene().set_creep(-1e-3, 0, 0);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  double before[3], after[3];
  s.contact().resultant(InAxes::local, before, nullptr);
  s.scene().set_step(rolling_step, characteristic_step * 8.5 / 16);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  s.contact().resultant(InAxes::local, after, nullptr);
  std::printf("a step from the steady state changes the force by %.1e (bound 1e-6)\n", std::abs(after[0] / before[0] - 1));
  EXPECT_NEAR(after[0], before[0], 1e-6 * std::abs(before[0]));
  s.scene().set_step(0, 0);
  s.scene().options.set_int("max_iterations", 1);
  s.scene().set_creep(-3e-3, 1e-3, 1e-3);
  EXPECT_EQ(s.contact().solve(), Status::not_converged);
  s.scene().options.set_int("max_iterations", 500);
  s.scene().set_step(rolling_step, 0.3);
  EXPECT_THROW(s.contact().solve(), Error);
  s.contact().reset();
  EXPECT_EQ(s.contact().solve(), Status::ok);
}

// Derivatives of a step, the past held, against differences.
TEST(TimeStep, sensitivities) {
  KalkerSpheres s(16, "dense");
  s.scene().options.set_real("tolerance", 1e-13);
  s.scene().set_step(rolling_step, 0.5);
  for (int k = 0; k < 4; ++k) {
    change_scene(s.scene(), k);
    ASSERT_GE(static_cast<int>(s.contact().solve()), 0);
  }
  s.scene().prescribe(2, 2, 0.05);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  double force[3], creep[3];
  s.contact().sensitivity(Parameter::longitudinal, force, nullptr, nullptr, creep);
  const double h = 1e-7, at = s.scene().load(Direction::longitudinal).value;
  double f[2][3], c[2][3];
  for (int side = 0; side < 2; ++side) {
    s.contact().repeat_step();
    s.scene().prescribe(1, 1, at + (side == 0 ? -h : h));
    ASSERT_EQ(s.contact().solve(), Status::ok);
    s.contact().resultant(InAxes::local, f[side], nullptr);
    s.contact().motion(nullptr, c[side]);
  }
  const double by_force = (f[1][0] - f[0][0]) / (2 * h), by_creep = (c[1][1] - c[0][1]) / (2 * h);
  std::printf("dFx %.6e, by differences %.6e; dxi2 %.6e, %.6e (bound 1e-4)\n", force[0], by_force, creep[1], by_creep);
  EXPECT_NEAR(force[0], by_force, 1e-4 * std::abs(by_force));
  EXPECT_NEAR(creep[1], by_creep, 1e-4 * std::abs(by_creep) + 1e-6);
}

#if ROLLCON_BUILD_PROCEDURES
// The published procedures solve the same steps.
TEST(TimeStep, published_procedures) {
  const auto walk = [](const char* system, const char* jacobian) {
    KalkerSpheres s(10, "dense");
    s.scene().options.set_text("system", system);
    s.scene().options.set_text("jacobian", jacobian);
    s.scene().options.set_real("accuracy", 1e-8);
    s.scene().set_creep(-1e-3, 3e-4, 1e-4);
    s.scene().set_step(rolling_step, 0.5);
    for (int k = 0; k < 4; ++k) EXPECT_GE(static_cast<int>(s.contact().solve()), 0) << system << jacobian;
    return s.pair.tractions();
  };
  const std::vector<double> own = walk("condensed", "exact");
  for (const auto& [system, jacobian] : {std::pair{"condensed", "b_derivative"}, std::pair{"condensed", "simplified"},
                                         std::pair{"monolithic", "b_derivative"}}) {
    const double off = largest_difference(own, walk(system, jacobian));
    std::printf("%s, %s: tractions off by %.1e (bound 1e-6)\n", system, jacobian, off);
    EXPECT_LT(off, 1e-6);
  }
}
#endif

// Of a step: what the frame makes of the forces, the past being what it is.
TEST(TimeStep, error_estimate) {
  for (const char* operators : {"dense", "fft"}) {
    Spheres s(32, operators);
    s.scene().set_step(shift_step, 1);
    s.scene().set_creep(0.5 * s.shift(7.0 / 8), 0, 0);
    ASSERT_EQ(s.contact().solve(), Status::ok);
    const double exact = [&] {
      double low = 0, high = 1;
      for (int i = 0; i < 60; ++i) (s.shift((low + high) / 2) < 0.5 * s.shift(7.0 / 8) ? low : high) = (low + high) / 2;
      return low * s.mu * s.load;
    }();
    const double off = std::abs(std::abs(s.force()) / exact - 1), estimate = s.contact().stat("error_estimate");
    std::printf("%s: force off by %.2e of the closed form, estimate %.2e (bounds 0.2 and 20 times)\n", operators, off,
                estimate);
    EXPECT_GT(estimate, 0.2 * off);
    EXPECT_LT(estimate, std::max(20 * off, 0.01));
  }
}

}  // namespace
}  // namespace rollcon::contact_test
