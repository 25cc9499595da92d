#pragma once
/// Computes the stiffness of one finite element of isotropic, linearly elastic material.

#include <cstdint>
#include <span>

#include "mesh/vec3.hpp"
#include "mesh/volume_type.hpp"

namespace rollcon::fem {

/// Names what keeps hex8 from locking. enhanced: incompatible modes, for bending, and a dilatation that is linear in
/// the element; b_bar: a constant dilatation, which is softer under local loads and too stiff in bending.
enum class Hex8 : std::int32_t { enhanced, b_bar };

/// Fills k, (3 n) x (3 n), full, symmetric to the last bit, unknown 3 * node + component; n = node_count(type). E = 1:
/// multiply by Young's modulus. x: the element's nodes, in any unit. The deviatoric strain is taken point by point, the
/// dilatation as its projection on few functions (docs/theory.md), so that elements other than tet4 and wedge6 keep
/// their accuracy as nu -> 1/2. Requires -1 < poisson < 0.5 and a positive Jacobian (check_volume), also at the centre.
void element_stiffness(VolumeType type, std::span<const Vec3> x, double poisson, double* k, Hex8 hex8 = Hex8::enhanced);

}  // namespace rollcon::fem
