#include "contact/lattice/spectrum_product_set.hpp"

namespace rollcon {

extern const SpectrumProducts<double> products_double_avx2;
extern const SpectrumProducts<float> products_float_avx2;
const SpectrumProducts<double> products_double_avx2 = products<double>;
const SpectrumProducts<float> products_float_avx2 = products<float>;

}  // namespace rollcon
