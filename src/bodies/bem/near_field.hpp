#pragma once
/// Computes Kelvin's integrals over one element for a point on it or near it.

#include "bodies/bem/kelvin.hpp"
#include "quadrature/near_field.hpp"
#include "quadrature/rule_selection.hpp"

namespace rollcon::bem {

using namespace quadrature;

/// Overwrites the integrals; see quadrature::near_field.
void near_integrals(const ElementGeometry& element, const Vec3& point, const OnElement& on, Tolerance tolerance,
                    int terms, const KelvinConstants& constants, const Kernels& kernels, NearWorkspace& workspace,
                    NearIntegrals& integrals);

}  // namespace rollcon::bem
