#pragma once
/// Reads Gmsh's format .msh.

#include <string>

#include "io/mesh_file.hpp"

namespace rollcon {

/// Reads versions 2 to 2.2 and 4.1, text or binary. Throws err_io.
MeshFile read_gmsh_file(const std::string& path);

}  // namespace rollcon
