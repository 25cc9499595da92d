#pragma once
/// Solves the load cases of a list, by one object for each thread: on the frame of the scene, whose operators,
/// compliance and bodies all threads read; or each on frames of its own.

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

class Solver;

class CaseSolver {
 public:
  virtual ~CaseSolver() = default;

  /// Makes the next case start cold, whatever was solved before.
  virtual void begin_chain() = 0;
  /// Solves one case, starting from the last one of the chain if that converged; value[i] belongs to parameter[i].
  /// Returns its status >= 0; throws Error.
  virtual Status solve(std::span<const Parameter> parameter, const double* value, Monitor& monitor) = 0;

  /// Writes what a column says of the last case: derivatives by each parameter's value, NaN where there are none.
  virtual void write(const CaseColumn& column, std::span<const Parameter> parameter, const double* value,
                     double* to) = 0;

  /// Counts what this solver holds beyond what all use together.
  virtual std::size_t bytes() const = 0;
};

class SharedFrameSolver final : public CaseSolver {
 public:
  /// Makes a solver on the frame of `scene`, which must be prepared and outlive this object unchanged.
  explicit SharedFrameSolver(const Solver& scene);
  ~SharedFrameSolver() override;

  void begin_chain() override;
  Status solve(std::span<const Parameter> parameter, const double* value, Monitor& monitor) override;
  void write(const CaseColumn& column, std::span<const Parameter> parameter, const double* value, double* to) override;
  std::size_t bytes() const override;

 private:
  void derivatives(std::span<const Parameter> parameter, const double* value, double* d);

  std::unique_ptr<Solver> solver_;
  Prescribed given_;           ///< givens of the last case
  bool frictionless_ = false;  ///< scene has no friction
  bool warm_ = false;
};

}  // namespace rollcon
