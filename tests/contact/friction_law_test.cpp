/// Tests every friction law that callers may name: its derivative against finite differences, its fixed points, what it
/// admits, and its solution at one node.

#include "contact/laws/friction_law.hpp"

#include <string>
#include <vector>

#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double mu = 0.4;

// Returns the residual lambda_t - P(lambda_t - s), with the slip already scaled.
std::array<double, 2> residual(const FrictionLaw& law, const double (&x)[5]) {
  const FrictionTraction t = law.traction({mu, -x[2], x[0], x[1], x[3], x[4], 1});
  return {x[0] - t.t1, x[1] - t.t2};
}

struct Tried {
  std::string name;
  GivenFriction given;
  const FrictionLaw& law() const { return given.law ? *given.law : coulomb(); }
};

/// Returns every law that has a name, with plausible parameters.
std::vector<Tried> tried() {
  const std::vector<std::pair<const char*, std::vector<double>>> parameters = {
      {"coulomb", {mu}},
      {"orthotropic", {mu, 0.5 * mu, 0.5}},
      {"orthotropic", {0.2 * mu, mu, -1.2}},
      {"orthotropic", {mu, mu, 0.7}},
      {"orthotropic_collinear", {mu, 0.5 * mu, 0.5}},
      {"orthotropic_collinear", {0.2 * mu, mu, -1.2}},
      {"linear", {0.4 * mu, 0.6 * mu, 2.0}},
      {"rational", {0.4 * mu, 0.3 * mu, 2.0, 0.3 * mu, 5.0}},
      {"exponential", {0.4 * mu, 0.6 * mu, 3.0}},
      {"exponential", {mu, 0, 1}},
      {"temperature", {0, mu, 1, 0.5 * mu}},
  };
  std::vector<Tried> all;
  for (const LawName& name : law_names()) {
    const std::size_t before = all.size();
    for (const auto& [law, values] : parameters)
      if (std::string(law) == name.name) all.push_back({law, name.make(values)});
    EXPECT_GT(all.size(), before) << name.name << " is not tried";
  }
  return all;
}

TEST(friction_law, linearisation_is_the_derivative_of_the_projection) {
  for (const Tried& each : tried()) {
    const FrictionLaw* law = &each.law();
    const char* name = each.name.c_str();
    frames::Random random(3);
    double worst = 0;
    int sliding = 0, trials = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const double x[5] = {random(), random(), -1.5 - random(), 2 * random(), 2 * random()};
      const FrictionPoint point{mu, -x[2], x[0], x[1], x[3], x[4], 1};
      const FrictionTraction there = law->traction(point);
      if (std::abs(there.length - there.bound) < 1e-3) continue;
      const TangentialLaw row = law->linearise(point, true);
      EXPECT_EQ(row.sliding, there.sliding);
      sliding += row.sliding;
      ++trials;
      constexpr double h = 1e-6;
      for (int column = 0; column < 5; ++column) {
        double plus[5], minus[5];
        for (int k = 0; k < 5; ++k) plus[k] = minus[k] = x[k];
        plus[column] += h;
        minus[column] -= h;
        const auto up = residual(*law, plus), down = residual(*law, minus);
        for (std::size_t i = 0; i < 2; ++i) {
          const double found = (up[i] - down[i]) / (2 * h);
          // A sticking node's rows may be any that make the slip vanish.
          if (!row.sliding && column > 2) continue;
          const double exact = column < 3 ? row.own[i][column] : row.slip[i][column - 3];
          worst = std::max(worst, std::abs(found - exact));
        }
      }
    }
    std::printf("%s: derivative off by %.1e (bound 1e-8), %d of %d points slide\n", name, worst, sliding, trials);
    EXPECT_LT(worst, 1e-8);
    EXPECT_GT(sliding, trials / 4);
    EXPECT_LT(sliding, trials);
  }
}

TEST(friction_law, a_fixed_point_satisfies_the_linearised_row) {
  for (const Tried& each : tried()) {
    const FrictionLaw* law = &each.law();
    const char* name = each.name.c_str();
    frames::Random random(5);
    double worst = 0;
    for (int trial = 0; trial < 100; ++trial) {
      // The traction slides against its slip.
      const double ln = -2 - random();
      const FrictionTraction t = law->traction({mu, -ln, 40 * random(), 40 * random()});
      if (!t.sliding) continue;
      const auto e = law->against({mu, -ln, t.t1, t.t2});
      const double slip = 1.5 + random(), s1 = -slip * e[0], s2 = -slip * e[1];
      // The factor is what friction that falls with slip leaves of the traction.
      const double less = law->coefficient({mu, -ln, t.t1, t.t2, s1, s2}) / law->coefficient({mu, -ln, 0, 0, 0, 0});
      for (const bool follows : {true, false}) {
        const TangentialLaw row = law->linearise({mu, -ln, less * t.t1, less * t.t2, s1, s2, 1}, follows);
        for (int i = 0; i < 2; ++i)
          worst = std::max(worst, std::abs(less * (row.own[i][0] * t.t1 + row.own[i][1] * t.t2) + row.own[i][2] * ln +
                                           row.slip[i][0] * s1 + row.slip[i][1] * s2 - row.constant[i]));
      }
    }
    std::printf("%s: fixed points off by %.1e (bound 1e-14)\n", name, worst);
    EXPECT_LT(worst, 1e-14);
  }
}

// Tractions lie in the image of the unit disk, and reach as far as it does.
TEST(friction_law, capacity_bounds_tractions_and_is_reached) {
  for (const Tried& each : tried()) {
    const FrictionLaw* law = &each.law();
    const char* name = each.name.c_str();
    const double pressure = 3;
    const auto m = law->capacity(mu, pressure);
    double beyond = 0, short_of = 0;
    for (int i = 0; i < 64; ++i) {
      const double s1 = std::cos(0.1 * i), s2 = std::sin(0.1 * i);
      const double most = std::hypot(m[0][0] * s1 + m[1][0] * s2, m[0][1] * s1 + m[1][1] * s2);
      double found = 0;
      for (int j = 0; j < 2880; ++j) {
        const double angle = j * 0.00218166;
        const FrictionTraction t = law->traction({mu, pressure, 100 * std::cos(angle), 100 * std::sin(angle)});
        found = std::max(found, t.t1 * s1 + t.t2 * s2);
      }
      beyond = std::max(beyond, found / most - 1);
      short_of = std::max(short_of, 1 - found / most);
    }
    std::printf("%s: power beyond the capacity %.1e (bound 1e-12), short of it %.1e (bound 1e-4)\n", name, beyond,
                short_of);
    EXPECT_LT(beyond, 1e-12);
    EXPECT_LT(short_of, 1e-4);
  }
}

// Friction falls from nothing: all parameters are 0 except the speed.
TEST(friction_law, laws_without_friction_are_numbers) {
  for (const LawName& name : law_names()) {
    if (std::string(name.parameters).find("s1") == std::string::npos) continue;
    std::vector<double> parameters(static_cast<std::size_t>(name.least), 0.0);
    parameters.back() = 1;
    const GivenFriction given = name.make(parameters);
    EXPECT_EQ(given.mu, 0) << name.name;
    const FrictionTraction t = given.law->traction({0, 1, 0.1, 0, 0.5, 0, 1});
    EXPECT_EQ(std::hypot(t.t1, t.t2), 0) << name.name;
    EXPECT_EQ(given.law->coefficient({0, 1, 0, 0, 0.5, 0}), 0) << name.name;
  }
}

TEST(friction_law, no_friction_means_no_traction) {
  const TangentialLaw law = coulomb().linearise({0, 0, 0, 0}, true);
  EXPECT_TRUE(law.sliding);
  EXPECT_EQ(law.own[0][0], 1);
  EXPECT_EQ(law.own[1][1], 1);
  EXPECT_EQ(law.slip[0][0], 0);
}

}  // namespace
}  // namespace rollcon
