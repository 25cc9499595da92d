#pragma once
/// Reads input files of Abaqus and CalculiX.

#include <string>

#include "io/mesh_file.hpp"

namespace rollcon {

/// Reads nodes, elements, sets of both and surfaces; passes over all other keywords, except those that make or move
/// nodes, which fail. Throws err_io.
MeshFile read_abaqus_file(const std::string& path);

}  // namespace rollcon
