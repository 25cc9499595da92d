// Measures every admissible combination of system, Jacobian, slip estimate and linear solver on the paper's examples,
// and the standard procedure beside the monolithic ones.

#include <cmath>
#include <exception>

#include "procedures.hpp"

namespace rollcon::bench {
namespace {

void combinations(Runner& runner) {
  for (const Example& example : coarse_examples()) {
    const auto pair = example.make(runner.threads);
    pair->solve();  // makes the compliance
    scenes::Solution standard;
    const auto add = [&](const Procedure& procedure) {
      Record record{.case_name = "procedures_examples", .model = example.name};
      record.threads = runner.threads;
      const scenes::Solution s = solve_by(procedure, *pair, record);
      if (standard.nodes() == 0) standard = s;
      record.mesh = std::to_string(record.nodes) + " nodes";
      record.quantity = "largest difference of tractions";
      record.against = Procedure{}.name();
      record.value = record.error = record.status < 0 ? NAN : traction_difference(standard, s);
      runner.emit(record);
    };
    add(Procedure{});
    for (const char* system : systems) {
      if (example.condensed_only && system == std::string("monolithic")) continue;
      for (const Procedure& procedure : procedures_by_solver(system)) {
        const bool plain = procedure.linear_solver == "lu" &&
                           (procedure.slip_estimate == "auto" || procedure.slip_estimate == "jacobi");
        if (!runner.quick || (plain && procedure.system == "condensed")) add(procedure);
      }
    }
    if (runner.quick) break;
  }
}

/// Solves from arrays to tractions, then again and again after a hundredth of change.
void add_resolves(Record& record, scenes::RollingPair& pair, const scenes::Solution& s) {
  constexpr int most = 4;
  constexpr double long_enough = 0.1;  // seconds; slower solves are not repeated as often
  double fastest = INFINITY, iterations = 0;
  // The first re-solve with creepages given may still size workspaces. A prediction would be the solution where the
  // creepage is back where it came from.
  pair.option("warm_start", std::int64_t{1});
  pair.creep(s.creep[0], s.creep[1], s.creep[2]).solve();
  for (int k = 0; k < (fastest > long_enough && k > 0 ? 2 : most); ++k) {
    const double began = now();
    pair.creep((k % 2 == 0 ? 1.01 : 1) * s.creep[0], s.creep[1], s.creep[2]);
    pair.solve();
    if (now() - began > fastest) continue;
    fastest = now() - began;
    iterations = pair.stat("iterations");
  }
  record.extra.emplace_back("warm_seconds", fastest);
  record.extra.emplace_back("warm_iterations", iterations);
}

/// Compares the standard with the monolithic procedures that converge fast, cold and on re-solve.
void speed(Runner& runner) {
  std::vector<Procedure> procedures{Procedure{}};
  // The linear solver is the fastest (case procedures_examples).
  for (const char* jacobian : {"exact", "b_derivative"})
    procedures.push_back({"monolithic", jacobian, "auto", "gmres_adaptive", "bodies"});
  for (const Example& example : runner.quick ? coarse_examples() : paper_examples()) {
    scenes::Solution standard;
    std::vector<Procedure> here = procedures;
    // Dense bodies of the paper's size take half an hour.
    if (runner.quick || example.name.find("FEM") != std::string::npos)
      here.push_back({.system = "monolithic", .jacobian = "exact", .linear_solver = "lu"});
    for (const Procedure& procedure : here) {
      Record record{.case_name = "procedures_speed", .method = procedure.name()};
      record.model = example.name;
      record.threads = runner.threads;
      record.quantity = "seconds from arrays to tractions";
      record.against = "tractions of " + Procedure{}.name();
      record.error = NAN;
      try {
        const double began = now();
        const auto pair = example.make(runner.threads);
        apply(procedure, *pair);
        const scenes::Solution s = timed_solve(*pair, record, began);
        record.extra.emplace_back("factorizations", pair->stat("factorizations"));
        add_body_unknowns(record, *pair);
        if (standard.nodes() == 0) standard = s;
        record.value = record.seconds;
        record.error = traction_difference(standard, s);
        if (converged(record)) add_resolves(record, *pair, s);
      } catch (const std::exception& e) {
        record.status = -1;
        std::fprintf(stderr, "procedures_speed, %s, %s: %s\n", record.model.c_str(), record.method.c_str(), e.what());
      }
      record.mesh = std::to_string(record.nodes) + " nodes";
      runner.emit(record);
    }
    if (runner.quick) break;
  }
}

}  // namespace

std::vector<Case> procedure_examples_cases() {
  return {{"procedures_examples", "every solution procedure on the paper's four examples, coarse", combinations},
          {"procedures_speed", "standard against monolithic procedures, cold and on re-solve", speed}};
}

}  // namespace rollcon::bench
