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

}  // namespace
}  // namespace rollcon::contact_test
