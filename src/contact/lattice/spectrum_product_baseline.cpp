#include "contact/lattice/spectrum_product_set.hpp"

namespace rollcon {

extern const SpectrumProducts<double> products_double_baseline;
extern const SpectrumProducts<float> products_float_baseline;
const SpectrumProducts<double> products_double_baseline = products<double>;
const SpectrumProducts<float> products_float_baseline = products<float>;

}  // namespace rollcon
