// Tests that what is asked between two solves does not change the next one: slips that nobody asked for are computed
// where a predicted start needs them.

#include "support/steady_rolling.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using scenes::RollingPair;
namespace steady_rolling = scenes::steady_rolling;

const closed_forms::Elastic soft{.shear = 41000, .poisson = 0.45};

struct Work {
  double iterations = 0, predictions = 0, force = 0;
};

/// The load grows, and with it the contact, by nodes whose slip was not needed before.
Work growing_load(const closed_forms::Elastic& body2, double step, const char* scheme, bool ask) {
  RollingPair pair(steady_rolling::steel, body2, 1);
  steady_rolling::prepare(pair, steady_rolling::grid(17), "a");
  pair.creep(0.5 * steady_rolling::creepage, 0.1 * steady_rolling::creepage, 0);
  pair.option("operators", "dense").option("convection", scheme);
  Work work;
  for (int k = 0; k < 6; ++k) {
    pair.load(0.2 * (1 + step * k) * steady_rolling::hertz.load);
    EXPECT_GE(pair.solve(), 0);
    work.iterations += pair.stat("iterations");
    work.predictions += pair.stat("predictions");
    // This statistic needs the slip of every node.
    if (ask) {
      EXPECT_LT(pair.stat("law_slip"), 1e-8);
    }
  }
  work.force = pair.solution().force[0];
  return work;
}

TEST(prediction_long, is_the_same_whatever_was_asked_before) {
  for (const auto& [name, body2] : {std::pair{"identical", steady_rolling::steel}, {"dissimilar", soft}})
    for (const char* scheme : {"characteristic", "godunov"})
      for (const double step : {0.02, 0.1, 0.3}) {
        const Work plain = growing_load(body2, step, scheme, false), asked = growing_load(body2, step, scheme, true);
        const double change = std::abs(asked.force / plain.force - 1);
        std::printf(
            "%s bodies, %s, load in steps of %g: %g iterations and %g predicted starts, %g and %g after questions; "
            "forces differ by %.1e (bound 1e-9)\n",
            name, scheme, step, plain.iterations, plain.predictions, asked.iterations, asked.predictions, change);
        EXPECT_EQ(plain.iterations, asked.iterations);
        EXPECT_EQ(plain.predictions, asked.predictions);
        EXPECT_LT(change, 1e-9);
      }
}

}  // namespace
}  // namespace rollcon
