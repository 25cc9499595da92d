#pragma once
/// Sets solution procedures by the options of a contact, for tests of the public interface, validation and benches.

#include <cstdint>
#include <string>
#include <vector>

namespace rollcon::scenes {

/// Names one way of solving; the initial values are the standard one.
struct Procedure {
  std::string system = "condensed", jacobian = "exact", slip_estimate = "auto";
  std::string linear_solver = "auto", preconditioner = "auto";
  std::int64_t max_iterations = 0;  ///< 0: not set

  /// Returns the names in this order, with blanks between them.
  std::string name() const {
    return system + " " + jacobian + " " + slip_estimate + " " + linear_solver + " " + preconditioner;
  }
  /// Calls set(option, name) for each, and set("procedure", choices).
  template <class Set>
  void each(Set&& set) const {
    set("procedure", ("system=" + system + " jacobian=" + jacobian + " slip_estimate=" + slip_estimate).c_str());
    set("linear_solver", linear_solver.c_str());
    set("preconditioner", preconditioner.c_str());
  }
  template <class Pair>
  void apply(Pair& pair) const {
    each([&](const char* option, const char* value) { pair.option(option, value); });
  }
  bool operator==(const Procedure&) const = default;
};

inline constexpr const char* systems[] = {"condensed", "monolithic"};
inline constexpr const char* linear_solvers[] = {"lu", "gmres", "gmres_adaptive"};
inline constexpr const char* slip_estimates[] = {"jacobi", "pseudo_temporal", "extrapolation"};

/// Returns Jacobians, and with reduced unknowns the slip estimates, times the linear solvers.
inline std::vector<Procedure> procedures_by_solver(const std::string& system) {
  std::vector<Procedure> all;
  for (const char* jacobian : {"exact", "b_derivative", "simplified"})
    for (const char* solver : linear_solvers) all.push_back({system, jacobian, "auto", solver});
  for (const char* estimate : slip_estimates)
    for (const char* solver : linear_solvers) all.push_back({system, "reduced", estimate, solver});
  return all;
}

}  // namespace rollcon::scenes
