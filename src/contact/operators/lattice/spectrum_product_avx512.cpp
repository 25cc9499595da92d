#include "contact/operators/lattice/spectrum_product_set.hpp"

namespace rollcon {

extern const SpectrumProducts products_avx512;
const SpectrumProducts products_avx512 = products;

}  // namespace rollcon
