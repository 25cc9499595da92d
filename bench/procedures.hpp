#pragma once
/// The published solution procedures beside the standard one: what is common to their cases.

#include <memory>
#include <string>
#include <vector>

#include "bench.hpp"

namespace rollcon::bench {

/// Enough for the slowest procedure.
inline constexpr std::int64_t most_iterations = 3000;

/// One way of solving, by the options of a contact.
struct Procedure {
  std::string system = "condensed", jacobian = "exact", slip_estimate = "auto";
  std::string linear_solver = "auto", preconditioner = "auto";
  std::int64_t max_iterations = most_iterations;

  /// The first five in this order, blanks between them.
  std::string name() const;
  void apply(scenes::RollingPair& pair) const;
  bool operator==(const Procedure&) const = default;
};

inline constexpr const char* systems[] = {"condensed", "monolithic"};
inline constexpr const char* linear_solvers[] = {"lu", "gmres", "gmres_adaptive"};
inline constexpr const char* slip_estimates[] = {"jacobi", "pseudo_temporal", "extrapolation"};

/// Jacobians, and with reduced unknowns the slip estimates, times the linear solvers.
std::vector<Procedure> procedures_of(const std::string& system);

/// Solves from zero tractions on what is already prepared (`fresh`: from arrays, `began` says
/// when) and fills the record but for quantity, value and error: method, sizes, time, the error
/// function of every iteration. A solve that is refused or fails keeps its message and a negative
/// status. `repeats`: the fastest of so many short solves counts.
scenes::Solution solve_by(const Procedure& procedure, scenes::RollingPair& pair, Record& record,
                          int repeats = 1);

/// Unknowns of both bodies, where they have any of their own, as an extra.
void add_body_unknowns(Record& record, const scenes::RollingPair& pair);

/// Seconds of the last solve without the bodies' compliance and the frame's convection.
double solving_seconds(const scenes::RollingPair& pair);

/// Largest difference of nodal tractions, normal ones over the largest pressure and tangential ones
/// over the largest tangential one. NaN: not the same frame.
double traction_difference(const scenes::Solution& a, const scenes::Solution& b);

/// The status of a record is that of a solution.
bool converged(const Record& record);

/// The paper's examples on meshes so coarse that every procedure can be run on them.
struct Example {
  std::string name;
  std::unique_ptr<scenes::RollingPair> (*make)(int threads);
  bool condensed_only = false;  ///< takes long in monolithic form
};
std::vector<Example> coarse_examples();
/// Examples 1, 2 and 4 on the paper's meshes.
std::vector<Example> paper_examples();

/// procedure_cases() strings them together.
std::vector<Case> procedure_example3_cases();
std::vector<Case> procedure_example4_cases();
std::vector<Case> procedure_examples_cases();
std::vector<Case> procedure_random_cases();
std::vector<Case> preconditioner_cases();

}  // namespace rollcon::bench
