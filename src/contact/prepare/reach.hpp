#pragma once
/// Nodes that cannot touch under what is prescribed need no rows of the operators. They are chosen
/// by a guess of the contact, proved to be open after the solve, and brought back where they are
/// not (docs/theory.md, section 8).

#include <cstdint>
#include <vector>

namespace rollcon {

struct SolverState;
struct Options;

struct Reach {
  bool on = false;                ///< some nodes are left out
  std::int64_t nodes = 0;         ///< in reach
  std::int64_t returned = 0;      ///< brought back by checks of the last solve
  std::int64_t batches = 0;       ///< times that rows were added to those of the first solve
  bool fixed = false;             ///< rows are shared and cannot be added: a doubt is only noted
  bool doubtful = false;          ///< noted
  const char* why_not = nullptr;  ///< all nodes are in reach; static text
  const char* why_all = nullptr;  ///< likewise, once all rows are there
  /// Of the last solution: greatest gap of a node in contact, least gap, approach, load.
  bool known = false;
  double edge = 0, low = 0, depth = 0, load = 0;
  std::vector<double> radius;        ///< of the elements around each node
  std::vector<std::uint8_t> wanted;  ///< scratch, per node
};

/// Before the operators are assembled, and after gap and loads are known: chooses the nodes whose
/// rows are wanted, in `reach.wanted` (empty: all). Nodes that have rows stay in reach.
void choose_reach(SolverState& state, const Options& options);
/// Tells the problem which nodes may carry traction: those that the frame lets and that have rows.
void take_reach(SolverState& state);
/// After a solve: proves that all nodes left out are open. True: some were not, their rows are
/// there now, and the solve has to go on.
bool bring_back(SolverState& state, const Options& options);
/// Nodes that have no proof yet of being open at the solution, left in `reach.wanted`.
std::int64_t find_doubtful(SolverState& state);

}  // namespace rollcon
