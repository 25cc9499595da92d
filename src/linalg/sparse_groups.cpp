#include "linalg/sparse_groups.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "support/index.hpp"

namespace rollcon {
namespace {

// Scatters neighbouring numbers by a bijection of 64 bits (Steele, Lea and Flood, 2014).
std::uint64_t scatter(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

// Sums over the neighbours, the unknown itself included. Equal sums of different sets are next to impossible, and would
// cost fill only.
std::vector<std::uint64_t> neighbourhood_keys(const SparseMatrix& matrix, std::span<const std::int64_t> condensed) {
  std::vector<std::uint64_t> key(at(matrix.columns));
  for (std::int64_t j = 0; j < matrix.columns; ++j) {
    const std::uint64_t own = scatter(static_cast<std::uint64_t>(j));
    key[at(j)] += own;
    for (std::int64_t k = matrix.start[at(j)]; k < matrix.start[at(j + 1)]; ++k) {
      const std::int64_t i = matrix.row[at(k)];
      if (i == j) continue;
      key[at(j)] += scatter(static_cast<std::uint64_t>(i));
      key[at(i)] += own;
    }
  }
  for (const std::int64_t c : condensed) key[at(c)] ^= 1U;
  return key;
}

// Numbers groups by their first members, so that the result depends on the matrix alone.
std::vector<std::int64_t> group_numbers(const std::vector<std::uint64_t>& key, std::int64_t* count) {
  const auto n = static_cast<std::int64_t>(key.size());
  std::vector<std::int64_t> sorted(key.size()), group(key.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(),
            [&](std::int64_t a, std::int64_t b) { return std::tie(key[at(a)], a) < std::tie(key[at(b)], b); });
  for (std::int64_t k = 0, first = 0; k < n; ++k) {
    const std::int64_t i = sorted[at(k)];
    if (k == 0 || key[at(i)] != key[at(sorted[at(k - 1)])]) first = i;
    group[at(i)] = first;
  }
  *count = 0;
  for (std::int64_t i = 0; i < n; ++i) group[at(i)] = group[at(i)] == i ? (*count)++ : group[at(group[at(i)])];
  return group;
}

void list_members(const std::vector<std::int64_t>& group, SparseGroups& groups) {
  groups.member_start.assign(at(groups.count + 1), 0);
  for (const std::int64_t g : group) ++groups.member_start[at(g + 1)];
  std::partial_sum(groups.member_start.begin(), groups.member_start.end(), groups.member_start.begin());
  groups.member.resize(group.size());
  std::vector<std::int64_t> next(groups.member_start.begin(), groups.member_start.end() - 1);
  for (std::size_t i = 0; i < group.size(); ++i) groups.member[at(next[at(group[i])]++)] = static_cast<std::int64_t>(i);
}

// Calls visit(g, h), g > h, for neighbouring groups, which are those whose first members are neighbours.
template <class Visit>
void for_edges(const SparseMatrix& matrix, const std::vector<std::int64_t>& group, const SparseGroups& groups,
               Visit visit) {
  const auto first = [&](std::int64_t g) { return groups.member[at(groups.member_start[at(g)])]; };
  for (std::int64_t h = 0; h < groups.count; ++h) {
    const std::int64_t j = first(h);
    for (std::int64_t k = matrix.start[at(j)]; k < matrix.start[at(j + 1)]; ++k) {
      const std::int64_t i = matrix.row[at(k)], g = group[at(i)];
      if (g != h && first(g) == i) visit(g, h);
    }
  }
}

}  // namespace

SparseGroups group_unknowns(const SparseMatrix& matrix, std::span<const std::int64_t> condensed) {
  SparseGroups groups;
  const std::vector<std::int64_t> group = group_numbers(neighbourhood_keys(matrix, condensed), &groups.count);
  list_members(group, groups);
  groups.condensed.assign(at(groups.count), 0);
  for (const std::int64_t c : condensed) groups.condensed[at(group[at(c)])] = 1;

  groups.start.assign(at(groups.count + 1), 0);
  for_edges(matrix, group, groups, [&](std::int64_t g, std::int64_t h) {
    ++groups.start[at(g + 1)];
    ++groups.start[at(h + 1)];
  });
  std::partial_sum(groups.start.begin(), groups.start.end(), groups.start.begin());
  groups.neighbour.resize(at(groups.start.back()));
  std::vector<std::int64_t> next(groups.start.begin(), groups.start.end() - 1);
  for_edges(matrix, group, groups, [&](std::int64_t g, std::int64_t h) {
    groups.neighbour[at(next[at(g)]++)] = h;
    groups.neighbour[at(next[at(h)]++)] = g;
  });
  return groups;
}

// Follows Liu's algorithm with path compression.
std::vector<std::int64_t> elimination_tree(const SparseGroups& groups, std::span<const std::int64_t> order) {
  std::vector<std::int64_t> parent(order.size(), -1), ancestor(order.size(), -1);
  std::vector<std::int64_t> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[at(order[k])] = static_cast<std::int64_t>(k);
  for (std::int64_t k = 0; k < groups.count; ++k) {
    const std::int64_t g = order[at(k)];
    for (std::int64_t e = groups.start[at(g)]; e < groups.start[at(g + 1)]; ++e) {
      std::int64_t i = position[at(groups.neighbour[at(e)])];
      while (i != -1 && i < k) {
        const std::int64_t next = ancestor[at(i)];
        ancestor[at(i)] = k;
        if (next == -1) parent[at(i)] = k;
        i = next;
      }
    }
  }
  return parent;
}

void move_condensed_last(const SparseGroups& groups, std::vector<std::int64_t>& order) {
  std::stable_partition(order.begin(), order.end(), [&](std::int64_t g) { return !groups.condensed[at(g)]; });
}

void postorder_interior(const SparseGroups& groups, std::vector<std::int64_t>& order) {
  const std::vector<std::int64_t> parent = elimination_tree(groups, order);
  const auto inside = [&](std::int64_t k) { return !groups.condensed[at(order[at(k)])]; };
  // Children are linked lists, lowest first; roots hang on the extra entry.
  std::vector<std::int64_t> child(order.size() + 1, -1), sibling(order.size(), -1);
  std::int64_t interior = 0;
  for (std::int64_t k = groups.count - 1; k >= 0; --k) {
    if (!inside(k)) continue;
    ++interior;
    const std::int64_t p = parent[at(k)];
    const std::size_t under = p != -1 && inside(p) ? at(p) : order.size();
    sibling[at(k)] = child[under];
    child[under] = k;
  }
  const std::vector<std::int64_t> before = order;
  std::vector<std::int64_t> path{groups.count};
  for (std::int64_t done = 0; done < interior;) {
    const std::int64_t k = path.back(), next = child[at(k)];
    if (next != -1) {
      child[at(k)] = sibling[at(next)];
      path.push_back(next);
    } else {
      order[at(done++)] = before[at(k)];
      path.pop_back();
    }
  }
}

}  // namespace rollcon
