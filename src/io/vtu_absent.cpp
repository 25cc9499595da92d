/// Stands in for VTU files in a build without them.

#include "io/vtu.hpp"
#include "support/error.hpp"

namespace rollcon {

namespace {

[[noreturn]] void refuse(const std::string& path) {
  fail(Status::err_unsupported,
       "cannot write '%s': this build of rollcon writes no VTU files (component VTU: "
       "ROLLCON_WITH_VTU is OFF)",
       path.c_str());
}

}  // namespace

void write_vtu(const std::string& path, const SurfaceMesh& /*mesh*/, std::span<const PointArray> /*arrays*/) {
  refuse(path);
}

void write_vtu(const std::string& path, const SurfaceMesh& /*surface*/, const VolumeElements& /*volume*/,
               std::span<const PointArray> /*arrays*/) {
  refuse(path);
}

}  // namespace rollcon
