#include "contact/operators/lattice/spectrum_product_set.hpp"

namespace rollcon {

extern const SpectrumProducts products_baseline;
const SpectrumProducts products_baseline = products;

}  // namespace rollcon
