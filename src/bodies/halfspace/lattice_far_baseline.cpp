#include "bodies/halfspace/lattice_far_set.hpp"

namespace rollcon::halfspace {

extern const LatticeFarFunction lattice_far_baseline;
const LatticeFarFunction lattice_far_baseline = far_any;

}  // namespace rollcon::halfspace
