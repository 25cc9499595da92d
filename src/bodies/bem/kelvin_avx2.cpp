#include "bodies/bem/kelvin_set.hpp"

namespace rollcon::bem {

extern const Kernels kelvin_avx2;
const Kernels kelvin_avx2 = {"avx2", place, far, near};

}  // namespace rollcon::bem
