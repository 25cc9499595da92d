#pragma once
/// Makes the compliance of the pair of bodies of a contact, or of one of them, on a frame.

#include <memory>
#include <vector>

#include "bodies/contact_surface.hpp"
#include "bodies/halfspace/halfspace.hpp"
#include "bodies/model/compliance.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Makes u1 - u2 under tractions on body 1 (-traction on body 2), a layer between them included. frame must outlive it.
/// accuracy: relative error of half-space integrals.
std::unique_ptr<Compliance> make_pair_compliance(const Frame& frame, const PairOfBodies& pair, double accuracy,
                                                 int threads);
/// Returns the constants of both half-spaces together; a body of another kind adds nothing.
HalfspaceConstants half_spaces_of(const PairOfBodies& pair);
/// Returns the lags of the bodies that creep, at the pair's speed; both in one where they creep alike. which: 0 or 1
/// for one body alone.
std::vector<LaggingBody> lags_of(const PairOfBodies& pair, int which = -1);
/// Makes displacements whose work with the tractions is the power over the speed that bodies lose by creeping: those of
/// half-spaces together, and of each section. which: as for lags_of().
std::vector<std::unique_ptr<Compliance>> make_losses(const Frame& frame, const PairOfBodies& pair, double accuracy,
                                                     int threads, int which = -1);
/// Makes the part of body `which` (0 or 1) in u1 - u2; null for a rigid body.
std::unique_ptr<Compliance> make_body_compliance(const Frame& frame, const PairOfBodies& pair, int which,
                                                 double accuracy, int threads);
/// Returns E* of the pair as if both were half-spaces, as a scale of stiffness for first guesses.
double contact_modulus(const PairOfBodies& pair);
/// Returns that modulus once all that relaxes has done so.
double relaxed_modulus(const PairOfBodies& pair);
/// Returns Dundurs' beta of the pair as if both were half-spaces: 0 for equal bodies, at most 1/2.
double dundurs_beta(const PairOfBodies& pair);

}  // namespace rollcon
