#include "bodies/bem/kelvin.hpp"

#include <numbers>

namespace rollcon::bem {

extern const Kernels kelvin_baseline, kelvin_avx2, kelvin_avx512;

KelvinConstants::KelvinConstants(double poisson)
    : skew(-(1 - 2 * poisson) / (8 * std::numbers::pi * (1 - poisson))),
      triple(-3 / (8 * std::numbers::pi * (1 - poisson))),
      iso((3 - 4 * poisson) / (16 * std::numbers::pi * (1 - poisson))),
      single(1 / (16 * std::numbers::pi * (1 - poisson))) {}

const Kernels& kelvin_kernels(InstructionSet set) {
  return chosen(set, kelvin_baseline, kelvin_avx2, kelvin_avx512);
}

}  // namespace rollcon::bem
