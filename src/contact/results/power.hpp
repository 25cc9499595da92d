#pragma once
/// Power that friction takes, from the balance of work (docs/theory.md, section 8).

namespace rollcon {

struct SolverState;

/// What slip takes, summed over the nodes in contact.
double power_at_nodes(SolverState& state);

/// What forces, spin moment and the slope of the gap put in, force times speed. Needs no slip.
double power_put_in(SolverState& state);
/// It is what slip takes: steady rolling of half-spaces (or rigid bodies), all of the contact on the frame.
bool power_is_balanced(const SolverState& state);

}  // namespace rollcon
