#pragma once
/// Gives displacements of a body far from the frame that loads it.

#include <span>

#include "bodies/pair.hpp"

namespace rollcon {

/// Returns the displacement of the point of the body's contact faces that is nearest to x, under tractions
/// [3 * node + component] of the frame on body 1. The body has a mesh; x and the displacement are in the axes that the
/// poses refer to.
Vec3 displacement_beside(const Frame& frame, const PairOfBodies& pair, int which, std::span<const double> traction,
                         const Vec3& x);

}  // namespace rollcon
