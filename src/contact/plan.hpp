#pragma once
/// What a scene did not need, and what was used, as text.

#include <string>

namespace rollcon {

class Body;
class Solver;

/// One line for each; needs a solution.
std::string describe_plan(Solver& solver, const Body& body1, const Body& body2);

}  // namespace rollcon
