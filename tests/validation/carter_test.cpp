// Carter's steady rolling of identical cylinders on frames aligned with the flow.

#include "report.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::validation {
namespace {

using closed_forms::Carter;
using namespace scenes;

struct Result {
  CarterErrors errors[3];  ///< by scheme
};

Result roll(const std::vector<double>& x, double half_length) {
  const Strip strip{carter.hertz, half_length};
  const auto mesh = frames::rectangle(ElementType::quad4, x, scenes::strip_lines(half_length));
  RollingPair pair(roller, roller);
  pair.frame(mesh);
  load_strip(pair, strip, mesh);
  Result result;
  for (int i = 0; i < 3; ++i) {
    pair.option("convection", schemes[i]);
    pair.reset();
    // The ends of the strip are loaded: the frame's rim is in contact by intent.
    EXPECT_EQ(pair.solve(), ROLLCON_RIM_CONTACT) << schemes[i];
    result.errors[i] = compare(scenes::middle_section(pair.solution()));
  }
  return result;
}

TEST(Carter, aligned_50_nodes_across) {
  const Result r = roll(strip_nodes(50), 20);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    expect_error(name + ": load of the middle section", r.errors[i].load, 1e-2);
    expect_error(name + ": F/(mu P) at given creepage", r.errors[i].force, 1e-2);
    expect_error(name + ": traction, relative L2", r.errors[i].traction, 1.5e-2);
  }
}

TEST(Carter, aligned_50_nodes_across_with_the_edge_on_a_node) {
  const Result r = roll(strip_nodes(50, 0), 20);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    expect_error(name + ": F/(mu P) at given creepage", r.errors[i].force, 1e-2);
    expect_error(name + ": traction, relative L2", r.errors[i].traction, 1.5e-2);
  }
}

TEST(Carter_long, uniform_nodes_converge_with_first_order) {
  const Result coarse = roll(strip_nodes(20), 20), fine = roll(strip_nodes(80), 20);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    report(name + ": F/(mu P), 20 nodes across", coarse.errors[i].force);
    report(name + ": F/(mu P), 80 nodes across", fine.errors[i].force);
    // First order in the force; the square roots at the edges leave 1/2 to 1 in the L2 norm.
    expect_order(name + ": F/(mu P)", observed_order(coarse.errors[i].force, fine.errors[i].force, 4, 1), 0.75);
    expect_order(name + ": traction", observed_order(coarse.errors[i].traction, fine.errors[i].traction, 4, 1), 0.6);
  }
}

TEST(Carter_long, nodes_graded_to_the_edge_converge_faster) {
  const Result coarse = roll(graded_nodes(20), 40), fine = roll(graded_nodes(40), 40);
  for (int i = 0; i < 3; ++i) {
    const std::string name = schemes[i];
    report(name + ": F/(mu P), 20 graded elements", coarse.errors[i].force);
    report(name + ": traction, 20 graded elements", coarse.errors[i].traction);
    if (i == 0) {
      // The flux difference over a median-dual cell, (w_J - w_I)/Omega_I, is not consistent where the spacing changes:
      // Godunov's force still converges, slowly.
      report(name + ": traction, 40 graded elements", fine.errors[i].traction);
      expect_error(name + ": F/(mu P), 40 graded elements", fine.errors[i].force, 1e-1);
      expect_order(name + ": F/(mu P)", observed_order(coarse.errors[i].force, fine.errors[i].force, 2, 1), 0.5);
      continue;
    }
    expect_error(name + ": F/(mu P), 40 graded elements", fine.errors[i].force, 3e-3);
    expect_error(name + ": traction, 40 graded elements", fine.errors[i].traction, 1.5e-2);
    expect_order(name + ": F/(mu P)", observed_order(coarse.errors[i].force, fine.errors[i].force, 2, 1), 1.5);
  }
}

TEST(Carter_long, the_strip_is_long_enough) {
  double force[3];
  for (int i = 0; i < 3; ++i) force[i] = roll(graded_nodes(24), 5.0 * (1 << i)).errors[2].force;
  report("F/(mu P), half length  5 a", force[0]);
  report("F/(mu P), half length 10 a", force[1]);
  report("F/(mu P), half length 20 a", force[2]);
  // The pieces beyond the ends change the kernel by about (a / half length)^2 / 2.
  expect_error("change of F from half length 5 a to 20 a", force[0] - force[2], 0.5 / 25);
  expect_error("change of F from half length 10 a to 20 a", force[1] - force[2], 0.5 / 100);
}

TEST(Carter, more_creepage_more_slip_until_all_slides) {
  const Strip strip{carter.hertz, 20};
  const auto mesh = frames::rectangle(ElementType::quad4, strip_nodes(50), scenes::strip_lines(20));
  RollingPair pair(roller, roller);
  pair.frame(mesh);
  load_strip(pair, strip, mesh);
  pair.option("convection", "characteristic");
  for (double xi : {1e-4, 2e-4, 3e-4, 4e-4, 5e-4, 5.9e-4, 8e-4}) {
    pair.creep(-xi, 0, 0);
    EXPECT_EQ(pair.solve(), ROLLCON_RIM_CONTACT);
    const Section s = scenes::middle_section(pair.solution());
    Carter exact = carter;
    exact.xi = -xi;
    char name[60];
    std::snprintf(name, sizeof name, "xi = %.1e: F/(mu P) = %.4f, in mu P", xi, exact.force_ratio());
    expect_error(name, s.force() / (carter.mu * s.load()) - exact.force_ratio(), 1e-2);
  }
}

}  // namespace
}  // namespace rollcon::validation
