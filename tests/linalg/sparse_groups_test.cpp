/// Tests groups of unknowns with the same neighbours, their elimination tree and the order made of it.

#include "linalg/sparse_groups.hpp"

#include <set>

#include "build_info.hpp"
#include "linalg/sparse_order.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using Numbers = std::vector<std::int64_t>;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// Returns the pattern of a rectangular grid of points with `fields` unknowns each, nine-point neighbourhoods. Unknown
/// f of point p is f * points + p, so members of a group are far apart.
SparseMatrix grid(std::int64_t nx, std::int64_t ny, std::int64_t fields) {
  const std::int64_t points = nx * ny;
  SparseMatrix a;
  a.columns = points * fields;
  a.start = {0};
  for (std::int64_t j = 0; j < a.columns; ++j) {
    const std::int64_t p = j % points;
    for (std::int64_t i = j; i < a.columns; ++i) {
      const std::int64_t q = i % points;
      if (std::abs(p % nx - q % nx) > 1 || std::abs(p / nx - q / nx) > 1) continue;
      a.row.push_back(i);
      a.value.push_back(i == j ? 100 : -1);
    }
    a.start.push_back(static_cast<std::int64_t>(a.row.size()));
  }
  return a;
}

/// Counts the entries of the factor's graph when groups are eliminated in this order.
std::int64_t fill(const SparseGroups& groups, const Numbers& order) {
  Numbers place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[at(order[k])] = static_cast<std::int64_t>(k);
  std::vector<std::set<std::int64_t>> later(order.size());
  for (std::int64_t g = 0; g < groups.count; ++g)
    for (std::int64_t e = groups.start[at(g)]; e < groups.start[at(g + 1)]; ++e)
      if (const std::int64_t q = place[at(groups.neighbour[at(e)])]; q > place[at(g)])
        later[at(place[at(g)])].insert(q);
  std::int64_t entries = 0;
  for (auto& column : later) {
    entries += static_cast<std::int64_t>(column.size());
    if (column.size() < 2) continue;
    const std::int64_t parent = *column.begin();
    later[at(parent)].insert(std::next(column.begin()), column.end());
  }
  return entries;
}

TEST(sparse_groups, unknowns_of_a_point_are_one_group) {
  const SparseMatrix a = grid(6, 5, 3);
  const SparseGroups groups = group_unknowns(a, {});
  ASSERT_EQ(groups.count, 30);
  for (std::int64_t g = 0; g < 30; ++g) {
    const auto from = groups.member.begin() + groups.member_start[at(g)];
    const auto to = groups.member.begin() + groups.member_start[at(g + 1)];
    EXPECT_EQ(Numbers(from, to), (Numbers{g, g + 30, g + 60}));
  }
  // Inner points have eight neighbours, corners three.
  EXPECT_EQ(groups.start[1] - groups.start[0], 3);
  EXPECT_EQ(groups.start[8] - groups.start[7], 8);
  for (std::int64_t g = 0; g < 30; ++g)
    EXPECT_TRUE(std::is_sorted(groups.neighbour.begin() + groups.start[at(g)],
                               groups.neighbour.begin() + groups.start[at(g + 1)]));
}

TEST(sparse_groups, condensed_unknowns_have_groups_of_their_own) {
  const SparseGroups groups = group_unknowns(grid(6, 5, 3), Numbers{7, 37, 12});
  EXPECT_EQ(groups.count, 32);
  for (std::int64_t g = 0; g < groups.count; ++g) {
    for (std::int64_t k = groups.member_start[at(g)]; k < groups.member_start[at(g + 1)]; ++k) {
      const std::int64_t u = groups.member[at(k)];
      EXPECT_EQ(groups.condensed[at(g)] != 0, u == 7 || u == 37 || u == 12) << u;
    }
  }
}

TEST(sparse_groups, elimination_trees_of_a_chain) {
  const SparseGroups groups = group_unknowns(grid(5, 1, 1), {});
  ASSERT_EQ(groups.count, 5);
  EXPECT_EQ(elimination_tree(groups, Numbers{0, 1, 2, 3, 4}), (Numbers{1, 2, 3, 4, -1}));
  // The middle comes last and leaves two halves.
  EXPECT_EQ(elimination_tree(groups, Numbers{0, 4, 1, 3, 2}), (Numbers{2, 3, 4, 4, -1}));
}

TEST(sparse_groups, condensed_groups_move_to_the_end_in_order) {
  const SparseGroups groups = group_unknowns(grid(6, 1, 1), Numbers{1, 4});
  Numbers order = {4, 0, 2, 1, 5, 3};
  move_condensed_last(groups, order);
  EXPECT_EQ(order, (Numbers{0, 2, 5, 3, 4, 1}));
}

TEST(sparse_groups, postorder_keeps_the_fill_and_brings_families_together) {
  const SparseGroups groups = group_unknowns(grid(12, 11, 2), Numbers{30, 31, 32, 42, 43, 44});
  Numbers order(at(groups.count));
  std::iota(order.begin(), order.end(), 0);
  // The order jumps over the grid, which makes many small subtrees, interleaved.
  std::stable_sort(order.begin(), order.end(), [](std::int64_t a, std::int64_t b) { return a * 7 % 10 < b * 7 % 10; });
  move_condensed_last(groups, order);
  const std::int64_t before = fill(groups, order);
  postorder_interior(groups, order);
  EXPECT_EQ(fill(groups, order), before);
  const Numbers parent = elimination_tree(groups, order);
  Numbers size(order.size(), 1);
  for (std::int64_t k = 0; k < groups.count && !groups.condensed[at(order[at(k)])]; ++k) {
    const std::int64_t p = parent[at(k)];
    if (p == -1 || groups.condensed[at(order[at(p)])]) continue;
    EXPECT_GT(p, k);
    size[at(p)] += size[at(k)];
  }
  // Members of a subtree stand in a row before its root, so the parents' intervals nest.
  for (std::int64_t k = 0; k < groups.count; ++k) {
    if (groups.condensed[at(order[at(k)])]) continue;
    for (std::int64_t i = k - size[at(k)] + 1; i < k; ++i) {
      EXPECT_GT(parent[at(i)], i);
      EXPECT_LE(parent[at(i)], k);
    }
  }
}

TEST(sparse_order, is_a_permutation_with_the_condensed_last_and_little_fill) {
  const SparseMatrix a = grid(40, 40, 1);
  const Numbers condensed = {5, 1405, 17, 300};
  const SparseOrder order = order_unknowns(a, condensed);
  EXPECT_EQ(std::set<std::int64_t>(order.unknown.begin(), order.unknown.end()).size(), at(a.columns));
  const std::set<std::int64_t> last(order.unknown.end() - 4, order.unknown.end());
  EXPECT_EQ(last, std::set<std::int64_t>(condensed.begin(), condensed.end()));
  EXPECT_GT(order.peak_bytes, 0U);

  const SparseGroups groups = group_unknowns(a, {});
  Numbers natural(at(groups.count));
  std::iota(natural.begin(), natural.end(), 0);
  const std::int64_t dissected = fill(groups, dissect(groups).group);
  std::printf("  fill %lld, in natural order %lld\n", static_cast<long long>(dissected),
              static_cast<long long>(fill(groups, natural)));
  EXPECT_LT(10 * dissected, 6 * fill(groups, natural));
}

TEST(sparse_order, permuted_matrix) {
  SparseMatrix a;
  a.columns = 3;
  a.start = {0, 3, 4, 5};
  a.row = {0, 1, 2, 1, 2};
  a.value = {1, 2, 3, 4, 5};
  const SparseMatrix b = permuted(a, Numbers{2, 0, 1});
  EXPECT_EQ(b.start, (Numbers{0, 2, 4, 5}));
  // The columns are 2, 0, 1 of a; entries are not sorted.
  EXPECT_EQ(b.row, (Numbers{1, 0, 1, 2, 2}));
  EXPECT_EQ(b.value, (std::vector<double>{3, 5, 1, 2, 4}));
}

}  // namespace
}  // namespace rollcon
