#include "bodies/halfspace/interior_kernel_set.hpp"

namespace rollcon::halfspace {

extern const InteriorKernels interior_kernels_avx2;
const InteriorKernels interior_kernels_avx2 = {"avx2", push, element};

}  // namespace rollcon::halfspace
