/// Tests warm starts that go on along the line of the last change.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "support/steady_rolling.hpp"

namespace rollcon {
namespace {

using scenes::RollingPair;
namespace steady_rolling = scenes::steady_rolling;

constexpr std::int64_t on = 2, off = 1;  // values of warm_start
const closed_forms::Elastic soft{.shear = 41000, .poisson = 0.45};

struct Work {
  double iterations = 0, predictions = 0, fallbacks = 0, force = 0;
};

/// Varies load, creepages and spin slowly, each with a period of its own.
Work time_loop(const closed_forms::Elastic& body2, std::int64_t warm_start) {
  RollingPair pair(steady_rolling::steel, body2, 1);
  steady_rolling::prepare(pair, steady_rolling::grid(11), "b");
  pair.option("warm_start", warm_start).option("tolerance", 1e-8);
  Work work;
  for (int k = 0; k < 150; ++k) {
    const double t = 0.002 * k;
    pair.load(0.8 * steady_rolling::hertz.load * (1 + 0.2 * std::sin(9 * t)));
    pair.creep(steady_rolling::creepage * std::sin(1 + 5 * t), 0.3 * steady_rolling::creepage * std::cos(3 * t),
               steady_rolling::spin * std::sin(2 * t + 1));
    EXPECT_GE(pair.solve(), 0);
    if (k < 3) continue;
    work.iterations += pair.stat("iterations");
    work.predictions += pair.stat("predictions");
    work.fallbacks += pair.stat("fallbacks");
  }
  work.force = pair.solution().force[0];
  return work;
}

TEST(prediction, saves_iterations_of_a_time_loop) {
  for (const auto& [name, body2] : {std::pair{"identical", steady_rolling::steel}, {"dissimilar", soft}}) {
    const Work plain = time_loop(body2, off), predicted = time_loop(body2, on);
    const double change = std::abs(predicted.force / plain.force - 1);
    std::printf(
        "%s bodies: %.2f iterations per step, %.2f with prediction (bounds 3 and 0.8 of the other), %g predicted "
        "starts; forces differ by %.1e (bound 1e-6)\n",
        name, plain.iterations / 147, predicted.iterations / 147, predicted.predictions, change);
    EXPECT_LE(predicted.iterations, 3 * 147);
    EXPECT_LE(predicted.iterations, 0.9 * plain.iterations);
    EXPECT_EQ(plain.predictions, 0);
    EXPECT_GE(predicted.predictions, 140);
    EXPECT_LE(predicted.fallbacks, plain.fallbacks);
    EXPECT_LT(change, 1e-6);
  }
}

TEST(prediction, nothing_is_predicted_off_the_line) {
  RollingPair pair(steady_rolling::steel, soft, 1);
  steady_rolling::prepare(pair, steady_rolling::grid(11), "a");
  const double xi = steady_rolling::creepage;
  const auto predictions = [&](double along, double across) {
    pair.creep(along, across, 0);
    EXPECT_GE(pair.solve(), 0);
    return pair.stat("predictions");
  };
  EXPECT_EQ(predictions(0.30 * xi, 0), 0) << "cold";
  EXPECT_EQ(predictions(0.31 * xi, 0), 0) << "one solution before";
  EXPECT_EQ(predictions(0.32 * xi, 0), 1) << "the same change again";
  EXPECT_EQ(predictions(0.32 * xi, 0), 0) << "no change";
  EXPECT_EQ(predictions(0.33 * xi, 0), 0) << "none before this one";
  EXPECT_EQ(predictions(0.33 * xi, 0.01 * xi), 0) << "across the last change";
  EXPECT_EQ(predictions(0.33 * xi, 0.02 * xi), 1);
  pair.option("convection", "least_squares");
  EXPECT_EQ(predictions(0.33 * xi, 0.03 * xi), 0) << "other operators";
  pair.reset();
  EXPECT_EQ(predictions(0.33 * xi, 0.04 * xi), 0) << "cold again";
}

TEST(prediction, going_back_finds_the_solution_before_the_last) {
  RollingPair pair(steady_rolling::steel, soft, 1);
  steady_rolling::prepare(pair, steady_rolling::grid(11), "b");
  pair.solve();
  pair.load(1.01 * steady_rolling::hertz.load);
  pair.solve();
  EXPECT_GT(pair.stat("iterations"), 0);
  pair.load(steady_rolling::hertz.load);
  pair.solve();
  EXPECT_EQ(pair.stat("predictions"), 1);
  EXPECT_EQ(pair.stat("iterations"), 0);
}

}  // namespace
}  // namespace rollcon
