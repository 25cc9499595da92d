#include "contact/operators/lattice/spectrum_product.hpp"

namespace rollcon {

extern const SpectrumProducts products_baseline, products_avx2, products_avx512;

SpectrumProducts spectrum_products(halfspace::InstructionSet set) {
  switch (set) {
    case halfspace::InstructionSet::avx512:
      return products_avx512;
    case halfspace::InstructionSet::avx2:
      return products_avx2;
    case halfspace::InstructionSet::baseline:
      break;
  }
  return products_baseline;
}

}  // namespace rollcon
