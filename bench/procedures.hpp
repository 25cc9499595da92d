#pragma once
/// Compares the published solution procedures with the standard one; this is what their cases have in common.

#include <memory>
#include <string>
#include <vector>

#include "bench.hpp"
#include "support/procedures.hpp"

namespace rollcon::bench {

/// The limit of procedures that name no other number is enough for the slowest.
inline constexpr std::int64_t most_iterations = 3000;

using scenes::linear_solvers;
using scenes::Procedure;
using scenes::procedures_by_solver;
using scenes::slip_estimates;
using scenes::systems;
using scenes::traction_difference;

void apply(const Procedure& procedure, scenes::RollingPair& pair);

/// Solves from zero tractions on what is already prepared (`fresh`: from arrays, `began` says when) and fills the
/// record except for quantity, value and error: method, sizes, time, the error function of every iteration. A solve
/// that is refused or fails leaves its message and a negative status. `repeats`: the fastest of so many short solves
/// counts.
scenes::Solution solve_by(const Procedure& procedure, scenes::RollingPair& pair, Record& record, int repeats = 1);

/// Adds the unknowns of both bodies, where they have any of their own, as an extra.
void add_body_unknowns(Record& record, const scenes::RollingPair& pair);

/// Returns the seconds of the last solve without the bodies' compliance and the frame's convection.
double solving_seconds(const scenes::RollingPair& pair);

/// Says whether the status of a record is that of a solution.
bool converged(const Record& record);

/// Describes the paper's examples on meshes so coarse that every procedure can be run on them.
struct Example {
  std::string name;
  std::unique_ptr<scenes::RollingPair> (*make)(int threads);
  bool condensed_only = false;  ///< true if it takes long in monolithic form
};
std::vector<Example> coarse_examples();
/// Returns examples 1, 2 and 4 on the paper's meshes.
std::vector<Example> paper_examples();

/// Each of these returns cases that procedure_cases() strings together.
std::vector<Case> procedure_example3_cases();
std::vector<Case> procedure_example4_cases();
std::vector<Case> procedure_examples_cases();
std::vector<Case> procedure_random_cases();
std::vector<Case> preconditioner_cases();

}  // namespace rollcon::bench
