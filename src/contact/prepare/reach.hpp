#pragma once
/// Nodes that cannot touch under what is prescribed need no rows of the operators. They are chosen by a guess of the
/// contact, proved to be open after the solve, and brought back where they are not (docs/theory.md, section 8).

#include <cstdint>
#include <vector>

namespace rollcon {

struct SolverState;
struct Options;

/// Before the operators are assembled, and after gap and loads are known: chooses the nodes whose rows are wanted, in
/// `reach.wanted` (empty: all). Nodes that have rows stay in reach.
void choose_reach(SolverState& state, const Options& options);
/// Tells the problem which nodes may carry traction: those that the frame lets and that have rows.
void take_reach(SolverState& state);
/// After a solve: proves that all nodes left out are open. True: some were not, their rows are there now, and the solve
/// has to go on.
bool bring_back(SolverState& state);
/// Nodes that have no proof yet of being open at the solution, left in `reach.wanted`.
std::int64_t find_doubtful(SolverState& state);

}  // namespace rollcon
