// Measures the paper's figure 21: the error function over iterations and over time on example 4.

#include <cmath>

#include "procedures.hpp"

namespace rollcon::bench {
namespace {

void error_function(Runner& runner) {
  const Example example = runner.quick ? coarse_examples()[5] : paper_examples().back();
  const auto pair = example.make(runner.threads);
  pair->solve();  // makes the compliance
  scenes::Solution standard;
  std::vector<Procedure> procedures{Procedure{}};
  for (const char* jacobian : {"b_derivative", "simplified"})
    for (const char* solver : linear_solvers) procedures.push_back({.jacobian = jacobian, .linear_solver = solver});
  for (const char* estimate : slip_estimates)
    for (const char* solver : linear_solvers)
      procedures.push_back({.jacobian = "reduced", .slip_estimate = estimate, .linear_solver = solver});
  procedures.push_back({"monolithic", "b_derivative", "auto", "lu", "auto"});
  for (const char* solver : {"gmres", "gmres_adaptive"})
    procedures.push_back({"monolithic", "b_derivative", "auto", solver, "bodies"});
  procedures.push_back({"monolithic", "reduced", "jacobi", "gmres_adaptive", "bodies"});
  for (const Procedure& procedure : procedures) {
    Record record{.case_name = "procedures_example4", .model = example.name};
    record.mesh = runner.quick ? "coarse" : "1954 quad4 nodes";
    record.threads = runner.threads;
    const scenes::Solution s = solve_by(procedure, *pair, record);
    if (standard.nodes() == 0) standard = s;
    record.quantity = "seconds without compliance and convection";
    record.against = "tractions of " + procedures.front().name();
    record.value = record.status < 0 ? NAN : solving_seconds(*pair);
    record.error = record.status < 0 ? NAN : traction_difference(standard, s);
    runner.emit(record);
  }
}

}  // namespace

std::vector<Case> procedure_example4_cases() {
  return {{"procedures_example4", "wheel on a rail: error function by iteration, figure 21", error_function}};
}

}  // namespace rollcon::bench
