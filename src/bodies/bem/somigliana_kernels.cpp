#include "bodies/bem/somigliana_kernels.hpp"

namespace rollcon::bem {

extern const SomiglianaKernels somigliana_baseline, somigliana_avx2, somigliana_avx512;

const SomiglianaKernels& somigliana_kernels(InstructionSet set) {
  return chosen(set, somigliana_baseline, somigliana_avx2, somigliana_avx512);
}

}  // namespace rollcon::bem
