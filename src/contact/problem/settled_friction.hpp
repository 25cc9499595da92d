#pragma once
/// Holds the coefficients that the last solve ended with, where friction follows the whole solution.

#include <cstdint>
#include <vector>

namespace rollcon {

struct SettledFriction {
  /// Coefficient of each node over what its law reaches at most; empty: a solve starts from nothing.
  std::vector<double> utilisation;
  std::int64_t rounds = 0;  ///< solves with given coefficients
  double change = 0;        ///< change of mu p in the last one, over the greatest mu p
};

}  // namespace rollcon
