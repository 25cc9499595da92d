/// Tests surface temperatures: closed forms of a uniform strip and of a parabola, bodies of unequal temperature, a
/// sliding Hertzian contact, and friction that follows the temperature.

#include "contact/heat/flash_temperature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/scene_fixture.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace contact_test;

constexpr double pi = std::numbers::pi;
constexpr double a = 1.5, speed = 3e4, least_y = -0.4, greatest_y = 0.4;
constexpr BothHeats steel{{{50, 3.5, 0, true}, {20, 2.5, 0, true}}};

double factor(const BothHeats& heat) {
  double sum = 0;
  for (const Heat& h : heat) sum += std::sqrt(h.conductivity * h.capacity);
  return 1 / (sum * std::sqrt(pi * speed));
}

/// Heats |x| <= a, the frame's length, by the power q(x); gives temperatures of both bodies at points on a line between
/// nodes.
struct Strip {
  Frame frame;
  StreamLines lines{frame};
  std::vector<double> power, pressure;

  template <class Q>
  Strip(ElementType type, int n, Q q)
      : frame(build_frame(
            frames::rectangle(type, frames::uniform_lines(-a, a, n), frames::uniform_lines(least_y, greatest_y, 3)),
            {})),
        lines(frame),
        pressure(frame.x.size(), 1.0) {
    for (const double x : frame.x) power.push_back(q(x));
  }
  double at(const BothHeats& heat, double x, std::size_t body = 0) const {
    const double y = 0.1234;
    double t[2];
    surface_temperatures({lines, power, pressure, speed, heat}, {&x, 1}, {&y, 1}, t);
    return t[body];
  }
};

TEST(flash_temperature, uniform_strip) {
  for (const ElementType type : {ElementType::tri3, ElementType::quad4, ElementType::quad8}) {
    const Strip strip(type, 7, [](double) { return 250.0; });
    double worst = 0;
    for (const double x : {2.0, 1.49, 0.3, 0.0, -1.2, -1.5, -1.6, -9.0}) {
      const double ahead = x < a ? std::sqrt(a - x) : 0, behind = x < -a ? std::sqrt(-a - x) : 0;
      const double exact = 2 * 250 * factor(steel) * (ahead - behind);
      worst = std::max(worst, std::abs(strip.at(steel, x) - exact));
      EXPECT_EQ(strip.at(steel, x, 0), strip.at(steel, x, 1));
    }
    const double scale = 2 * 250 * factor(steel) * std::sqrt(2 * a);
    std::printf("element %d: uniform strip off by %.1e of its greatest temperature (bound 1e-13)\n",
                static_cast<int>(type), worst / scale);
    EXPECT_LE(worst, 1e-13 * scale);
  }
}

// The power q0 (1 - x^2/a^2) makes the integral of q(x')/sqrt(x' - x) a polynomial times sqrt(d), with d = a - x.
TEST(flash_temperature, parabola_with_second_order) {
  const auto antiderivative = [](double x, double t) {
    const double r = std::sqrt(t);
    return 2 * r * (1 - x * x / (a * a)) - 4 * x / (3 * a * a) * r * r * r - 2 / (5 * a * a) * r * r * r * r * r;
  };
  double before = 0;
  for (const int n : {10, 20, 40, 80}) {
    const Strip strip(ElementType::quad4, n, [](double x) { return 250 * (1 - x * x / (a * a)); });
    double worst = 0, greatest = 0;
    for (double x = 1.45; x > -4; x -= 0.07) {
      const double exact = 250 * factor(steel) * (antiderivative(x, a - x) - (x < -a ? antiderivative(x, -a - x) : 0));
      worst = std::max(worst, std::abs(strip.at(steel, x) - exact));
      greatest = std::max(greatest, exact);
    }
    worst /= greatest;
    std::printf("parabola, %d intervals: off by %.2e (bound %.2e)\n", n, worst, 1.1 / (n * n));
    EXPECT_LE(worst, 1.1 / (n * n));
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / worst), 2, 0.2);
    }
    before = worst;
  }
}

// Both bodies have a common temperature in the contact without friction, and behind it each returns to its own.
TEST(flash_temperature, bodies_of_unequal_temperature) {
  const Strip strip(ElementType::quad4, 12, [](double) { return 0.0; });
  BothHeats heat = steel;
  heat[0].temperature = 20, heat[1].temperature = 90;
  const double b1 = std::sqrt(50 * 3.5), b2 = std::sqrt(20 * 2.5), common = (b1 * 20 + b2 * 90) / (b1 + b2);
  for (const double x : {1.4, 0.0, -1.4})
    for (const std::size_t body : {0U, 1U}) EXPECT_NEAR(strip.at(heat, x, body), common, 1e-11);
  for (const std::size_t body : {0U, 1U}) {
    EXPECT_EQ(strip.at(heat, 2, body), heat[body].temperature);
    for (const double x : {-1.6, -3.0, -30.0}) {
      const double share = 2 / pi * std::asin(std::sqrt(2 * a / (a - x)));
      EXPECT_NEAR(strip.at(heat, x, body), heat[body].temperature + share * (common - heat[body].temperature), 1e-10);
    }
  }
}

/// Presses a ball on a plane under a creepage at which all nodes slide, with heat in both bodies.
Pair sliding_pair(int n) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  standard_scene(pair, n);
  Scene& s = pair.contact->scene;
  s.set_speed(speed);
  s.set_creep(0.2, 0, 0);
  for (int b = 1; b <= 2; ++b) s.set_heat(b, 50, 3.5, 15);
  return pair;
}

std::vector<double> field_of(const Pair& pair, Field field) {
  std::vector<double> v(static_cast<std::size_t>(pair.contact->field(field, InAxes::local, 0, nullptr)));
  pair.contact->field(field, InAxes::local, static_cast<std::int64_t>(v.size()), v.data());
  return v;
}

// The power mu p0 s sqrt(1 - x^2/a^2) on the middle line has the greatest temperature where the integral is greatest,
// 2.188 at -0.65 a.
TEST(flash_temperature_long, sliding_sphere) {
  for (const char* operators : {"dense", "fft"}) {
    Pair pair = sliding_pair(40);
    pair.contact->scene.options.set_text("operators", operators);
    ASSERT_EQ(pair.contact->solve(), Status::ok);
    const std::vector<double> t = field_of(pair, Field::temperature), p = field_of(pair, Field::pressure);
    const double p0 = *std::max_element(p.begin(), p.end()), radius = 1;  // radius of R = 50 and approach 0.02
    double integral = 0;
    constexpr int steps = 2000;
    for (int at = 0; at <= 100; ++at) {
      const double x = -at / 100.0;
      double sum = 0;
      const double end = std::sqrt(1 - x);
      for (int i = 0; i < steps; ++i) {
        const double u = end * (i + 0.5) / steps, there = x + u * u;
        sum += 2 * std::sqrt(std::max(0.0, 1 - there * there)) * end / steps;
      }
      integral = std::max(integral, sum);
    }
    const double sum = 2 * std::sqrt(50 * 3.5);
    const double exact = 15 + 0.3 * p0 * 0.2 * speed * std::sqrt(radius) * integral / (sum * std::sqrt(pi * speed));
    const double found = *std::max_element(t.begin(), t.end());
    std::printf("%s: sliding sphere, greatest temperature %.2f, closed form %.2f (bound 1 %% of the rise)\n", operators,
                found, exact);
    EXPECT_NEAR(found, exact, 0.01 * (exact - 15));
    double at_points[2];
    const double middle[2] = {0, 0};
    pair.contact->temperatures_at(1, middle, at_points);
    EXPECT_EQ(at_points[0], t[t.size() / 2]);  // value of the middle node of body 1: the number of nodes is odd
  }
}

// The coefficient at each node is that of its temperature; a law that does not change is Coulomb's.
TEST(flash_temperature, friction_of_temperature) {
  Pair coulomb = sliding_pair(14);
  coulomb.friction(0.3);
  coulomb.contact->solve();
  Pair pair = sliding_pair(14);
  Scene& s = pair.contact->scene;
  const double level[] = {0, 0.3, 100, 0.3};
  s.set_friction("temperature", 4, level);
  ASSERT_EQ(pair.contact->solve(), Status::ok);
  const double off = largest_difference(pair.tractions(), coulomb.tractions());
  std::printf("level: tractions off Coulomb's by %.1e (bound 1e-10)\n", off);
  EXPECT_LE(off, 1e-10);
  const double hot = field_of(coulomb, Field::temperature)[2 * 112];
  const double falling[] = {20, 0.3, 20 + 0.8 * (hot - 20), 0.1, 2 * hot, 0.05};
  s.set_friction("temperature", 6, falling);
  for (const double creep : {0.2, 2e-3, 5e-4}) {
    s.set_creep(creep, 0.3 * creep, 0);
    ASSERT_EQ(pair.contact->solve(), Status::ok) << pair.contact->plan();
    const std::vector<double> t = field_of(pair, Field::temperature), mu = field_of(pair, Field::friction);
    const std::vector<double> p = field_of(pair, Field::pressure);
    const double p0 = *std::max_element(p.begin(), p.end());
    double worst = 0, least = 1;
    for (std::size_t k = 0; k < mu.size(); ++k) {
      const double at = t[2 * k];
      double wanted = 0.3;
      if (at > falling[0]) wanted = 0.3 - 0.2 * (at - falling[0]) / (falling[2] - falling[0]);
      if (at > falling[2]) wanted = 0.1 - 0.05 * (at - falling[2]) / (falling[4] - falling[2]);
      if (at > falling[4]) wanted = 0.05;
      if (p[k] > 0)
        worst = std::max(worst, std::abs(mu[k] - wanted) * p[k] / (0.3 * p0)), least = std::min(least, mu[k]);
    }
    std::printf("creepage %g: least coefficient %.4f, bound off by %.1e (bound 1e-7), %g rounds, %g iterations\n",
                creep, least, worst, pair.contact->stat("friction_rounds"), pair.contact->stat("iterations"));
    EXPECT_LE(worst, 1e-7);
    EXPECT_LE(pair.worst_law(), 1e-6);
    if (creep > 0.1) {
      EXPECT_LT(least, 0.2);
    }
  }
}

TEST(flash_temperature, refusals) {
  Pair pair(1e4, 0.3, 1e4, 0.3);
  standard_scene(pair, 10);
  Scene& s = pair.contact->scene;
  s.set_creep(1e-3, 0, 0);
  pair.contact->solve();
  std::vector<double> t(2 * 121);
  const auto refused = [&](Status status, auto call, const std::string& words = "") {
    try {
      call();
      ADD_FAILURE() << "not refused";
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), status) << e.what();
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  };
  refused(Status::err_state, [&] { field_of(pair, Field::temperature); });
  s.set_heat(1, 50, 3.5, 0);
  refused(Status::err_state, [&] { field_of(pair, Field::temperature); });
  s.set_heat(2, 0, 0, 0);
  EXPECT_NO_THROW(field_of(pair, Field::temperature));
  s.set_heat(1, 0, 3.5, 0);
  refused(Status::err_state, [&] { field_of(pair, Field::temperature); });
  refused(Status::err_argument, [&] { s.set_heat(3, 1, 1, 0); });
  refused(Status::err_argument, [&] { s.set_heat(1, -1, 1, 0); });
  const double falling[] = {20, 0.3, 100, 0.1}, unsorted[] = {20, 0.3, 50, 0.2, 50, 0.1};
  refused(
      Status::err_argument, [&] { s.set_friction("temperature", 6, unsorted); }, "T3 is 50; allowed: above T2");
  refused(Status::err_argument, [&] { s.set_friction("temperature", 3, falling); });
  s.set_friction("temperature", 4, falling);
  refused(Status::err_state, [&] { pair.contact->solve(); });
  s.set_heat(1, 50, 3.5, 0);
  EXPECT_EQ(pair.contact->solve(), Status::ok);
  refused(Status::err_unsupported,
          [&] { pair.contact->sensitivity(Parameter::longitudinal, nullptr, nullptr, nullptr, nullptr); });
  s.set_step(1, 1e-5);
  refused(Status::err_unsupported, [&] { pair.contact->solve(); });
}

}  // namespace
}  // namespace rollcon
