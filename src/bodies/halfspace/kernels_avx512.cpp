#include "bodies/halfspace/kernel_set.hpp"

namespace rollcon::halfspace {

extern const Kernels kernels_avx512;
const Kernels kernels_avx512 = {"avx512", far, push, near};

}  // namespace rollcon::halfspace
