#include "bodies/halfspace/kernel_set.hpp"

namespace rollcon::halfspace {

extern const Kernels kernels_avx2;
const Kernels kernels_avx2 = {"avx2", far, push, near};

}  // namespace rollcon::halfspace
