#pragma once
/// Finds the power that friction takes, from the balance of work (docs/theory.md, section 8).

namespace rollcon {

struct Derived;
struct Preparation;
struct Solution;

/// Returns what slip takes, summed over the nodes in contact.
double power_at_nodes(const Solution& solution, Derived& derived);

/// Returns what forces, spin moment and the gap's slope put in (force times speed) in steady rolling, less what bodies
/// lose by creeping, without slip.
double power_put_in(const Solution& solution);
/// Returns the power over the speed that bodies lose by creeping, the force of rolling resistance; 0 for elastic ones.
/// which: 0 or 1 for one body alone.
double rolling_resistance(const Solution& solution, int which = -1);
/// Returns what slip takes in a time step, its sum over nodes corrected by the balance. preparation: may be null.
double power_in_step(const Solution& solution, Derived& derived, Preparation* preparation);
/// Says whether power_put_in() is what slip takes: steady rolling of half-spaces or rigid bodies within the frame.
bool power_is_balanced(const Solution& solution);

}  // namespace rollcon
