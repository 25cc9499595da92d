#include "bodies/bem/somigliana_set.hpp"

namespace rollcon::bem {

extern const SomiglianaKernels somigliana_baseline;
const SomiglianaKernels somigliana_baseline = {"baseline", face};

}  // namespace rollcon::bem
