#pragma once
/// Recovers nodal stresses by patches: they are more accurate than averages of the elements' own.

#include <vector>

#include "bodies/fem/element_stress.hpp"
#include "bodies/model/body_mesh.hpp"

namespace rollcon::fem {

/// Replaces averages at the nodes, stress[6 * node + c], by better values, except where a node's elements have no sound
/// patch. part: stresses of each element's own function at its nodes, 6 for each entry of the volume's connectivity.
void recover_nodal_stresses(const BodyMesh& mesh, Hex8 hex8, const std::vector<double>& part, double* stress,
                            int threads);

}  // namespace rollcon::fem
