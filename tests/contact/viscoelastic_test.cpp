/// Tests half-spaces that creep in steady rolling: elastic limits, Hunter's cylinder, Panek and Kalker's sphere and
/// roller, published cylinders, the balance of work, orders, symmetries, refusals.

#include <algorithm>
#include <array>

#include "contact/laws/wear_law.hpp"
#include "contact/scene_fixture.hpp"
#include "support/hunter_cylinder.hpp"
#include "support/relaxed_half_space.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

struct Material {
  std::vector<double> ratio, time;
};

void relax(Body& body, const Material& m) {
  body.set_viscoelastic(0, static_cast<std::int64_t>(m.ratio.size()), m.ratio.data(), m.time.data());
}

/// Describes a sphere of radius 50 on bodies with E = 210, nu = 0.4, of which the first one relaxes.
struct Rolled {
  Material first{{0.5}, {1}}, second{};
  double young1 = 210, poisson1 = 0.4, young2 = 0, poisson2 = -2;
  double speed = 1, half = 2.6, mu = 0.3;
  double crown = 0.01;  ///< curvature of the gap across the rolling direction
  std::array<double, 3> creep{-2e-3, 1e-3, 0};
  int n = 24;
  double load = 0;  ///< 0: an approach of 0.04
  double way = 1;   ///< rolling towards x or -x
  std::string operators = "auto";
};

std::unique_ptr<Pair> rolled(const Rolled& r) {
  auto pair = std::make_unique<Pair>(r.young1, r.poisson1, r.young2, r.poisson2);
  if (!r.first.ratio.empty()) relax(*pair->body1, r.first);
  if (!r.second.ratio.empty()) relax(*pair->body2, r.second);
  const std::vector<double> lines = frames::uniform_lines(-r.half, r.half, r.n);
  const double across = r.half * std::sqrt(0.01 / r.crown);
  pair->frame(frames::rectangle(ElementType::quad4, lines, frames::uniform_lines(-across, across, r.n)));
  Scene& scene = pair->contact->scene;
  const double origin[] = {0, 0, 0}, rolling[] = {r.way, 0, 0}, normal[] = {0, 0, 1};
  scene.set_axes(origin, rolling, normal);
  scene.set_gap_quadratic(0.01, r.crown, 0);
  pair->friction(r.mu);
  scene.set_speed(r.speed);
  scene.set_creep(r.creep[0], r.creep[1], r.creep[2]);
  scene.prescribe(3, r.load > 0 ? 2 : 1, r.load > 0 ? r.load : 0.04);
  scene.options.set_real("tolerance", 1e-12);
  scene.options.set_text("operators", r.operators.c_str());
  EXPECT_EQ(pair->contact->solve(), Status::ok);
  return pair;
}

std::array<double, 6> loads(Pair& pair) {
  std::array<double, 6> all;
  pair.contact->resultant(InAxes::local, all.data(), all.data() + 3);
  return all;
}

double creepage_of(const Pair& pair) {
  double approach = 0, creep[3];
  pair.contact->motion(&approach, creep);
  return creep[0];
}

TEST(viscoelastic, slow_and_fast_rolling_are_elastic) {
  const Rolled cases[] = {{}, {.second = {{0.2, 0.1}, {3, 0.2}}, .young2 = 500, .poisson2 = 0.3}, {.load = 12}};
  for (Rolled r : cases) {
    const auto limit = [&](bool relaxed) {
      Rolled e = r;
      e.first = e.second = {};
      if (relaxed) e.young1 *= 0.5, e.young2 *= r.second.ratio.empty() ? 1 : 0.7;
      return rolled(e)->tractions();
    };
    r.speed = 1e-12;
    const double slow = largest_difference(rolled(r)->tractions(), limit(true));
    r.speed = 1e12;
    const double fast = largest_difference(rolled(r)->tractions(), limit(false));
    std::printf("elastic limits: tractions off by %.1e slow, %.1e fast (bound 1e-9)\n", slow, fast);
    EXPECT_LT(slow, 1e-9);
    EXPECT_LT(fast, 1e-9);
    r.speed = 1;
    EXPECT_GT(largest_difference(rolled(r)->tractions(), limit(false)), 0.05) << "in between it is neither";
  }
}

TEST(viscoelastic, lattices_agree_with_integrals_along_lines) {
  for (const double speed : {0.3, 3.0}) {
    Rolled r{.second = {{0.2, 0.1}, {3, 0.2}}, .young2 = 500, .poisson2 = 0.3, .speed = speed, .half = 1.7, .n = 10};
    const auto by_table = rolled(r);
    r.operators = "fft";
    const double fft = largest_difference(rolled(r)->tractions(), by_table->tractions());
    r.operators = "dense";
    const auto dense = rolled(r);
    const double off = largest_difference(dense->tractions(), by_table->tractions());
    const double resistance =
        dense->contact->stat("rolling_resistance") / by_table->contact->stat("rolling_resistance") - 1;
    std::printf("V %4.1f: FFT off by %.1e (bound 1e-9), integrals by %.1e (bound 2e-3), resistance %+.1e (1e-3)\n",
                speed, fft, off, resistance);
    EXPECT_LT(fft, 1e-9);
    EXPECT_LT(by_table->worst_law(), 2e-4) << "recomputed by integrals";
    EXPECT_LT(off, 2e-3);
    EXPECT_LT(std::abs(resistance), 1e-3);
  }
}

/// Rolls cylinders on one line of long elements; results are those of a unit of length.
struct Line {
  std::unique_ptr<Pair> pair;
  std::vector<double> x, pressure;
  double moment, resistance;
  static constexpr double length = 2e4;  ///< a hat of this half-width carries as much as this length does
};

Line roll_line(std::unique_ptr<Pair> pair, int n, double half, double curvature, double load, double force,
               double speed) {
  Line line{std::move(pair), frames::uniform_lines(-half, half, n), {}, 0, 0};
  line.pair->frame(
      frames::rectangle(ElementType::quad4, line.x, frames::uniform_lines(-Line::length, Line::length, 2)));
  Scene& scene = line.pair->contact->scene;
  std::vector<double> gap;
  for (int row = 0; row < 3; ++row)
    for (const double x : line.x) gap.push_back(row == 1 ? curvature * x * x : 1e5);
  scene.set_gap(static_cast<std::int64_t>(gap.size()), gap.data());
  scene.set_speed(speed);
  scene.prescribe(3, 2, load * Line::length);
  line.pair->friction(force != 0 ? 0.3 : 0);
  if (force != 0) scene.prescribe(1, 2, force * Line::length);
  const Status status = line.pair->contact->solve();
  EXPECT_TRUE(status == Status::ok || status == Status::coarse);
  const std::vector<double> t = line.pair->tractions();
  for (std::size_t i = 0; i < line.x.size(); ++i) line.pressure.push_back(-t[3 * (line.x.size() + i) + 2]);
  line.moment = loads(*line.pair)[4] / Line::length;
  line.resistance = line.pair->contact->stat("rolling_resistance") / Line::length;
  return line;
}

TEST(viscoelastic, cylinder_is_that_of_hunter) {
  constexpr double load = 10, radius = 50, young = 210, poisson = 0.4;
  for (const double speed : {0.1, 0.5, 2.0, 10.0}) {
    // Creep ratio 1 and time 1.
    const HunterCylinder hunter(load, young / (1 - poisson * poisson), radius, 1, speed);
    auto pair = std::make_unique<Pair>(young, poisson, 0, -2);
    relax(*pair->body1, {{0.5}, {0.5}});
    const Line line = roll_line(std::move(pair), 200, 2.6, 0.5 / radius, load, 0, speed);
    const double top = *std::max_element(line.pressure.begin(), line.pressure.end()) / hunter.largest_pressure() - 1;
    const double moment = line.moment / hunter.moment() - 1;
    const double resistance = line.resistance * radius / hunter.moment() - 1;
    double worst = 0;
    for (std::size_t i = 0; i < line.x.size(); ++i)
      worst = std::max(worst, std::abs(line.pressure[i] - hunter.pressure(line.x[i])));
    worst /= hunter.largest_pressure();
    std::printf(
        "Hunter, V T %4.1f: largest pressure %+.1e, moment %+.1e, resistance %+.1e (bound 5e-3), any pressure %.1e\n",
        speed, top, moment, resistance, worst);
    EXPECT_LT(std::abs(top), 1e-3);
    EXPECT_LT(std::abs(moment), 5e-3);
    EXPECT_LT(std::abs(resistance), 5e-3);
    EXPECT_LT(worst, 0.03) << "nodes next to the edge";
  }
}

// Panek and Kalker's integral equation of a rigid sphere and roller (J. Inst. Maths Applics 26, 1980) is solved apart.
TEST(viscoelastic, sphere_and_roller_are_those_of_panek_and_kalker) {
  constexpr double approach = 0.04, half = 2.1, modulus = 210 / (1 - 0.4 * 0.4), creep_time = 2;
  constexpr int cells = 32;
  for (const double crown : {0.01, 5e-4})
    for (const double speed : {0.3, 2.0, 10.0}) {
      const RelaxedHalfSpace apart({0.01, crown, approach, modulus, 1, creep_time * speed}, half,
                                   half * std::sqrt(0.01 / crown), cells, cells / 2);
      const auto pair = rolled({.speed = speed, .half = half, .mu = 0, .crown = crown, .n = 64});
      const auto load = loads(*pair);
      const double force = -load[2] / apart.force() - 1, moment = load[4] / apart.moment() - 1,
                   top = pair->contact->stat("max_pressure") / apart.largest_pressure() - 1,
                   resistance = pair->contact->stat("rolling_resistance") / (0.02 * apart.moment()) - 1;
      std::printf(
          "%s, V %4.1f: force %+.1e (bound 1e-3), moment %+.1e, resistance %+.1e (5e-3), largest pressure %+.1e "
          "(3e-3)\n",
          crown == 0.01 ? "sphere" : "roller", speed, force, moment, resistance, top);
      EXPECT_LT(std::abs(force), 1e-3);
      EXPECT_LT(std::abs(moment), 5e-3);
      EXPECT_LT(std::abs(resistance), 5e-3);
      EXPECT_LT(std::abs(top), 3e-3);
    }
}

// CONTACT's example visc_cylindr: 99 strips of 0.16 mm, creep time 9 ms, V = 1000 mm/s.
TEST(viscoelastic, like_cylinders_are_those_of_contact) {
  const auto cylinders = [](double shear, bool creeps) {
    auto pair = std::make_unique<Pair>(2.8 * shear, 0.4, 2.8 * shear, 0.4);
    for (Body* body : {pair->body1.get(), pair->body2.get()})
      if (creeps) relax(*body, {{0.5}, {4.5e-3}});
    return roll_line(std::move(pair), 99, 99 * 0.08, 0.01, 600, -108, 1000);
  };
  struct Published {
    double shear;
    bool creeps;
    double creepage, pressure, touching, sticking;
  };
  const Published published[] = {{1143, true, 1.365e-2, 78.74, 62, 37},
                                 {571.5, false, 1.378e-2, 60.32, 80, 51},
                                 {1143, false, 9.792e-3, 85.29, 56, 36}};
  for (const Published& p : published) {
    const Line line = cylinders(p.shear, p.creeps);
    const double pressure = *std::max_element(line.pressure.begin(), line.pressure.end());
    const double creepage = creepage_of(*line.pair);
    const double touching = line.pair->contact->stat("nodes_contact"),
                 sticking = line.pair->contact->stat("nodes_stick");
    std::printf("CONTACT, G %6.1f: largest pressure %.2f (%.2f), creepage %.4e (%.4e), %g/%g strips (%g/%g)\n", p.shear,
                pressure, p.pressure, creepage, p.creepage, touching, sticking, p.touching, p.sticking);
    EXPECT_NEAR(pressure, p.pressure, 1e-3 * p.pressure);
    EXPECT_NEAR(creepage, p.creepage, 0.015 * p.creepage) << "CONTACT's of elastic cylinders is 1.3 % below Carter's";
    EXPECT_NEAR(touching, p.touching, 2);
    EXPECT_NEAR(sticking, p.sticking, 2);
  }
}

TEST(viscoelastic, resistance_is_what_pressures_do_on_the_gap) {
  for (const double speed : {0.3, 1.0, 3.0, 10.0}) {
    const auto pair = rolled({.first = {{0.3, 0.3, 0.2}, {0.1, 1, 10}}, .speed = speed, .half = 1.7, .mu = 0, .n = 64});
    const double dissipated = pair->contact->stat("body_power"), driven = 0.02 * loads(*pair)[4] * speed;
    std::printf("V %4.1f: power %.6e dissipated, %.6e by the moment of pressures: %+.1e (bound 1e-3)\n", speed,
                dissipated, driven, dissipated / driven - 1);
    EXPECT_GT(driven, 0);
    EXPECT_NEAR(dissipated, driven, 1e-3 * driven);
    EXPECT_DOUBLE_EQ(dissipated, speed * pair->contact->stat("rolling_resistance"));
  }
}

TEST(viscoelastic, power_of_friction_leaves_out_that_of_the_bodies) {
  double balance[2], nodal[2];
  for (const int k : {0, 1}) {
    const int n = k == 0 ? 32 : 64;
    const auto pair = rolled({.speed = 2, .half = 1.7, .creep = {-6e-3, 3e-3, 0}, .n = n});
    nodal[k] = pair->contact->stat("friction_power"), balance[k] = pair->contact->stat("friction_power_balance");
    const double bodies = pair->contact->stat("body_power");
    std::printf("n %d: friction %.5e at nodes, %.5e by the balance, bodies %.5e\n", n, nodal[k], balance[k], bodies);
    EXPECT_GT(bodies, balance[k]);
    EXPECT_LT(nodal[k], balance[k]);
  }
  EXPECT_NEAR(balance[0], balance[1], 0.01 * balance[1]);
  // A body that is towed loses much more inside than by friction.
  const auto towed = rolled({.half = 1.7, .creep = {0, 0, 0}, .n = 32});
  const double friction = towed->contact->stat("friction_power_balance"), bodies = towed->contact->stat("body_power");
  std::printf("no creepage: friction %.2e by the balance, bodies %.2e\n", friction, bodies);
  EXPECT_GT(friction, 0);
  EXPECT_LT(friction, 0.05 * bodies);
  EXPECT_GT(nodal[1], nodal[0] + 0.3 * (balance[1] - nodal[0])) << "the sum at nodes goes to the balance";
}

TEST(viscoelastic, forces_converge) {
  const auto off = [](auto of) {
    const double coarse = of(20), middle = of(40), fine = of(80), finest = of(160);
    const double limit = finest + (finest - fine) / 2;
    std::printf("  %.6f %.6f %.6f %.6f\n", coarse, middle, fine, finest);
    return std::log2(std::abs(coarse - limit) / std::abs(fine - limit)) / 2;
  };
  const double load = off([](int n) { return -loads(*rolled({.mu = 0, .n = n}))[2]; });
  const double resistance = off([](int n) { return rolled({.mu = 0, .n = n})->contact->stat("rolling_resistance"); });
  std::printf("orders: load %.2f, resistance %.2f (bound 1)\n", load, resistance);
  EXPECT_GT(load, 1);
  EXPECT_GT(resistance, 1);
}

TEST(viscoelastic, rolling_the_other_way_is_the_mirror_image) {
  Rolled r{.creep = {-2e-3, 0, 0}};
  const std::vector<double> there = rolled(r)->tractions();
  r.way = -1;
  const auto back_pair = rolled(r);
  const std::vector<double> back = back_pair->tractions();
  const auto lines = static_cast<std::size_t>(r.n) + 1;
  double worst = 0, shifted = 0;
  for (std::size_t j = 0; j < lines; ++j)
    for (std::size_t i = 0; i < lines; ++i) {
      const double* a = &there[3 * (j * lines + i)];
      const double* b = &back[3 * (j * lines + lines - 1 - i)];
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[c] - (c == 1 ? -b[c] : b[c])));
      shifted = std::max(shifted, std::abs(a[2] - there[3 * (j * lines + lines - 1 - i) + 2]));
    }
  std::printf("mirrored: off by %.1e (bound 1e-9), the pressure is off its own mirror image by %.2f\n", worst, shifted);
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(shifted, 0.3);
}

TEST(viscoelastic, units_do_not_matter) {
  const std::vector<double> millimetres = rolled({})->tractions();
  auto pair = std::make_unique<Pair>(210e6, 0.4, 0, -2);  // metres, pascals and minutes
  relax(*pair->body1, {{0.5}, {1.0 / 60}});
  const std::vector<double> lines = frames::uniform_lines(-2.6e-3, 2.6e-3, 24);
  pair->frame(frames::rectangle(ElementType::quad4, lines, lines));
  Scene& scene = pair->contact->scene;
  scene.set_gap_quadratic(10, 10, 0);
  pair->friction(0.3);
  scene.set_speed(0.06);
  scene.set_creep(-2e-3, 1e-3, 0);
  scene.prescribe(3, 1, 4e-5);
  scene.options.set_real("tolerance", 1e-12);
  ASSERT_EQ(pair->contact->solve(), Status::ok);
  std::vector<double> metres = pair->tractions();
  for (double& t : metres) t *= 1e-6;
  EXPECT_LT(largest_difference(metres, millimetres), 1e-9);
}

TEST(viscoelastic, terms_that_say_the_same_do_the_same) {
  const std::vector<double> one = rolled({})->tractions();
  EXPECT_LT(largest_difference(rolled({.first = {{0.2, 0.3, 0}, {1, 1, 7}}})->tractions(), one), 1e-12);
  // Both bodies alike are one of half the modulus.
  EXPECT_LT(largest_difference(
                rolled({.second = {{0.5}, {1}}, .young1 = 420, .young2 = 420, .poisson2 = 0.4, .mu = 0})->tractions(),
                rolled({.mu = 0})->tractions()),
            1e-9);
}

TEST(viscoelastic, a_change_of_speed_is_seen) {
  auto pair = rolled({});
  pair->contact->scene.set_speed(5);
  ASSERT_EQ(pair->contact->solve(), Status::ok);
  EXPECT_LT(largest_difference(pair->tractions(), rolled({.speed = 5})->tractions()), 1e-9);
}

// The time of three terms on a lattice of 128 x 128 is compared with the elastic one by scripts; here by counts.
TEST(viscoelastic, krylov_iterations_are_few) {
  const auto count = [](const Material& m) {
    return rolled({.first = m, .mu = 0, .n = 128})->contact->stat("linear_iterations");
  };
  const double elastic = count({}), creeping = count({{0.3, 0.3, 0.2}, {0.1, 1, 10}});
  std::printf("Krylov iterations on 129 x 129 nodes: %g elastic, %g with three terms (bound: 3 times)\n", elastic,
              creeping);
  EXPECT_LT(creeping, 3 * elastic);
}

TEST(viscoelastic, what_does_not_know_of_creep_refuses) {
  const auto message = [](Pair& pair, auto work) -> std::string {
    try {
      work(pair);
    } catch (const Error& e) {
      EXPECT_TRUE(e.status() == Status::err_unsupported || e.status() == Status::err_state);
      return e.what();
    }
    return "nothing was thrown";
  };
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find("viscoelastic"), std::string::npos) << text;
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  auto pair = rolled({});
  const double slip_energy = 1;
  says(message(*pair,
               [&](Pair& p) {
                 p.contact->wear(WearLaw("archard", {&slip_energy, 1}), {}, 1, nullptr);
               }),
       "wear");
  const double inside[] = {0, 0, -1};
  double u[3], stress[6];
  says(message(*pair, [&](Pair& p) { p.contact->fields_at(1, false, 1, inside, u, stress); }), "displacements inside");
  pair->contact->fields_at(1, false, 1, inside, nullptr, stress);
  EXPECT_LT(stress[2], 0) << "stresses do not depend on the modulus";
  pair->contact->scene.set_step(1, 0.1);
  says(message(*pair, [](Pair& p) { p.contact->solve(); }), "steady rolling");
  pair->contact->scene.set_step(0, 0);
  EXPECT_EQ(pair->contact->solve(), Status::ok) << "the contact is usable";
  Pair without_speed(210, 0.4, 0, -2);
  relax(*without_speed.body1, {{0.5}, {1}});
  standard_scene(without_speed, 8);
  says(message(without_speed, [](Pair& p) { p.contact->solve(); }), "rollcon_contact_set_rolling");
}

}  // namespace
}  // namespace rollcon
