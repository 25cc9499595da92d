// Dissimilar rollers in plane strain: creepage of free rolling at vanishing, usual and unlimited
// friction, and of tractive rolling, each found from a prescribed force
// (tests/data/bentall_johnson.csv).

#include "report.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::validation {
namespace {

using closed_forms::Carter;
using namespace scenes;

const Elastic steel{.shear = 82000, .poisson = 0.28}, aluminium{.shear = 23000, .poisson = 0.31};
constexpr double combined_radius = 25;
constexpr double pi = 3.14159265358979323846;

double coupling(const Elastic& e) { return (1 - 2 * e.poisson) / (4 * pi * e.shear); }

/// Steel (body 1) on aluminium; the middle section obeys the plane theory.
struct Rollers {
  Strip strip{closed_forms::hertz_line_from_load(
                  combined_radius, closed_forms::effective_modulus(steel, aluminium), 16.20),
              2.0};
  RollingPair pair{steel, aluminium};

  explicit Rollers(int elements, const char* scheme) {
    std::vector<double> lines = graded_nodes(elements);
    for (double& x : lines) x *= strip.hertz.a;
    const auto mesh =
        frames::rectangle(ElementType::quad4, lines, scenes::strip_lines(strip.half_length));
    std::vector<double> x, y;
    for (const Vec3& node : mesh.node) {
      x.push_back(node[0]);
      y.push_back(node[1]);
    }
    pair.frame(mesh).gap(strip.gap(x, y)).load(strip.total_load());
    pair.creep_field(strip.end_slip(x, y, coupling(steel) - coupling(aluminium)));
    pair.option("convection", scheme);
  }
};

TEST(BentallJohnson, creepage_of_free_and_tractive_rolling) {
  Rollers rollers(50, "characteristic");
  const double load = rollers.strip.total_load();
  for (const auto& row : closed_forms::bentall_johnson()) {
    rollers.pair.friction(row.mu).tangential_force(ROLLCON_LONGITUDINAL,
                                                   row.force_ratio * row.mu * load);
    rollers.pair.reset();
    ASSERT_EQ(rollers.pair.solve(), ROLLCON_RIM_CONTACT) << "mu = " << row.mu;
    const Solution s = rollers.pair.solution();
    const Section middle = scenes::middle_section(s);
    char name[100];
    std::snprintf(name, sizeof name, "mu = %g, F/(mu P) = %+.2f: xi = %.4e, expected %.4e", row.mu,
                  row.force_ratio, s.creep[0], row.xi);
    expect_error(name, relative(s.creep[0], row.xi), 2e-2);
    report("  its middle section's F/(mu P)", middle.force() / (row.mu * middle.load()));
    if (row.p0 > 0) {
      const double p0 = *std::max_element(middle.pressure.begin(), middle.pressure.end());
      expect_error("  largest pressure", relative(p0, row.p0), 2e-2);
    }
  }
}

TEST(BentallJohnson, vanishing_friction_against_theory) {
  const double theory = closed_forms::bentall_johnson_vanishing(steel, aluminium, 0.1, 25);
  expect_error("closed form against the published 0.457 kappa a/R", relative(theory, 5.2586e-4),
               2e-3);
  Rollers rollers(50, "characteristic");
  rollers.pair.friction(1e-6).tangential_force(ROLLCON_LONGITUDINAL, 0);
  ASSERT_EQ(rollers.pair.solve(), ROLLCON_RIM_CONTACT);
  expect_error("xi against theory", relative(rollers.pair.solution().creep[0], theory), 1e-2);
}

TEST(BentallJohnson, schemes_agree) {
  for (const char* scheme : schemes) {
    Rollers rollers(50, scheme);
    rollers.pair.friction(0.05).tangential_force(ROLLCON_LONGITUDINAL, 0);
    ASSERT_EQ(rollers.pair.solve(), ROLLCON_RIM_CONTACT) << scheme;
    expect_error(std::string(scheme) + ": xi of free rolling, mu = 0.05",
                 relative(rollers.pair.solution().creep[0], 4.294e-4), 2e-2);
  }
}

}  // namespace
}  // namespace rollcon::validation
