#pragma once
/// Derivatives of the results of a solve, from Newton's system linearised at the solution with the state of every node
/// held (docs/theory.md, section 6). Each is computed when first asked for and kept until the next solve.

#include "contact/scene/enumerators.hpp"

namespace rollcon {

struct NodeGivens;  // contact/solution.hpp
struct Rates;       // contact/solution.hpp
struct SolverState;

/// Of a solution that converged or has no contact. err_state: a tangential load is prescribed where there is no
/// friction. err_singular: the linearised system has no solution.
const Rates& find_rates(SolverState& state, Parameter parameter);
/// Likewise, where what is given at the nodes changes at these rates; not kept.
Rates find_rates(SolverState& state, const NodeGivens& rate);

}  // namespace rollcon
