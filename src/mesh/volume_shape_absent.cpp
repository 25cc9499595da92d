/// Stands in for the shapes of volume elements in a build without finite-element bodies. It is never reached, because
/// no other body has volume elements.

#include "mesh/volume_shape.hpp"
#include "support/error.hpp"

namespace rollcon {

std::span<const VolumeFace> faces_of(VolumeType /*type*/) {
  fail(Status::err_unsupported,
       "this build of rollcon has no volume elements (component FEM: ROLLCON_WITH_FEM is OFF)");
}

}  // namespace rollcon
