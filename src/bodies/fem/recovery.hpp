#pragma once
/// Nodal stresses recovered by patches: more accurate than averages of the elements' own.

#include <vector>

#include "bodies/fem/element_stress.hpp"
#include "bodies/model/body_mesh.hpp"

namespace rollcon::fem {

/// part: stresses of each element's own function at its nodes, 6 for each entry of the volume's connectivity.
/// stress: averages at the nodes, 6 for each; better ones come in their place. Nodes whose elements have no sound
/// patch keep theirs.
void recover_nodal_stresses(const BodyMesh& mesh, Hex8 hex8, const std::vector<double>& part, double* stress,
                            int threads);

}  // namespace rollcon::fem
