#pragma once
/// Which closed shells lie inside which.

#include <span>
#include <vector>

#include "mesh/surface_shells.hpp"

namespace rollcon {

/// Volume that each shell encloses, with the sign of its first element's orientation. Fails for a shell that encloses
/// none.
std::vector<double> shell_volumes(const SurfaceMesh& mesh, const Shells& shells);

/// How many other shells enclose each shell: 0 outer, 1 cavity, 2 a body within a cavity, ... By the winding number of
/// some of its nodes. Fails when shells cross there.
std::vector<int> nesting_depths(const SurfaceMesh& mesh, const Shells& shells, std::span<const double> volume);

}  // namespace rollcon
