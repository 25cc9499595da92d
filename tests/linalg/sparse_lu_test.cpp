/// Compares sparse LU with dense LU; tests analyses that are reused, and what it refuses.

#include "linalg/sparse_lu.hpp"

#include "linalg/lu.hpp"
#include "support/error.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Returns a grid's Laplacian with values at random and every sixth diagonal entry zero.
SparseMatrix grid_matrix(int side, std::uint32_t seed) {
  frames::Random random(seed);
  SparseMatrix a;
  a.columns = side * side;
  a.start.push_back(0);
  for (std::int64_t j = 0; j < a.columns; ++j) {
    for (const std::int64_t step :
         {-std::int64_t{side}, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, std::int64_t{side}}) {
      const std::int64_t i = j + step;
      if (i < 0 || i >= a.columns) continue;
      a.row.push_back(i);
      a.value.push_back(step != 0 ? -1 + 0.3 * random() : j % 6 == 0 ? 0 : 4 + random());
    }
    a.start.push_back(static_cast<std::int64_t>(a.row.size()));
  }
  return a;
}

std::vector<double> dense_solution(const SparseMatrix& a, const std::vector<double>& b) {
  Lu<double> lu;
  double* to = lu.prepare(a.columns);
  std::fill_n(to, a.columns * a.columns, 0.0);
  for (std::int64_t j = 0; j < a.columns; ++j)
    for (std::int64_t k = a.start[static_cast<std::size_t>(j)]; k < a.start[static_cast<std::size_t>(j + 1)]; ++k)
      to[a.row[static_cast<std::size_t>(k)] * a.columns + j] = a.value[static_cast<std::size_t>(k)];
  EXPECT_TRUE(lu.factor());
  std::vector<double> x(b);
  lu.solve(x.data());
  return x;
}

TEST(sparse_lu, solves_like_dense_lu_and_keeps_its_analysis) {
  SparseLu lu;
  if (!SparseLu::available()) {
    EXPECT_THROW(lu.factor(grid_matrix(4, 1)), Error);
    return;
  }
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const SparseMatrix a = grid_matrix(23, seed);
    std::vector<double> b(static_cast<std::size_t>(a.columns));
    frames::Random random(9);
    for (double& v : b) v = random();
    const std::vector<double> expected = dense_solution(a, b);
    ASSERT_TRUE(lu.factor(a));
    lu.solve(b.data());
    double worst = 0, scale = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
      worst = std::max(worst, std::abs(b[i] - expected[i]));
      scale = std::max(scale, std::abs(expected[i]));
    }
    expect_error("sparse against dense LU", worst / scale, 1e-10);
  }
  EXPECT_EQ(lu.statistics().analyses, 1);
  EXPECT_EQ(lu.statistics().factorizations, 3);
  ASSERT_TRUE(lu.factor(grid_matrix(22, 1)));
  EXPECT_EQ(lu.statistics().analyses, 2) << "another pattern";
  lu.release(false);
  EXPECT_FALSE(lu.factored());
}

TEST(sparse_lu, refuses_singular_matrices_and_what_is_not_finite) {
  if (!SparseLu::available()) GTEST_SKIP() << "no UMFPACK";
  SparseLu lu;
  SparseMatrix a = grid_matrix(5, 1);
  for (std::int64_t k = a.start[7]; k < a.start[8]; ++k) a.value[static_cast<std::size_t>(k)] = 0;
  EXPECT_FALSE(lu.factor(a));
  EXPECT_FALSE(lu.factored());
  a.value[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(lu.factor(a), Error);
}

}  // namespace
}  // namespace rollcon
