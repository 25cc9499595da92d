#pragma once
/// Load cases of one prepared scene, solved by several threads side by side. Each has a solver state of its own, but
/// operators, compliance and bodies are the scene's, read only.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "contact/cases/solve_many.hpp"
#include "contact/newton/newton.hpp"
#include "contact/scene/enumerators.hpp"
#include "contact/scene/options.hpp"

namespace rollcon {

struct SolverState;

/// Whether a state can serve several threads at once: not with the systems of published procedures.
bool can_share(const SolverState& state);

class CaseSolver {
 public:
  /// `scene` must be prepared, and outlive this object unchanged.
  CaseSolver(const SolverState& scene, const Options& options);
  ~CaseSolver();

  /// The next case starts cold, whatever was solved before.
  void begin_chain();
  /// Solves one case, starting from the last one of the chain if that converged. parameter: what value[i] is of.
  /// Returns its status >= 0; throws Error.
  Status solve(std::span<const Parameter> parameter, const double* value, Monitor& monitor);

  /// What a column says of the last case; derivatives by each parameter's value, NaN where there are none.
  void write(const CaseColumn& column, std::span<const Parameter> parameter, const double* value, double* to);

  /// What this solver holds beyond what it shares.
  std::size_t bytes() const;

 private:
  void derivatives(std::span<const Parameter> parameter, const double* value, double* d);
  void prescribe(std::span<const Parameter> parameter, const double* value);

  const Options& options_;
  std::unique_ptr<SolverState> state_;
  bool frictionless_ = false;  ///< the scene
  bool warm_ = false;
};

}  // namespace rollcon
