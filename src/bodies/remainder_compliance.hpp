#pragma once
/// Gives displacements for the tractions on a layer that a finite-element body does not feel: they act on it as
/// smoother tractions on its own faces. The rest has no resultant over a few faces and moves the surface near it alone,
/// as it does a half-space's (docs/theory.md, section 10).

#include <memory>

#include "bodies/contact_surface.hpp"
#include "bodies/model/compliance.hpp"
#include "bodies/model/surface_response.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Makes the displacement, as part of u1 - u2, of a half-space with the body's constants under the tractions less those
/// felt. frame and rows, which must have the tractions felt, must outlive it.
std::unique_ptr<Compliance> make_remainder_compliance(const Frame& frame, const PairOfBodies& pair, int which,
                                                      const SurfaceOutline& rows, double accuracy, int threads);

}  // namespace rollcon
