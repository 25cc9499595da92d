#include "contact/lattice/spectrum_product_set.hpp"

namespace rollcon {

extern const SpectrumProducts<double> products_double_avx512;
extern const SpectrumProducts<float> products_float_avx512;
const SpectrumProducts<double> products_double_avx512 = products<double>;
const SpectrumProducts<float> products_float_avx512 = products<float>;

}  // namespace rollcon
