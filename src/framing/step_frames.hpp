#pragma once
/// Chooses the regular frames of time steps. They stay from step to step as long as they fit the contact; otherwise
/// they get more or fewer of the same cells, or cells of half or twice the size.

#include <cstdint>

#include "contact/solver.hpp"
#include "framing/makers.hpp"
#include "geometry/rectangle.hpp"

namespace rollcon {

/// Holds what a lattice has to fit.
struct StepContact {
  Rectangle box{};               ///< around all of the contact, with a margin
  double length = 0, width = 0;  ///< extents of its smallest patch along t1 and t2
  double accuracy = 0;
};

class StepFrames {
 public:
  /// Solves a step on half-spaces. Returns and throws what Solver::solve does; inaccurate where the step is too long.
  Status solve(Solver& solver, const StepContact& contact);
  /// Gives the solver's scene a lattice with these sides and numbers of cells.
  void lay(Solver& solver, const Rectangle& sides, std::int64_t along, std::int64_t across);
  /// Returns the lattice that was laid last.
  const RectangleCells& laid() const { return laid_; }
  /// Says whether the scene has this lattice.
  bool lies(const Solver& solver, const RectangleCells& cells) const;

 private:
  RectangleCells laid_;
  std::int64_t mesh_ = -1, axes_ = -1;  ///< revisions of the scene when the last lattice was laid
};

}  // namespace rollcon
