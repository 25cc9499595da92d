#pragma once
/// Surfaces that run through themselves.

#include "mesh/surface_mesh.hpp"

namespace rollcon {

/// Throws Error(err_mesh) where elements without a common node cross, deeper than their curvature lets their straight
/// parts stray from them.
void check_crossing(const SurfaceMesh& mesh);

}  // namespace rollcon
