#pragma once
/// Solves a prepared scene by Newton's iteration, or by a published procedure.

#include <memory>

#include "contact/effort.hpp"
#include "contact/newton/newton.hpp"
#include "contact/solution.hpp"

namespace rollcon {

/// Stands for one of the published procedures (src/procedures/), which solves in place of Newton's iteration.
class PublishedSolver {
 public:
  virtual ~PublishedSolver() = default;
  /// Solves the prepared scene from solution.iterate; fills report and effort. Throws the errors of its linear systems.
  virtual void run(Solution& solution, Newton& newton, Effort& effort, const Options& options, Monitor& monitor) = 0;
  virtual std::size_t bytes() const = 0;
};

/// Holds what solves, with what it keeps for the next solve: factors, predictions, storage.
struct Engine {
  Newton newton;
  MakePublished make_published = nullptr;      ///< null: the build has no published procedures
  std::unique_ptr<PublishedSolver> published;  ///< made when one is asked for

  std::size_t bytes() const { return newton.bytes() + (published ? published->bytes() : 0); }
};

/// Solves the prepared scene from solution.iterate; fills report and effort. Throws Error as the linear systems do.
void solve_prepared(Engine& engine, Solution& solution, Effort& effort, const Options& options, Monitor& monitor);

}  // namespace rollcon
