#pragma once
/// Multiplies spectra, the inner loop of convolutions, by one set of functions per instruction set.

#include <cstdint>

#include "support/instruction_set.hpp"

namespace rollcon {

/// Describes sum[k] = sum over terms of factor * spectrum * field[k], complex numbers as pairs, k < count.
struct SpectrumProduct {
  int terms = 0;  ///< 1 to 3
  const double* spectrum[3] = {};
  const double* field[3] = {};
  double factor[3] = {};
  double* sum = nullptr;
  std::int64_t count = 0;
};

struct SpectrumProducts {
  void (*same)(const SpectrumProduct&);      ///< takes spectrum[k]
  void (*reversed)(const SpectrumProduct&);  ///< takes spectrum[count - 1 - k]
};

SpectrumProducts spectrum_products(InstructionSet set);

}  // namespace rollcon
