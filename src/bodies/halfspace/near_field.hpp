#pragma once
/// Integrals over one element for an observer on it or near it.
///
/// The plane has no height: seen from the observer's own reference point xi0, also when it lies a
/// little outside of the element, every kernel is homogeneous of degree -1 to first order and the
/// area element takes the singularity away. The element is the signed sum of triangles from xi0 to
/// its edges. On each, with s along the ray and the ray's end at the edge's coordinate
/// t = t0 + eta sinh(u) (foot t0 and height eta of xi0 in the metric of the tangent map), the
/// integrand is smooth in s and u however close the observer is to the edge and however stretched
/// the element. Where the map is too uneven for this, or the observer too far, the element is
/// split, and parts far enough get a plain Gauss rule.

#include <cstdint>

#include "bodies/halfspace/kernels.hpp"
#include "quadrature/element.hpp"

namespace rollcon::halfspace {

using namespace quadrature;

struct NearWorkspace {
  NearPoints points;
  std::int64_t evaluations = 0;
};

/// Adds to integral[k * max_shape_stride + i] the wanted integrals (see Terms), each off by at most
/// about `tolerance` (a length).
void near_integrals(const ElementShape& element, double px, double py, double tolerance, int terms,
                    const Kernels& kernels, NearWorkspace& workspace, double* integral);

}  // namespace rollcon::halfspace
