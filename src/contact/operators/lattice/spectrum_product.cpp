#include "contact/operators/lattice/spectrum_product.hpp"

namespace rollcon {

extern const SpectrumProducts products_baseline, products_avx2, products_avx512;

SpectrumProducts spectrum_products(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return products_avx512;
    case InstructionSet::avx2:
      return products_avx2;
    case InstructionSet::baseline:
      break;
  }
  return products_baseline;
}

}  // namespace rollcon
