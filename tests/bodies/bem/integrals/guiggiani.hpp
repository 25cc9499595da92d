#pragma once
/// Evaluates strongly singular integrals directly by Guiggiani's method, independent of the rigid-body motion that the
/// library uses: in polar coordinates (rho, theta) of the reference element about the point the integrand is
/// F_-1(theta)/rho + O(1); the first part is integrated analytically outside of a vanishing ball, the rest is smooth.
///
/// M. Guiggiani, A. Gigante, A general algorithm for multidimensional Cauchy principal value integrals in the boundary
/// element method, J. Appl. Mech. 57 (1990) 906-915.

#include "bodies/bem/integrals/element_reference.hpp"

namespace rollcon::guiggiani {

/// Returns the finite part over the element of T_ic N_k seen from one of its points, block[3 * c + i][k]: less the
/// integral of F_-1 times the ball's ln(1/radius). The terms left out cancel in the sum over all elements around the
/// point.
element_reference::Integrals finite_part(const SurfaceMesh& element, element_reference::Reference at, double poisson);

}  // namespace rollcon::guiggiani
