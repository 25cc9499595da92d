#pragma once
/// How far the last solution is from that of the continuous problem of the same bodies: estimated
/// from the gap between the nodes, another convective scheme and a coarser frame (docs/theory.md,
/// section 8). Found when first asked for and kept until the next solve; it changes nothing else.

namespace rollcon {

/// Relative, and of the forces that go with the motions of the solution.
struct ErrorEstimate {
  bool known = false;
  double normal = 0;      ///< normal force, over itself
  double tangential = 0;  ///< tangential force, over the integral of |tangential traction|
  double tractions = 0;   ///< L2 norm; of pressures or of tangential tractions, whichever is worse
  double seconds = 0;     ///< what finding it took

  /// NaN where either is.
  double worst() const { return tangential <= normal || normal != normal ? normal : tangential; }
};

struct SolverState;

/// 0 without contact; 1 where nothing can be said: the solve did not converge, or the frame has too
/// few nodes to leave any out.
const ErrorEstimate& find_error_estimate(SolverState& state);

}  // namespace rollcon
