#pragma once
/// Treats half-spaces under a conformal contact: the frame is unrolled into a plane, where the compliance is that of
/// half-spaces, and both tractions and displacements are turned by half the angle between the tangents at their two
/// places (docs/theory.md, section 11).

#include <memory>

#include "bodies/halfspace/halfspace.hpp"

namespace rollcon {

/// Takes a frame with a section, which need not outlive the compliance, and what make_halfspace_compliance takes.
std::unique_ptr<Compliance> make_unrolled_compliance(const Frame& frame, HalfspaceConstants c, double tolerance,
                                                     int threads);

}  // namespace rollcon
