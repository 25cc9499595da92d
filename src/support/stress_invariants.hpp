#pragma once
/// What yield criteria want of a stress.

namespace rollcon {

struct StressInvariants {
  double principal[3];  ///< the largest first
  double von_mises;
  double shear;  ///< the largest
};

/// stress: 11, 22, 33, 12, 13, 23, finite.
StressInvariants stress_invariants(const double* stress);

}  // namespace rollcon
