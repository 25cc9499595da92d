#pragma once
/// Power that friction takes, from the balance of work (docs/theory.md, section 8).

namespace rollcon {

struct Derived;
struct Preparation;
struct Solution;

/// What slip takes, summed over the nodes in contact.
double power_at_nodes(const Solution& solution, Derived& derived);

/// What forces, spin moment and the slope of the gap put in, force times speed, in steady rolling. Needs no slip.
double power_put_in(const Solution& solution);
/// What slip takes in a time step, its sum over nodes corrected by the balance. preparation: may be null.
double power_in_step(const Solution& solution, Derived& derived, Preparation* preparation);
/// It is what slip takes: steady rolling of half-spaces (or rigid bodies), all of the contact on the frame.
bool power_is_balanced(const Solution& solution);

}  // namespace rollcon
