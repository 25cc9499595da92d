#pragma once
/// Describes materials that relax, by Prony series of the relaxation modulus and of the creep function. Poisson's ratio
/// does not change.

#include <cstdint>
#include <vector>

namespace rollcon {

/// Holds a term of the modulus E(t) = E0 (1 - sum of ratio (1 - exp(-t / time))), or of the creep function J(t) =
/// (1 + sum of ratio (1 - exp(-t / time))) / E0.
struct PronyTerm {
  double ratio = 0, time = 0;
  bool operator==(const PronyTerm&) const = default;
};

/// Checks a relaxation function of a caller and returns it with ascending times. Terms of equal times become one, and
/// terms of ratio 0 are left out. Throws err_argument and err_nonfinite.
std::vector<PronyTerm> checked_relaxation(std::int64_t n, const double* ratios, const double* times);

/// Converts a checked relaxation function to the creep function of the material, which has as many terms: zeros of the
/// modulus as a function of the rate are poles of its inverse.
std::vector<PronyTerm> creep_of(const std::vector<PronyTerm>& relaxation);

}  // namespace rollcon
