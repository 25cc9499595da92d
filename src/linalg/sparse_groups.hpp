#pragma once
/// Groups unknowns with the same neighbours, such as the few unknowns of a node of a finite-element mesh. Orderings
/// work on the graph of the groups, which is an order of magnitude smaller.

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/sparse_factor.hpp"

namespace rollcon {

struct SparseGroups {
  std::int64_t count = 0;
  std::vector<std::int64_t> member_start, member;  ///< unknowns of a group, ascending
  std::vector<std::int64_t> start, neighbour;      ///< graph without loops, in both directions
  std::vector<char> condensed;                     ///< 1 for groups of condensed unknowns; no group mixes both kinds
};

SparseGroups group_unknowns(const SparseMatrix& matrix, std::span<const std::int64_t> condensed);

/// Returns the parents in the elimination tree when groups are eliminated in this order; -1 at roots. All numbers are
/// positions in the order.
std::vector<std::int64_t> elimination_tree(const SparseGroups& groups, std::span<const std::int64_t> order);

/// Moves condensed groups to the end and keeps the order otherwise.
void move_condensed_last(const SparseGroups& groups, std::vector<std::int64_t>& order);

/// Sorts the groups that are not condensed, which come first, by a postorder of their elimination forest: the fill
/// stays the same, and columns of equal structure become neighbours.
void postorder_interior(const SparseGroups& groups, std::vector<std::int64_t>& order);

}  // namespace rollcon
