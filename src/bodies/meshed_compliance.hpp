#pragma once
/// Makes the compliance of a body with a mesh on a contact frame: the frame's elements are the body's own faces, or a
/// mesh laid on them. Between nodes the displacement is that of a half-space with the body's constants under the
/// same tractions, plus the interpolated difference of the two, which is smooth: the local field is not smeared over
/// elements (docs/theory.md, section 9).

#include <memory>

#include "bodies/pair.hpp"

namespace rollcon {

/// Throws err_mesh naming the frame node that does not lie over the body's contact faces.
std::unique_ptr<Compliance> make_meshed_compliance(const Frame& frame, const PairOfBodies& pair, int which,
                                                   double accuracy, int threads);

}  // namespace rollcon
