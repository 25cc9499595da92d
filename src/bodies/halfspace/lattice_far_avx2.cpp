#include "bodies/halfspace/lattice_far_set.hpp"

namespace rollcon::halfspace {

extern const LatticeFarFunction lattice_far_avx2;
const LatticeFarFunction lattice_far_avx2 = far_any;

}  // namespace rollcon::halfspace
