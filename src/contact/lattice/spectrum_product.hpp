#pragma once
/// Inner loop of convolutions: products of spectra, one set of functions per instruction set.

#include <cstdint>

#include "bodies/halfspace/kernels.hpp"

namespace rollcon {

/// sum[k] = sum over terms of factor * spectrum * field[k], complex numbers as pairs, k < count.
template <class T>
struct SpectrumProduct {
  int terms = 0;  ///< 1 to 3
  const T* spectrum[3] = {};
  const T* field[3] = {};
  T factor[3] = {};
  T* sum = nullptr;
  std::int64_t count = 0;
};

template <class T>
struct SpectrumProducts {
  void (*same)(const SpectrumProduct<T>&);      ///< spectrum[k]
  void (*reversed)(const SpectrumProduct<T>&);  ///< spectrum[count - 1 - k]
};

template <class T>
SpectrumProducts<T> spectrum_products(halfspace::InstructionSet set);

}  // namespace rollcon
