#pragma once
/// Describes materials that relax, by Prony series of the relaxation modulus and of the creep function, or by moduli
/// over frequency. Poisson's ratio does not change.

#include <complex>
#include <cstdint>
#include <vector>

namespace rollcon {

/// Holds a term of the modulus E(t) = E0 (1 - sum of ratio (1 - exp(-t / time))), or of the creep function J(t) =
/// (1 + sum of ratio (1 - exp(-t / time))) / E0.
struct PronyTerm {
  double ratio = 0, time = 0;
  bool operator==(const PronyTerm&) const = default;
};

/// Holds the storage and loss modulus, as parts of Young's modulus, at an angular frequency.
struct ModulusPoint {
  double frequency = 0, storage = 0, loss = 0;
  bool operator==(const ModulusPoint&) const = default;
};

/// Says how a material relaxes.
struct Relaxation {
  std::vector<PronyTerm> term;      ///< with ascending times
  std::vector<ModulusPoint> point;  ///< with ascending frequencies, if moduli were given: the terms fit them
  double misfit = 0;                ///< largest error of the terms relative to a modulus given
  bool operator==(const Relaxation&) const = default;
  /// Returns the complex modulus, as a part of Young's modulus, at an angular frequency. It is linear in
  /// the logarithm of the frequency between points; beyond them the storage modulus stays and the loss modulus fades.
  std::complex<double> modulus(double frequency) const;
};

/// Checks moduli of a caller, and fits a Prony series to them. `young` becomes the modulus at once. Throws err_argument
/// and err_nonfinite.
Relaxation checked_moduli(std::int64_t n, const double* frequencies, const double* storage, const double* loss,
                          double& young);

/// Checks a relaxation function of a caller and returns it with ascending times. Terms of equal times become one, and
/// terms of ratio 0 are left out. Throws err_argument and err_nonfinite.
std::vector<PronyTerm> checked_relaxation(std::int64_t n, const double* ratios, const double* times);

/// Converts a checked relaxation function to the creep function of the material, which has as many terms: zeros of the
/// modulus as a function of the rate are poles of its inverse.
std::vector<PronyTerm> creep_of(const std::vector<PronyTerm>& relaxation);

}  // namespace rollcon
