#pragma once
/// Runs every admissible combination of the solution procedure's options on one scene, and compares it with the
/// standard one.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "support/procedures.hpp"
#include "validation/scenes.hpp"

namespace rollcon::validation {

using scenes::Procedure;
using scenes::traction_difference;

enum class Plain { all, fast };

/// Returns all procedures of one system; estimates of slip go with reduced unknowns only (and "auto" is "jacobi"),
/// preconditioners with GMRES. The characteristic scheme has no reduced unknowns. Without any factors GMRES needs
/// thousands of iterations on written-out bodies: Plain::fast leaves that to the Jacobians with few steps.
inline std::vector<Procedure> procedures_of(const std::string& system, bool reduced = true, Plain plain = Plain::all) {
  std::vector<Procedure> all;
  const auto with_solvers = [&](const std::string& jacobian, const char* estimate) {
    all.push_back({system, jacobian, estimate, "auto", "auto"});
    all.push_back({system, jacobian, estimate, "lu", "auto"});
    const bool few_steps = jacobian == "exact" || jacobian == "b_derivative";
    for (const char* solver : {"gmres", "gmres_adaptive"}) {
      all.push_back({system, jacobian, estimate, solver, "auto"});
      const bool keeps_factors = system == "condensed" && jacobian == "exact";
      if (!keeps_factors && (plain == Plain::all || few_steps))
        for (const char* preconditioner : {"none", "diagonal"})
          all.push_back({system, jacobian, estimate, solver, preconditioner});
      const char* own = system == "monolithic" ? "bodies" : "kept_lu";
      all.push_back({system, jacobian, estimate, solver, own});
    }
  };
  for (const char* jacobian : {"exact", "b_derivative", "simplified"}) with_solvers(jacobian, "auto");
  if (!reduced) return all;
  for (const char* estimate : {"jacobi", "pseudo_temporal", "extrapolation"}) with_solvers("reduced", estimate);
  return all;
}

/// Names combinations known not to converge on a scene; an empty name stands for all.
struct Failing {
  std::string system = {}, jacobian = {}, slip_estimate = {}, linear_solver = {}, preconditioner = {};

  bool covers(const Procedure& p) const {
    const auto fits = [](const std::string& mine, const std::string& name) { return mine.empty() || mine == name; };
    return fits(system, p.system) && fits(jacobian, p.jacobian) && fits(slip_estimate, p.slip_estimate) &&
           fits(linear_solver, p.linear_solver) && fits(preconditioner, p.preconditioner);
  }
};

/// Compares the procedures: a status of OK with other tractions than the standard procedure's is a failure whatever is
/// listed; one that is not listed must be OK, one that is listed NOT_CONVERGED.
inline void compare_procedures(const std::string& scene, RollingPair& pair, std::span<const Procedure> procedures,
                               std::span<const Failing> failing = {}) {
  constexpr double bound = 1e-6;
  // The limit is twice what the slowest that converges needs; where some fail, it is enough for the others.
  const std::int64_t most_iterations = failing.empty() ? 800 : 400;
  Procedure{}.apply(pair);
  pair.option("max_iterations", most_iterations);
  pair.reset();
  // Bodies of few layers of elements are told, whatever the procedure.
  const std::int32_t usual = pair.solve();
  ASSERT_TRUE(usual == ROLLCON_OK || usual == ROLLCON_INACCURATE) << scene << ": the standard procedure";
  const Solution reference = pair.solution();
  std::printf("%s: %zu nodes, %g in contact, %g of them stick; bound %.0e\n", scene.c_str(), reference.nodes(),
              pair.stat("nodes_contact"), pair.stat("nodes_stick"), bound);
  double worst = 0;
  for (const Procedure& p : procedures) {
    p.apply(pair);
    pair.reset();
    const std::int32_t status = pair.solve();
    const double error = traction_difference(pair.solution(), reference);
    std::printf("  %-58s error %8.1e, %3.0f iterations, %5.0f of Krylov, %6.3f s  %s\n", p.name().c_str(), error,
                pair.stat("iterations"), pair.stat("linear_iterations"), pair.stat("seconds_total"),
                status == usual ? "" : "NOT CONVERGED");
    const bool listed = std::any_of(failing.begin(), failing.end(), [&](const Failing& f) { return f.covers(p); });
    EXPECT_EQ(status, listed ? ROLLCON_NOT_CONVERGED : usual) << scene << ": " << p.name();
    if (status != usual) continue;
    EXPECT_LE(error, bound) << scene << ": " << p.name();
    worst = std::max(worst, error);
  }
  expect_error(scene + ": worst of those that converge", worst, bound);
}

}  // namespace rollcon::validation
