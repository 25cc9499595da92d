#pragma once
/// Says in words how a solve ended, for the plan and the log.

#include <string>

#include "contact/solution.hpp"
#include "support/line.hpp"

namespace rollcon {

/// Returns "not converged after ...", "contact reaches the rim ...", "converged ...".
Line describe_outcome(const Solution& s);

/// Says which of the prescribed loads friction cannot carry, and by how much.
std::string describe_beyond_friction(const FrictionShare& share);

}  // namespace rollcon
