/// Stands in for volume meshes in a build without finite-element bodies. It is never reached, because no other body has
/// volume elements.

#include "mesh/volume_boundary.hpp"
#include "mesh/volume_faces.hpp"
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

std::array<std::int32_t, 4> sorted_corners(std::span<const std::int32_t> /*corner*/) {
  refuse();
}

std::vector<CornerFace> sorted_faces(const VolumeElements& /*volume*/) {
  refuse();
}

void check_volume(std::span<const Vec3> /*node*/, const VolumeElements& /*volume*/, std::int32_t /*index_base*/) {
  refuse();
}

}  // namespace rollcon
