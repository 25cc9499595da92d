// Tests the past of time steps: changed scenes, failures, repetition, saving, other frames, derivatives.

#include <array>

#include "contact/time_step_case.hpp"

namespace rollcon::contact_test {
namespace {

TEST(TimeStep_long, everything_changes_from_step_to_step) {
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

// The past stays after a force that friction cannot carry, a load that is taken off, and a solve that is stopped.
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

TEST(TimeStep, the_past_of_other_bodies_is_refused) {
  KalkerSpheres s(16), stiffer(16);
  s.scene().set_step(rolling_step, 0.5);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  std::vector<double> past(static_cast<std::size_t>(s.contact().past_get(0, nullptr)));
  const auto size = static_cast<std::int64_t>(past.size());
  s.contact().past_get(size, past.data());
  stiffer.pair.body2->set_elastic(1, 5, 0.28);
  try {
    stiffer.contact().past_set(size, past.data());
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_argument);
    EXPECT_NE(std::string(error.what()).find("bodies of other kinds, elastic constants"), std::string::npos)
        << error.what();
  }
}

TEST(TimeStep, repeated_saved_restored_and_copied) {
  KalkerSpheres s(16), copy(16), other(14);
  s.scene().set_step(rolling_step, 0.5);
  copy.scene().set_step(rolling_step, 0.5);
  EXPECT_THROW(s.contact().repeat_step(), Error);
  EXPECT_THROW(s.contact().past_get(0, nullptr), Error);
  for (int k = 0; k < 5; ++k) {
    change_scene(s.scene(), k);
    ASSERT_GE(static_cast<int>(s.contact().solve()), 0);
  }
  std::vector<double> past(static_cast<std::size_t>(s.contact().past_get(0, nullptr)));
  const auto size = static_cast<std::int64_t>(past.size());
  EXPECT_THROW(s.contact().past_get(size - 1, past.data()), Error);
  ASSERT_EQ(s.contact().past_get(size, past.data()), size);
  const auto next = [](KalkerSpheres& k) {
    change_scene(k.scene(), 5);
    EXPECT_GE(static_cast<int>(k.contact().solve()), 0);
    return k.pair.tractions();
  };
  const std::vector<double> first = next(s);
  s.contact().repeat_step();
  EXPECT_THROW(s.contact().repeat_step(), Error);
  const double repeated = largest_difference(first, next(s));
  s.contact().past_set(size, past.data());
  EXPECT_EQ(s.contact().past_get(0, nullptr), size);
  const double restored = largest_difference(first, next(s));
  change_scene(copy.scene(), 5);
  copy.contact().past_set(size, past.data());
  const double copied = largest_difference(first, next(copy));
  std::printf("repeated, restored, copied: tractions off by %.1e, %.1e, %.1e (bound 1e-10)\n", repeated, restored,
              copied);
  for (const double off : {repeated, restored, copied}) EXPECT_LT(off, 1e-10);
  EXPECT_EQ(copy.contact().stat("steps"), 6);
  // The past fits neither another frame nor a changed one.
  change_scene(other.scene(), 0);
  EXPECT_THROW(other.contact().past_set(size, past.data()), Error);
  std::vector<double> bad = past;
  bad[20] += 1e-9;
  EXPECT_THROW(copy.contact().past_set(size, bad.data()), Error);
  bad = past;
  bad[1] = 99;
  EXPECT_THROW(copy.contact().past_set(size, bad.data()), Error);
  EXPECT_THROW(copy.contact().past_set(7, past.data()), Error);
  // The refusals left the past alone.
  copy.contact().repeat_step();
  EXPECT_LT(largest_difference(first, next(copy)), 1e-10);
}

// The past of half-spaces goes along to a finer frame, or to one that follows the contact.
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

// Steps may start from a steady state, not from a failed one.
TEST(TimeStep, from_a_steady_state) {
  KalkerSpheres s(16);
  s.scene().set_creep(-1e-3, 0, 0);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  double before[3], after[3];
  s.contact().resultant(InAxes::local, before, nullptr);
  s.scene().set_step(rolling_step, characteristic_step * 8.5 / 16);
  ASSERT_EQ(s.contact().solve(), Status::ok);
  s.contact().resultant(InAxes::local, after, nullptr);
  std::printf("a step from the steady state changes the force by %.1e (bound 1e-6)\n",
              std::abs(after[0] / before[0] - 1));
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

// Derivatives of a step, with the past held, agree with differences.
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
    s.scene().options.set_procedure(("system=" + std::string(system) + " jacobian=" + jacobian).c_str());
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

// The error of a step is what the frame makes of the forces, with the past unchanged.
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
