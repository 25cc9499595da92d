#pragma once
/// Finds reasons to doubt solutions although they solve the equations: bodies pressed together by more than linear
/// elasticity bears, and meshes that cannot show what the contact does to their bodies.

#include "contact/solution.hpp"
#include "support/line.hpp"

namespace rollcon {

/// Says that no material bears this pressure; empty: it is not more than the modulus of contact.
Line describe_pressure(double largest, double modulus);
/// Says whether approach or pressure is too much, and by what; empty: neither is.
Line describe_too_deep(const Solution& s);
/// Says what the meshes of the bodies do not show; empty: nothing.
Line describe_meshes(const Solution& s);
/// Says that the contact reaches a sharp end of a body without a mesh, where pressures have no bound; empty: it does
/// not.
Line describe_sharp_end(const Solution& s);
/// Says, whatever the outcome is, that a given matrix and its body's modulus are not in the same units; empty: nothing.
Line describe_units(const Solution& s);
/// Returns the status of a solve on any frame: inaccurate instead of ok if there are doubts about the meshes.
Status with_doubts(const Solution& s, Status status);

}  // namespace rollcon
