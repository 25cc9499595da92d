#pragma once
/// Provides the published procedures behind contact's interface. They are a component of the build; where it is left
/// out nobody calls this, and choose_procedure() refuses what would ask for them.

#include "contact/settle/solve_prepared.hpp"

namespace rollcon {

/// Makes a solver that follows state.procedure; the systems of the steps are kept for the next solve.
std::unique_ptr<PublishedSolver> make_published();

}  // namespace rollcon
