/// Tests friction with a length of slip to follow its speed: the equation along lines, its limits, and what is refused.

#include <algorithm>
#include <cmath>

#include "contact/scene_fixture.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double speed = 100, at_rest = 0.3;
constexpr int nodes = 15;  // nodes along a side of the frame, lines along x
constexpr double spacing = 2.6 / 14;

Pair pair_of(const char* law, double s1) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  sharp_scene(pair);
  Scene& s = pair.contact->scene;
  s.options.set_real("tolerance", 1e-12);
  s.set_speed(speed);
  const double parameters[] = {0.1, 0.2, s1};
  s.set_friction(law, 3, parameters);
  return pair;
}

std::vector<double> field_of(const Pair& pair, Field field) {
  std::vector<double> v(static_cast<std::size_t>(pair.contact->field(field, InAxes::local, 0, nullptr)));
  pair.contact->field(field, InAxes::local, static_cast<std::int64_t>(v.size()), v.data());
  return v;
}

// All nodes slide with one speed: mu falls from that at rest to that of the speed exponentially with the distance.
TEST(friction_memory, sliding_in_closed_form) {
  for (const char* law : {"linear", "rational", "exponential"}) {
    const double slip = 500 * speed, s1 = 30000, length = 200;
    Pair pair = pair_of(law, s1);
    pair.contact->scene.set_creep(500, 0, 0);
    pair.contact->scene.set_friction_memory(length, 1);
    ASSERT_EQ(pair.contact->solve(), Status::ok) << pair.contact->plan();
    const double end = law[0] == 'l'   ? 0.1 + 0.2 * std::max(0.0, 1 - slip / (2 * s1))
                       : law[0] == 'r' ? 0.1 + 0.2 / (1 + slip / s1)
                                       : 0.1 + 0.2 * std::exp2(-slip / s1);
    const std::vector<double> mu = field_of(pair, Field::friction), p = field_of(pair, Field::pressure);
    const double falls = std::exp(-slip * spacing / (speed * length));
    double worst = 0;
    int steps = 0;
    for (std::size_t k = 0; k + 1 < mu.size(); ++k) {  // node k + 1 is upstream of node k
      if ((k + 1) % nodes == 0 || !(p[k] > 0) || !(p[k + 1] > 0)) continue;
      worst = std::max(worst, std::abs((mu[k] - end) / (mu[k + 1] - end) / falls - 1));
      ++steps;
    }
    std::printf("%s: mu over %d spacings off by %.1e of what is left of its fall (bound 5e-4; elastic slip)\n", law,
                steps, worst);
    EXPECT_GT(steps, 50);
    EXPECT_LE(worst, 5e-4);
  }
}

// The coefficients are those of the slip that is found: the equation is solved again, by small steps along each line.
TEST(friction_memory, coefficients_belong_to_the_solution) {
  for (const char* law : {"linear", "rational", "exponential"}) {
    const double s1 = 0.5, length = 1e-3, least = 0.02;
    Pair pair = pair_of(law, s1);
    pair.contact->scene.set_creep(-6e-3, 2e-3, 2e-3);
    pair.contact->scene.set_friction_memory(length, least);
    ASSERT_EQ(pair.contact->solve(), Status::ok) << pair.contact->plan();
    const std::vector<double> mu = field_of(pair, Field::friction), p = field_of(pair, Field::pressure);
    const std::vector<double> s = field_of(pair, Field::slip);
    const auto steady = [&](double slip) {
      return law[0] == 'l'   ? 0.1 + 0.2 * std::max(0.0, 1 - slip / (2 * s1))
             : law[0] == 'r' ? 0.1 + 0.2 / (1 + slip / s1)
                             : 0.1 + 0.2 * std::exp2(-slip / s1);
    };
    double worst = 0, lowest = 1;
    for (std::size_t j = 0; j < nodes; ++j) {
      double now = at_rest;
      for (std::size_t i = nodes - 1; i-- > 0;) {
        const std::size_t k = j * nodes + i, up = k + 1;
        if (!(p[k] > 0)) {
          now = at_rest;
          continue;
        }
        const double from = std::hypot(s[2 * up], s[2 * up + 1]), to = std::hypot(s[2 * k], s[2 * k + 1]);
        constexpr int parts = 400;
        const double time = (p[up] > 0 ? 1 : 0.5) * spacing / speed / parts,
                     rate = std::max(0.5 * (from + to), least) / length;
        for (int part = 0; part < parts; ++part) {
          const double at = (part + 0.5) / parts, wanted = (1 - at) * steady(from) + at * steady(to);
          now = wanted + (now - wanted) * std::exp(-rate * time);
        }
        worst = std::max(worst, std::abs(mu[k] - now) * p[k]);
        lowest = std::min(lowest, mu[k]);
      }
    }
    worst /= at_rest * *std::max_element(p.begin(), p.end());
    std::printf("%s: least coefficient %.3f, bounds off by %.1e (bound 1e-5), %g rounds, %g iterations\n", law, lowest,
                worst, pair.contact->stat("friction_rounds"), pair.contact->stat("iterations"));
    EXPECT_LE(worst, 1e-5);
    EXPECT_LT(lowest, 0.25);
    EXPECT_LE(pair.worst_law(), 1e-8);
    EXPECT_LE(pair.contact->stat("friction_change"), 1e-11);
    EXPECT_NE(pair.contact->plan().find("length of slip"), std::string::npos);
  }
}

TEST(friction_memory, limits_of_the_length) {
  Pair without = pair_of("exponential", 3), coulomb = pair_of("exponential", 3);
  without.contact->solve();
  const double mu = at_rest;
  coulomb.contact->scene.set_friction("coulomb", 1, &mu);
  coulomb.contact->solve();
  double before = 0;
  for (const double length : {1e-5, 1e-6, 1e-7}) {
    Pair pair = pair_of("exponential", 3);
    pair.contact->scene.set_friction_memory(length, 3);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const double off = largest_difference(pair.tractions(), without.tractions());
    std::printf("length %.0e: tractions off those without memory by %.1e, %g rounds\n", length, off,
                pair.contact->stat("friction_rounds"));
    if (before > 0) {
      EXPECT_NEAR(before / off, 10, 1);
    }
    before = off;
  }
  Pair pair = pair_of("exponential", 3);
  pair.contact->scene.set_friction_memory(1e12, 0);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  const double off = largest_difference(pair.tractions(), coulomb.tractions());
  std::printf("without end: off Coulomb's by %.1e (bound 1e-10)\n", off);
  EXPECT_LE(off, 1e-10);
  pair.contact->scene.set_friction_memory(0, 5);
  pair.contact->solve();
  EXPECT_LE(largest_difference(pair.tractions(), without.tractions()), 1e-10);
  EXPECT_EQ(pair.contact->stat("friction_rounds"), 0);
}

// A force is carried with the coefficients that belong to it, from nothing and from the last solution alike.
TEST(friction_memory, prescribed_force) {
  Pair pair = pair_of("exponential", 1);
  Scene& s = pair.contact->scene;
  s.set_friction_memory(1e-3, 0.02);
  s.set_creep(4e-3, 0, 0);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  double force[3], approach = 0, creep[3];
  pair.contact->resultant(InAxes::local, force, nullptr);
  s.prescribe(1, 2, force[0]);
  for (const bool cold : {false, true}) {
    if (cold) pair.contact->reset();
    ASSERT_EQ(pair.contact->solve(), Status::ok) << pair.contact->plan();
    pair.contact->motion(&approach, creep);
    // Nothing is left of the last solution's coefficients.
    if (cold) {
      EXPECT_GT(pair.contact->stat("friction_rounds"), 2);
    }
    std::printf("%s: creepage off by %.1e (bound 1e-8)\n", cold ? "from nothing" : "warm", creep[0] / 4e-3 - 1);
    EXPECT_NEAR(creep[0], 4e-3, 4e-11);
  }
  s.prescribe(1, 2, 10 * force[0]);
  EXPECT_THROW(pair.contact->solve(), Error);
  s.prescribe(1, 2, force[0]);
  EXPECT_EQ(pair.contact->solve(), Status::ok);
}

// The curve is CONTACT's creep-force curve of a locomotive's wheel with friction that falls, a memory and a soft layer
// (G = 82000, 44 x 44 elements; the speed, 10 m/s, is the one that fits the greatest creepage).
TEST(friction_memory, published_creep_force_curve) {
  constexpr double load = 106700, mu = 0.33, exact[3][2] = {{1e-3, 0.1825}, {5e-3, 0.7029}, {1.6e-2, 0.9445}};
  Pair pair(2 * 82000 * 1.28, 0.28, 2 * 82000 * 1.28, 0.28);
  const double a = 6.3036 * 1.06;
  pair.frame(frames::rectangle(ElementType::quad4, frames::uniform_lines(-a, a, 44),
                               frames::uniform_lines(-2 * a, 2 * a, 44)));
  Scene& s = pair.contact->scene;
  s.set_gap_quadratic(0.0008, 0.0002814173138, 0);
  s.prescribe(3, 2, load);
  s.set_speed(10e3);
  const double parameters[] = {0.14, 0.19, 1250};
  s.set_friction("exponential", 3, parameters);
  s.set_friction_memory(0.003, 0);
  s.set_layer(1.25 / 8200);
  for (const auto& [creep, wanted] : exact) {
    s.set_creep(creep, 0, 0);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    double force[3];
    pair.contact->resultant(InAxes::local, force, nullptr);
    const double found = -force[0] / (mu * load);
    std::printf("creepage %g: force %.4f of friction at rest, published %.4f: %+.2f %% (bound 1 %%)\n", creep, found,
                wanted, 100 * (found / wanted - 1));
    EXPECT_NEAR(found, wanted, 0.01 * wanted);
  }
}

// Every law looks at the scene alone, not at how its axes lie in space, so rounding decides nothing.
TEST(friction_memory, turned_in_space) {
  enum class With { nothing, memory, heat, yield };
  struct Case {
    const char* law;
    std::vector<double> parameters;
    With with;
  };
  const std::vector<double> falling{0.1, 0.2, 0.2};
  for (const Case& c :
       {Case{"coulomb", {0.3}, With::nothing}, Case{"coulomb", {0.3}, With::yield},
        Case{"orthotropic", {0.3, 0.2, 0.4}, With::nothing},
        Case{"orthotropic_collinear", {0.3, 0.2, 0.4}, With::nothing}, Case{"linear", falling, With::nothing},
        Case{"rational", falling, With::nothing}, Case{"exponential", falling, With::nothing},
        Case{"linear", falling, With::memory}, Case{"rational", falling, With::memory},
        Case{"exponential", falling, With::memory}, Case{"temperature", {0, 0.3, 50, 0.1}, With::heat}}) {
    std::vector<double> straight;
    double worst = 0;
    for (const double angle : {0.0, 1e-3, 2.5}) {
      Pair pair = pair_of("rational", 1);
      Scene& s = pair.contact->scene;
      const std::vector<double> lines = frames::uniform_lines(-1.3, 1.3, 20);
      SurfaceMesh mesh = frames::rectangle(ElementType::quad4, lines, lines);
      const double cosine = std::cos(angle), sine = std::sin(angle), x[3] = {cosine, sine, 0}, n[3] = {0, 0, 1};
      for (Vec3& p : mesh.node) p = {cosine * p[0] - sine * p[1], sine * p[0] + cosine * p[1], 0};
      pair.frame(mesh);
      const double origin[3] = {0, 0, 0};
      s.set_axes(origin, x, n);
      s.set_friction(c.law, static_cast<std::int32_t>(c.parameters.size()), c.parameters.data());
      if (c.with == With::memory) s.set_friction_memory(0.002, 0);
      if (c.with == With::heat)
        for (const int which : {1, 2}) s.set_heat(which, 1, 1, 0);
      if (c.with == With::yield) s.set_layer(1e-4, 20);
      ASSERT_EQ(pair.contact->solve(), Status::ok) << pair.contact->plan();
      std::vector<double> found = pair.tractions();
      if (straight.empty())
        straight = found;
      else
        worst = std::max(worst, largest_difference(found, straight));
    }
    std::printf("%s, with %d: tractions of the turned scenes differ by %.1e (bound 1e-8)\n", c.law,
                static_cast<int>(c.with), worst);
    EXPECT_LE(worst, 1e-8);
  }
}

TEST(friction_memory, refusals) {
  Pair pair = pair_of("linear", 1);
  Scene& s = pair.contact->scene;
  EXPECT_THROW(s.set_friction_memory(-1, 0), Error);
  EXPECT_THROW(s.set_friction_memory(1, -1), Error);
  EXPECT_THROW(s.set_friction_memory(NAN, 0), Error);
  s.set_friction_memory(1e-3, 0);
  pair.friction(0.3);
  try {
    pair.contact->solve();
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.status(), Status::err_state);
  }
  s.set_friction_memory(0, 0);
  EXPECT_EQ(pair.contact->solve(), Status::ok);
}

}  // namespace
}  // namespace rollcon
