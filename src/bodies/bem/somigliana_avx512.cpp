#include "bodies/bem/somigliana_set.hpp"

namespace rollcon::bem {

extern const SomiglianaKernels somigliana_avx512;
const SomiglianaKernels somigliana_avx512 = {"avx512", face};

}  // namespace rollcon::bem
