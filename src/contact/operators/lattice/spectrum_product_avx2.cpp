#include "contact/operators/lattice/spectrum_product_set.hpp"

namespace rollcon {

extern const SpectrumProducts products_avx2;
const SpectrumProducts products_avx2 = products;

}  // namespace rollcon
