#pragma once
/// How a solve ended, in words: for the plan and the log.

#include <string>

#include "contact/state.hpp"

namespace rollcon {

/// Without the cause: "not converged after ...", "the contact reaches the rim ...", "converged
/// ...".
std::string describe_outcome(const SolverState& s);

}  // namespace rollcon
