#include "contact/operators/lattice/spectrum_product.hpp"

namespace rollcon {

extern const SpectrumProducts products_baseline, products_avx2, products_avx512;

SpectrumProducts spectrum_products(InstructionSet set) {
  return chosen(set, products_baseline, products_avx2, products_avx512);
}

}  // namespace rollcon
