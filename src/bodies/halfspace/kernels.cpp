#include "bodies/halfspace/kernels.hpp"

namespace rollcon::halfspace {

extern const Kernels kernels_baseline, kernels_avx2, kernels_avx512;

const Kernels& kernels(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return kernels_avx512;
    case InstructionSet::avx2:
      return kernels_avx2;
    case InstructionSet::baseline:
      break;
  }
  return kernels_baseline;
}

}  // namespace rollcon::halfspace
