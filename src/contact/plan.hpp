#pragma once
/// Tells in words what a scene did not need, and what was used.

#include <string>

namespace rollcon {

class Body;
class Solver;

/// Returns one line for each part of a solve; needs a solution.
std::string describe_plan(Solver& solver, const Body& body1, const Body& body2);

}  // namespace rollcon
