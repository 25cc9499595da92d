/// In place of volume meshes, in a build without finite-element bodies. Not reached: no other body has volume elements.

#include "mesh/volume_boundary.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

[[noreturn]] void refuse() {
  fail(Status::err_unsupported,
       "this build of rollcon has no volume elements (component FEM: ROLLCON_WITH_FEM is OFF)");
}

}  // namespace

std::vector<BoundaryFace> boundary_faces(const VolumeElements& /*volume*/) {
  refuse();
}

SurfaceMesh boundary_surface(const VolumeElements& /*volume*/, std::span<const BoundaryFace> /*face*/) {
  refuse();
}

void check_volume(std::span<const Vec3> /*node*/, const VolumeElements& /*volume*/, std::int32_t /*index_base*/) {
  refuse();
}

}  // namespace rollcon
