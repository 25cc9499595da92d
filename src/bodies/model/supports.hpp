#pragma once
/// Checks that the supports of a body hold it, and that its material allows them.

#include "bodies/model/body_mesh.hpp"

namespace rollcon {

/// Throws err_singular, naming the motion that is left and the remedy, when the held displacement components leave the
/// body free to move as a rigid one.
/// stiffness: a matrix of all displacement components that resists motions, too; null: there is none.
void require_supports(const BodyMesh& mesh, const RowMatrix<double>* stiffness = nullptr);

/// Throws err_unsupported, naming the first element and the remedy, for nu beyond 0.49 and a cavity no face of which is
/// held: boundary elements lose sight of its volume as nu -> 1/2, where the single layer of a normal traction on a
/// closed surface vanishes. Throws it also for nu = 1/2 and a body held all over, whose pressure is then undetermined.
/// The mesh must have passed check_surface.
void refuse_incompressible_cavities(const BodyMesh& mesh, double poisson);

}  // namespace rollcon
