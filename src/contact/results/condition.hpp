#pragma once
/// Estimates the condition of the linear systems of a contact.

namespace rollcon {

class Newton;
class ReducedSystem;
struct Solution;

/// Estimates, in the maximum norm, the condition of what is left to solve of a system, whose operators must be formed
/// and whose laws must be set. Infinite: singular. 0: no unknowns.
double estimate_condition(ReducedSystem& system);

/// Estimates the condition of the scaled systems of a Newton step at the last iterate, the greater of normal and
/// tangential where these are apart. 0: no contact, or operators that are not formed.
double find_condition(const Solution& solution, Newton& newton);

}  // namespace rollcon
