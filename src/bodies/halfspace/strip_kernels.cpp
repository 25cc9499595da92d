#include "bodies/halfspace/strip_kernels.hpp"

namespace rollcon::strips {

extern const StripKernels kernels_baseline, kernels_avx2, kernels_avx512;

const StripKernels& strip_kernels(InstructionSet set) {
  return chosen(set, kernels_baseline, kernels_avx2, kernels_avx512);
}

}  // namespace rollcon::strips
