#include "bodies/halfspace/interior_kernel_set.hpp"

namespace rollcon::halfspace {

extern const InteriorKernels interior_kernels_avx512;
const InteriorKernels interior_kernels_avx512 = {"avx512", push, element};

}  // namespace rollcon::halfspace
