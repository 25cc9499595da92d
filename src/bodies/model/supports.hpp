#pragma once
/// Do the supports of a body hold it, and does its material allow them?

#include "bodies/model/body_mesh.hpp"

namespace rollcon {

/// Throws err_singular, naming the motion that is left and the remedy, when the held displacement components leave the
/// body free to move as a rigid one.
void require_supports(const BodyMesh& mesh);

/// Boundary elements lose sight of the volume of a cavity as nu -> 1/2: the single layer of a normal traction on a
/// closed surface vanishes. Throws err_unsupported, naming the cavity's first element and the remedy, for nu beyond
/// 0.49 and a cavity no face of which is held. The mesh must have passed check_surface. Likewise for nu = 1/2 and a
/// body held all over, whose pressure is then undetermined.
void refuse_incompressible_cavities(const BodyMesh& mesh, double poisson);

}  // namespace rollcon
