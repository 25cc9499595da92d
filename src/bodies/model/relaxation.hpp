#pragma once
/// Describes bodies whose material relaxes: Prony series of the relaxation modulus and of the creep function, with a
/// Poisson's ratio that does not change.

#include <cstdint>
#include <vector>

namespace rollcon {

/// A term of E(t) = E0 (1 - sum of ratio (1 - exp(-t / time))), or of J(t) = (1 + sum of ratio (1 - exp(-t / time))) /
/// E0.
struct PronyTerm {
  double ratio = 0, time = 0;
  bool operator==(const PronyTerm&) const = default;
};

/// Checks a relaxation function as a caller gives it and returns it with ascending times, terms of one time together
/// and those of ratio 0 left out. err_argument, err_nonfinite.
std::vector<PronyTerm> checked_relaxation(std::int64_t n, const double* ratios, const double* times);

/// Converts a relaxation function, checked, to the creep function of the material, which has as many terms: the zeros
/// of the modulus as a function of the rate are the poles of its inverse.
std::vector<PronyTerm> creep_of(const std::vector<PronyTerm>& relaxation);

}  // namespace rollcon
