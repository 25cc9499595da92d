#include "bodies/bem/kelvin_set.hpp"

namespace rollcon::bem {

extern const Kernels kelvin_avx512;
const Kernels kelvin_avx512 = {"avx512", place, far, near};

}  // namespace rollcon::bem
