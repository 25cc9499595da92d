#pragma once
/// Computes what yield criteria need of a stress.

namespace rollcon {

struct StressInvariants {
  double principal[3];  ///< the largest first
  double von_mises;
  double shear;  ///< the largest shear stress
};

/// Takes the components 11, 22, 33, 12, 13, 23, which must be finite.
StressInvariants stress_invariants(const double* stress);

}  // namespace rollcon
