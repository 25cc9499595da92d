#pragma once
/// Makes the loaded ring a body by itself, from inside the library.

#include "support/loaded_ring.hpp"
#include "support/static_solution.hpp"

namespace rollcon::statics::loaded_ring {

/// Holds hub and planes for one kind of load, and solves.
void hold_quarter(StaticBody& body, Load kind);
Answer loaded(StaticBody& body, Load kind);
std::vector<ListedError> listed_errors(StaticBody& body, Load kind, double poisson);

}  // namespace rollcon::statics::loaded_ring
