#include "bodies/halfspace/kernel_set.hpp"

namespace rollcon::halfspace {

extern const Kernels kernels_baseline;
const Kernels kernels_baseline = {"baseline", far, push, near};

}  // namespace rollcon::halfspace
