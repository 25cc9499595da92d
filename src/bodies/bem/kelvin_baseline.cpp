#include "bodies/bem/kelvin_set.hpp"

namespace rollcon::bem {

extern const Kernels kelvin_baseline;
const Kernels kelvin_baseline = {"baseline", place, far, near};

}  // namespace rollcon::bem
