// Records where published solution procedures do not converge, or hardly, with the status they end with, beside those
// that do.

#include "support/example1.hpp"
#include "support/example3.hpp"
#include "validation/procedure_runs.hpp"

namespace rollcon::validation {
namespace {

namespace example1 = scenes::example1;
namespace example3 = scenes::example3;
using Pair = std::unique_ptr<RollingPair>;

std::vector<Procedure> by_lu() {
  std::vector<Procedure> all;
  for (const char* system : {"condensed", "monolithic"})
    for (const Procedure& p : procedures_of(system))
      if (p.linear_solver == "lu") all.push_back(p);
  return all;
}

Pair sphere(double force_ratio) {
  const double reach = 1.3 * example3::hertz().a;
  auto pair = example3::pair(frames::o_grid(ElementType::quad4, 8, 2, reach, reach), "godunov");
  pair->tangential_force(ROLLCON_LONGITUDINAL, force_ratio * example3::mu * example3::load);
  return pair;
}

TEST(ProceduresLimits_long, frozen_directions_fail_near_gross_sliding) {
  compare_procedures("force 99 % of friction", *sphere(0.99), by_lu(),
                     std::vector<Failing>{{.jacobian = "simplified"}, {.jacobian = "reduced"}});
}

TEST(ProceduresLimits, frozen_directions_reach_most_of_friction) {
  compare_procedures("force 85 % of friction", *sphere(0.85), by_lu());
}

/// Rings roll on each other without a given lateral force: one that estimates of slip leave behind dies out, sweep by
/// sweep, over the length that a tyre of the rings' lateral stiffness would roll.
TEST(ProceduresLimits_long, estimates_of_slip_travel_with_the_particles) {
  surfaces::Ring shape = example1::paper_ring();
  shape.zone_around = 6, shape.across = 2, shape.around = 12, shape.deep = 1;
  shape.largest = example1::longest(shape.around - shape.zone_around);
  auto pair = example1::pair(shape, ElementType::quad4, "godunov");
  compare_procedures("rings, lateral creepage 0", *pair, by_lu(), std::vector<Failing>{{.jacobian = "reduced"}});
  Procedure{}.apply(*pair);
  ASSERT_EQ(pair->solve(), ROLLCON_OK);
  const Solution reference = pair->solution();
  for (const char* estimate : {"jacobi", "pseudo_temporal", "extrapolation"}) {
    Procedure{"condensed", "reduced", estimate, "lu"}.apply(*pair);
    pair->option("max_iterations", std::int64_t{4000});
    pair->reset();
    ASSERT_EQ(pair->solve(), ROLLCON_OK) << estimate;
    report(std::string("iterations in the end, ") + estimate, pair->stat("iterations"));
    expect_error(std::string("tractions in the end, ") + estimate, traction_difference(pair->solution(), reference),
                 1e-6);
  }
}

}  // namespace
}  // namespace rollcon::validation
