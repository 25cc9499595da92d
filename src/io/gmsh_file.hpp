#pragma once
/// Gmsh's format .msh.

#include <string>

#include "io/mesh_file.hpp"

namespace rollcon {

/// Versions 2 to 2.2 and 4.1, text or binary. err_io.
MeshFile read_gmsh_file(const std::string& path);

}  // namespace rollcon
