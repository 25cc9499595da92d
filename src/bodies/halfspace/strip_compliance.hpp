#pragma once
/// Makes the compliance of half-spaces under tractions on strips (mesh/strip_layout.hpp), by closed integrals.

#include <memory>

#include "bodies/halfspace/halfspace.hpp"

namespace rollcon {

/// Takes a frame with strips, which must outlive the compliance; nodes at the strips' ends carry nothing.
std::unique_ptr<Compliance> make_strip_compliance(const Frame& frame, HalfspaceConstants c);

}  // namespace rollcon
