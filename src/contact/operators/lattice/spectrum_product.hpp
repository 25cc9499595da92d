#pragma once
/// Inner loop of convolutions: products of spectra, one set of functions per instruction set.

#include <cstdint>

#include "support/instruction_set.hpp"

namespace rollcon {

/// sum[k] = sum over terms of factor * spectrum * field[k], complex numbers as pairs, k < count.
struct SpectrumProduct {
  int terms = 0;  ///< 1 to 3
  const double* spectrum[3] = {};
  const double* field[3] = {};
  double factor[3] = {};
  double* sum = nullptr;
  std::int64_t count = 0;
};

struct SpectrumProducts {
  void (*same)(const SpectrumProduct&);      ///< spectrum[k]
  void (*reversed)(const SpectrumProduct&);  ///< spectrum[count - 1 - k]
};

SpectrumProducts spectrum_products(InstructionSet set);

}  // namespace rollcon
