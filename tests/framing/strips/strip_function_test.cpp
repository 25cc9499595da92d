/// Results on strips are functions of the scene: without jumps or memory, with derivatives that are their slopes.

#include <random>

#include "framing/strips/strip_families.hpp"

namespace rollcon::strips {
namespace {

/// A path of scenes, by s from 0 to 1.
struct Path {
  const char* name;
  FamilyGap::Kind kind;
  double first, last;  ///< parameter of the gap
  double load_first = 1e5, load_last = 1e5;
  double creep_first = 1e-3, creep_last = 1e-3;

  StripCase at(double t) const {
    StripCase test(kind, first + t * (last - first));
    test.scene.value = load_first + t * (load_last - load_first);
    test.scene.motion[0] = creep_first + t * (creep_last - creep_first);
    return test;
  }
};

const Path paths[] = {{"arcs", FamilyGap::arcs, -1.5, 2},
                      {"arcs, light", FamilyGap::arcs, -1.5, 2, 500, 500},
                      {"corner", FamilyGap::corner, -1.5, 2},
                      {"slanted pair that joins", FamilyGap::slanted_pair, 0.3, 2.8},
                      {"pair that joins", FamilyGap::apart, 5.5, 6.5},
                      {"birth of a second part", FamilyGap::pair, 2.5e-3, 2e-4},
                      {"rounded end, load", FamilyGap::rounded, 1e-4, 1e-4, 4e3, 1e5},
                      {"rounded end, tilt", FamilyGap::rounded, -2e-3, 2e-3},
                      {"load", FamilyGap::arcs, 0.3, 0.3, 2e3, 1.6e5},
                      {"creepage", FamilyGap::arcs, 0.3, 0.3, 1e5, 1e5, -3e-3, 3e-3}};

class Follower {
 public:
  std::array<double, 6> operator()(const Path& path, double t, bool warm = false) {
    StripCase test = path.at(t);
    const StripReport report = contact_.solve(test.now(), wide, {8, 12}, solution_, warm);
    EXPECT_EQ(report.status, StripStatus::solved) << path.name << " " << t;
    return components(StripContact::totals(solution_), test.scene.mu);
  }
  const StripSolution& solution() const { return solution_; }

 private:
  StripContact contact_;
  StripSolution solution_;
};

// Where third differences are largest the interval is halved towards the larger change.
TEST(strips_long, have_no_jumps_along_paths) {
  constexpr int steps = 24;
  for (const Path& path : paths) {
    Follower follow;
    std::vector<std::array<double, 6>> f;
    int parts = 1;
    double share = 1;
    for (int i = 0; i <= steps; ++i) {
      f.push_back(follow(path, static_cast<double>(i) / steps));
      parts = std::max(parts, follow.solution().strips.layout.parts);
      share = std::min(share, follow.solution().share);
    }
    double most = 0;
    int where = 1;
    for (int i = 1; i + 2 <= steps; ++i) {
      double size = 0;
      for (int k = 0; k < 6; ++k)
        size = std::max(size, std::abs(f[i + 2][k] - 3 * f[i + 1][k] + 3 * f[i][k] - f[i - 1][k]));
      if (size > most) most = size, where = i;
    }
    double a = static_cast<double>(where) / steps, b = static_cast<double>(where + 1) / steps;
    auto fa = f[where], fb = f[where + 1];
    for (int halving = 0; halving < 18; ++halving) {
      const double middle = (a + b) / 2;
      const auto fm = follow(path, middle);
      if (largest_difference(fa, fm) > largest_difference(fm, fb)) {
        b = middle;
        fb = fm;
      } else {
        a = middle;
        fa = fm;
      }
    }
    expect_error(std::string("jump along ") + path.name, largest_difference(fa, fb), 2e-6);
    const bool joins = path.kind == FamilyGap::apart || path.kind == FamilyGap::slanted_pair;
    EXPECT_EQ(parts, joins || path.kind == FamilyGap::pair ? 2 : 1) << path.name;
    EXPECT_EQ(share < 1, joins) << path.name;
  }
}

TEST(strips, forget_what_was_before) {
  std::mt19937 random(7);
  for (const Path& path : paths) {
    Follower cold, warm;
    double worst = 0;
    for (int i = 0; i <= 12; ++i) {
      // Small steps there and back, and leaps.
      const double t = i < 5 ? 0.1 * i : i < 9 ? 0.1 * (9 - i) : std::uniform_real_distribution<>(0, 1)(random);
      const auto found = warm(path, t, i > 0);
      worst = std::max(worst, largest_difference(found, cold(path, t)));
    }
    expect_error(std::string("cold and warm, ") + path.name, worst, 1e-8);
  }
}

TEST(strips, have_slopes_that_do_not_depend_on_the_step) {
  double worst = 0;
  for (const double s : {-0.9, 0.1, 1.3}) {
    std::array<double, 6> slope[3];
    constexpr double steps[] = {0.002, 0.04, 0.2};
    for (int i = 0; i < 3; ++i) {
      const Path path{"arcs", FamilyGap::arcs, s - steps[i] / 2, s + steps[i] / 2};
      Follower follow;
      const auto before = follow(path, 0), after = follow(path, 1);
      for (int k = 0; k < 6; ++k) slope[i][k] = (after[k] - before[k]) / steps[i];
    }
    double largest = 0;
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(slope[2][k]));
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(slope[i][k] - slope[2][k]) / largest);
  }
  expect_error("slopes over 0.002 and 0.04 beside 0.2 mm", worst, 1e-2);
}

TEST(strips, of_other_counts_agree) {
  double worst = 0;
  for (const Path& path : {paths[0], paths[3], paths[5]})
    for (const double t : {0.1, 0.5, 0.9}) {
      std::array<double, 6> first{};
      for (const StripCounts counts : {StripCounts{12, 20}, StripCounts{6, 10}, StripCounts{8, 12}}) {
        StripCase test = path.at(t);
        StripFinder finder;
        StripState state;
        ASSERT_EQ(finder.find(test.now(), wide, counts, state, false).status, StripStatus::solved) << path.name << t;
        const auto found = components(StripSolver::totals(state), test.scene.mu);
        if (counts.along == 12) first = found;
        if (counts.along == 8)
          for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(found[k] - first[k]));
      }
    }
  expect_error("forces of 8 x 12 beside 12 x 20", worst, 3e-3);
}

/// One of what is given, by number, moved by `by` of its size.
void move(StripCase& test, WavyFriction& friction, int which, double by) {
  if (which == 0) test.scene.value *= 1 + by;
  if (which == 1) test.scene.mu *= 1 + by;
  if (which > 1 && which < 5) test.scene.motion[which - 2] += by * std::abs(test.scene.motion[which - 2]);
  if (which == 5) test.gap.s += by * (test.gap.kind == FamilyGap::pair ? 0.01 : 1);
  if (which == 6) friction.part += by;
}

void expect_rates(FamilyGap::Kind kind, double s, const StripBodies& bodies, bool loads, bool approach) {
  StripCase test(kind, s, bodies);
  WavyFriction friction, by_part;
  by_part.by_part = true;
  test.scene.friction = &friction;
  if (loads) {
    test.scene.force_given = {true, false, true};
    test.scene.motion = {-4000, 3e-4, -20000};
  }
  StripFinder finder;
  StripState state;
  if (approach) {
    ASSERT_EQ(finder.find(test.now(), wide, {8, 12}, state, false).status, StripStatus::solved);
    test.scene.by_load = false;
    test.scene.value = state.approach;
  }
  ASSERT_EQ(finder.find(test.now(), wide, {8, 12}, state, false).status, StripStatus::solved);
  FamilyGap by_gap(kind, s);
  by_gap.by_parameter = true;
  StripParameter parameter[7];
  parameter[0].value = test.scene.value;
  parameter[1].mu = test.scene.mu;
  for (int k = 0; k < 3; ++k) parameter[2 + k].motion[k] = std::abs(test.scene.motion[k]);
  parameter[5].gap = &by_gap;
  parameter[6].friction = &by_part;
  StripTotals rate[7];
  ASSERT_TRUE(finder.rates(test.now(), state, parameter, rate));
  double worst = 0;
  for (int q = 0; q < 7; ++q) {
    constexpr double step = 2e-4;
    StripTotals moved[4];
    for (int i = 0; i < 4; ++i) {
      StripCase other = test;
      WavyFriction wavy = friction;
      other.scene.friction = &wavy;
      move(other, wavy, q, (i == 0 ? -2 : i == 1 ? -1 : i == 2 ? 1 : 2) * step);
      StripState there = state;
      ASSERT_EQ(finder.find(other.now(), wide, {8, 12}, there, true).status, StripStatus::solved);
      moved[i] = StripSolver::totals(there);
    }
    const auto numbers = [](const StripTotals& t) {
      return std::array<double, 10>{t.force[0] / 3e4,   t.force[1] / 3e4,   t.force[2] / 2e5,   t.load / 1e5,
                                    t.approach / 0.05,  t.pressed[0] / 1e6, t.pressed[1] / 1e6, t.motion[0] / 1e-3,
                                    t.motion[1] / 1e-3, t.motion[2] / 1e-3};
    };
    const auto exact = numbers(rate[q]);
    double error = 0, largest = 0;
    for (int k = 0; k < 10; ++k) {
      double d = 8 * (numbers(moved[2])[k] - numbers(moved[1])[k]) - (numbers(moved[3])[k] - numbers(moved[0])[k]);
      d /= 12 * step * (q == 5 && kind == FamilyGap::pair ? 0.01 : 1);
      error = std::max(error, std::abs(d - exact[k]));
      largest = std::max(largest, std::abs(d));
    }
    worst = std::max(worst, error / largest);
  }
  expect_error(std::string("derivatives of family ") + std::to_string(kind) + (bodies.ck != 0 ? ", on rigid" : "") +
                   (loads ? ", loads given" : "") + (approach ? ", approach given" : ""),
               worst, 1e-6);
}

TEST(strips, have_derivatives_that_are_their_slopes) {
  for (const auto& [kind, s] : {std::pair{FamilyGap::ellipse, 0.2},
                                {FamilyGap::arcs, 0.3},
                                {FamilyGap::corner, 0.3},
                                {FamilyGap::slanted_pair, 1.1},
                                {FamilyGap::pair, 7e-4}}) {
    expect_rates(kind, s, equal_bodies(), false, false);
    expect_rates(kind, s, on_rigid(), kind == FamilyGap::corner, kind == FamilyGap::arcs);
  }
  expect_rates(FamilyGap::arcs, -0.7, equal_bodies(), true, false);
  expect_rates(FamilyGap::pair, 7e-4, equal_bodies(), true, true);
}

// In the middle of a neck both strips and neighbours count.
TEST(strips, have_derivatives_at_a_neck) {
  const Path path{"pair", FamilyGap::apart, 0, 1};
  double worst = 0;
  for (const double s : {5.83, 5.94, 6.02}) {
    StripContact contact;
    StripSolution solution;
    StripCase test(FamilyGap::apart, s);
    ASSERT_EQ(contact.solve(test.now(), wide, {8, 12}, solution, false).status, StripStatus::solved);
    EXPECT_LT(solution.share, 0.9) << s;
    FamilyGap by_gap(FamilyGap::apart, s);
    by_gap.by_parameter = true;
    StripParameter parameter;
    parameter.gap = &by_gap;
    StripTotals rate;
    ASSERT_TRUE(contact.rates(test.now(), solution, {&parameter, 1}, {&rate, 1}));
    Follower follow;
    constexpr double step = 1e-4;
    const auto before = follow(path, s - step), after = follow(path, s + step);
    const double limit = 0.3 * 1e5;
    for (int k = 0; k < 2; ++k) {
      const double slope = (after[k] - before[k]) / (2 * step);
      worst = std::max(worst, std::abs(rate.force[k] / limit - slope) / std::abs((after[0] - before[0]) / (2 * step)));
    }
  }
  expect_error("derivatives at a neck", worst, 1e-4);
}

}  // namespace
}  // namespace rollcon::strips
