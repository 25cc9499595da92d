#include "bodies/halfspace/lattice_far_set.hpp"

namespace rollcon::halfspace {

extern const LatticeFarFunction lattice_far_avx512;
const LatticeFarFunction lattice_far_avx512 = far_any;

}  // namespace rollcon::halfspace
