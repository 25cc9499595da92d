#include "bodies/halfspace/kernels.hpp"

namespace rollcon::halfspace {

extern const Kernels kernels_baseline, kernels_avx2, kernels_avx512;

const Kernels& kernels(InstructionSet set) {
  return chosen(set, kernels_baseline, kernels_avx2, kernels_avx512);
}

}  // namespace rollcon::halfspace
