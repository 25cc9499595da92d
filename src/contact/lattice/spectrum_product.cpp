#include "contact/lattice/spectrum_product.hpp"

namespace rollcon {

extern const SpectrumProducts<double> products_double_baseline, products_double_avx2,
    products_double_avx512;
extern const SpectrumProducts<float> products_float_baseline, products_float_avx2,
    products_float_avx512;

template <>
SpectrumProducts<double> spectrum_products(halfspace::InstructionSet set) {
  switch (set) {
    case halfspace::InstructionSet::avx512:
      return products_double_avx512;
    case halfspace::InstructionSet::avx2:
      return products_double_avx2;
    case halfspace::InstructionSet::baseline:
      break;
  }
  return products_double_baseline;
}

template <>
SpectrumProducts<float> spectrum_products(halfspace::InstructionSet set) {
  switch (set) {
    case halfspace::InstructionSet::avx512:
      return products_float_avx512;
    case halfspace::InstructionSet::avx2:
      return products_float_avx2;
    case halfspace::InstructionSet::baseline:
      break;
  }
  return products_float_baseline;
}

}  // namespace rollcon
