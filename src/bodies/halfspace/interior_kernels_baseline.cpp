#include "bodies/halfspace/interior_kernel_set.hpp"

namespace rollcon::halfspace {

extern const InteriorKernels interior_kernels_baseline;
const InteriorKernels interior_kernels_baseline = {"baseline", push, element};

}  // namespace rollcon::halfspace
