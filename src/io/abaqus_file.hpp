#pragma once
/// Input files of Abaqus and CalculiX.

#include <string>

#include "io/mesh_file.hpp"

namespace rollcon {

/// Nodes, elements, sets of both and surfaces; all other keywords are passed over, save those that make or move nodes.
/// err_io.
MeshFile read_abaqus_file(const std::string& path);

}  // namespace rollcon
