#include "bodies/bem/somigliana_set.hpp"

namespace rollcon::bem {

extern const SomiglianaKernels somigliana_avx2;
const SomiglianaKernels somigliana_avx2 = {"avx2", face};

}  // namespace rollcon::bem
