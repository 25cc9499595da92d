#pragma once
/// Do the supports of a body hold it?

#include "bodies/body_mesh.hpp"

namespace rollcon {

/// Throws err_singular, naming the motion that is left and the remedy, when the held displacement
/// components leave the body free to move as a rigid one.
void require_supports(const BodyMesh& mesh);

}  // namespace rollcon
