#pragma once
/// Solutions that nobody should believe although they solve the equations: bodies pressed beyond what linear elasticity
/// bears, and meshes of bodies that cannot show what the contact does to them.

#include "contact/solution.hpp"
#include "support/line.hpp"

namespace rollcon {

/// What is too much of the approach or the pressure; empty: nothing.
Line describe_too_deep(const SolverState& s);
/// What the meshes of the bodies do not show; empty: nothing.
Line describe_meshes(const SolverState& s);
/// The status of a solve on any frame, with doubts about the meshes.
Status with_doubts(const SolverState& s, Status status);

}  // namespace rollcon
