/// Tests friction that falls with the slip speed: Coulomb's law where it does not fall, sliding in closed form,
/// branches, and the power that is lost.

#include <algorithm>
#include <cmath>

#include "contact/scene_fixture.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr const char* families[] = {"linear", "rational", "exponential"};
constexpr double speed = 100;

void set_law(Pair& pair, const char* law, const std::vector<double>& parameters) {
  pair.contact->scene.set_friction(law, static_cast<std::int32_t>(parameters.size()), parameters.data());
}

Pair pair_of(bool like) {
  Pair pair(1e4, 0.3, like ? 1e4 : 2e4, like ? 0.3 : 0.1);
  sharp_scene(pair);
  pair.contact->scene.set_speed(speed);
  return pair;
}

Vec3 force_of(const Pair& pair) {
  Vec3 force, moment;
  pair.contact->resultant(InAxes::local, force.data(), moment.data());
  return force;
}

double creep_of(const Pair& pair) {
  double approach = 0, creep[3];
  pair.contact->motion(&approach, creep);
  return creep[0];
}

// The law's speed grows, so that what friction loses falls like the slip over it, and so does the difference to
// Coulomb's law.
TEST(falling_friction_long, the_limit_of_a_vanishing_slope_is_coulombs_law) {
  for (const char* law : families)
    for (const bool like : {true, false}) {
      Pair coulomb = pair_of(like);
      coulomb.contact->solve();
      double last = 1;
      for (const double s1 : {1e2, 1e3, 1e4, 1e14}) {
        Pair falling = pair_of(like);
        set_law(falling, law, {0.1, 0.2, s1});
        falling.contact->solve();
        const double off = largest_difference(falling.tractions(), coulomb.tractions());
        std::printf("%s, s1 %.0e: tractions off Coulomb's by %.1e\n", law, s1, off);
        EXPECT_LE(falling.worst_law(), 1e-9);
        if (s1 > 1e13) {
          EXPECT_LE(off, 1e-10);
        } else {
          EXPECT_GT(off, 1e-8);
          if (last < 1) {
            EXPECT_NEAR(last / off, 10, 1.5);
          }
          last = off;
        }
      }
      Pair level = pair_of(like);
      set_law(level, law, {0.3, 0, 1});
      level.contact->solve();
      EXPECT_LE(largest_difference(level.tractions(), coulomb.tractions()), 1e-10);
    }
}

// Each node has the coefficient of the creepage where all nodes slide by far more than what elasticity adds.
TEST(falling_friction, sliding_has_the_coefficient_of_its_speed) {
  const double far = 50, s1 = 3000, s2 = 8000, slip = far * speed;
  const double wanted[] = {0.1 + 0.15 * std::max(0.0, 1 - slip / (2 * s1)) + 0.05 * std::max(0.0, 1 - slip / (2 * s2)),
                           0.1 + 0.15 / (1 + slip / s1) + 0.05 / (1 + slip * slip / (s2 * s2)),
                           0.1 + 0.15 * std::exp2(-slip / s1) + 0.05 * std::exp2(-slip / s2)};
  for (std::size_t i = 0; i < 3; ++i) {
    Pair pair = pair_of(true);
    set_law(pair, families[i], {0.1, 0.15, s1, 0.05, s2});
    pair.contact->scene.set_creep(far, 0, 0);
    pair.contact->solve();
    const Vec3 force = force_of(pair);
    const double off = force[0] / force[2] / wanted[i] - 1;
    std::printf("%s: coefficient off by %.1e (bound 1e-4)\n", families[i], off);
    EXPECT_LE(std::abs(off), 1e-4);
    std::vector<double> field(static_cast<std::size_t>(pair.contact->nodes()));
    pair.contact->field(Field::friction, InAxes::local, pair.contact->nodes(), field.data());
    const std::size_t middle = field.size() / 2;
    EXPECT_NEAR(field[middle], wanted[i], 1e-4 * wanted[i]);
  }
}

// A force below the greatest has two creepages: one that grows from stick, one on the falling side. The first is found
// from nothing, and from a solution on the falling side that side is kept; the plan says which.
TEST(falling_friction, branches_are_chosen_and_told) {
  for (const char* law : families) {
    Pair pair = pair_of(true);
    set_law(pair, law, {0.1, 0.2, 2});
    Scene& scene = pair.contact->scene;
    scene.set_creep(0.03, 0, 0);
    pair.contact->solve();
    const double force = force_of(pair)[0];
    scene.prescribe(1, 2, force);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double kept = creep_of(pair);
    EXPECT_NE(pair.contact->plan().find("continues the last solution"), std::string::npos);
    pair.contact->reset();
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double from_stick = creep_of(pair);
    EXPECT_NE(pair.contact->plan().find("begins with stick"), std::string::npos) << pair.contact->plan();
    const double off = std::abs(kept / 0.03 - 1);
    std::printf("%s: at a force of %.4f creepages %.6f (kept, off by %.1e, bound 1e-8) and %.6f (from stick)\n", law,
                force, kept, off, from_stick);
    EXPECT_LE(off, 1e-8);
    EXPECT_GT(from_stick, 0);
    EXPECT_LT(from_stick, 0.2 * kept);
    EXPECT_LE(pair.worst_law(), 1e-9);
    // The creepage that was found gives this force.
    scene.set_creep(from_stick, 0, 0);
    pair.contact->solve();
    EXPECT_NEAR(force_of(pair)[0], force, 1e-8 * std::abs(force));
  }
}

// There is no solution above the greatest force of the branch that begins with stick; below it there is one on the
// branch. A lateral force of nothing beside it makes it one of several loads, and the greatest is the same by symmetry.
TEST(falling_friction, forces_beyond_the_greatest_are_refused) {
  for (const char* law : families) {
    Pair pair = pair_of(true);
    set_law(pair, law, {0.1, 0.2, 0.5});
    Scene& scene = pair.contact->scene;
    double greatest = 0;
    for (int i = 1; i <= 80; ++i) {
      scene.set_creep(1e-4 * i, 0, 0);
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      greatest = std::min(greatest, force_of(pair)[0]);
    }
    for (const bool several : {false, true})
      for (const double part : {0.98, 1.02}) {
        scene.prescribe(1, 2, part * greatest);
        scene.prescribe(2, several ? 2 : 1, 0);
        pair.contact->reset();
        try {
          EXPECT_EQ(pair.contact->solve(), Status::ok) << pair.contact->plan();
          EXPECT_LT(part, 1) << "not refused";
          EXPECT_NEAR(force_of(pair)[0], part * greatest, 1e-8 * std::abs(greatest));
        } catch (const Error& e) {
          std::printf("%s, %s: greatest force %.4f, %s\n", law, several ? "two loads" : "one load", greatest, e.what());
          EXPECT_EQ(e.status(), Status::err_load);
          const std::string text = e.what();
          EXPECT_NE(text.find("begins with stick"), std::string::npos) << text;
          EXPECT_GT(part, 1);
          const std::size_t is = text.find(" is ");
          EXPECT_NEAR(std::stod(text.substr(is + 4)), part, 0.004) << text;
        }
      }
  }
}

// The creepage goes up and down: power is lost at every node, and without a jump both ways are the same.
TEST(falling_friction, a_closed_loop_gains_no_energy) {
  for (const char* law : families) {
    Pair pair = pair_of(false);
    set_law(pair, law, {0.1, 0.2, 2});
    std::vector<double> up;
    double least = 0, greatest = 0, off = 0;
    for (int i = 0; i <= 40; ++i) {
      const int step = i <= 20 ? i : 40 - i;
      pair.contact->scene.set_creep(5e-4 * step, -2e-4 * step, 1e-4 * step);
      ASSERT_EQ(pair.contact->solve(), Status::ok);
      std::vector<double> power(static_cast<std::size_t>(pair.contact->nodes()));
      pair.contact->field(Field::friction_power, InAxes::local, pair.contact->nodes(), power.data());
      least = std::min(least, *std::min_element(power.begin(), power.end()));
      greatest = std::max(greatest, *std::max_element(power.begin(), power.end()));
      const double force = force_of(pair)[0];
      if (i <= 20)
        up.push_back(force);
      else
        off = std::max(off, std::abs(force - up[static_cast<std::size_t>(step)]));
    }
    std::printf("%s: least power of a node %.1e of the greatest (bound -1e-12), forces down and up differ by %.1e\n",
                law, least / greatest, off);
    EXPECT_GE(least, -1e-12 * greatest);
    EXPECT_LE(off, 1e-8 * std::abs(up.back()));
  }
}

}  // namespace
}  // namespace rollcon
