// Compares dense factors with an estimate of the condition with explicit inverses.

#include "linalg/factored_matrix.hpp"

#include <random>

#include "linalg/lapack.hpp"
#include "support/interrupt.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using Matrix = std::vector<double>;  // column-major

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

double frobenius(const Matrix& a) {
  double sum = 0;
  for (const double v : a) sum += v * v;
  return std::sqrt(sum);
}

bool factor(FactoredMatrix& f, const Matrix& a, std::int64_t n) {
  std::copy(a.begin(), a.end(), f.prepare(n));
  return f.factor();
}

double exact_condition(const FactoredMatrix& f, const Matrix& a, std::int64_t n) {
  Matrix inverse(a.size(), 0.0);
  for (std::int64_t i = 0; i < n; ++i) inverse[at(i * (n + 1))] = 1;
  f.solve(inverse.data(), n);
  return frobenius(a) * frobenius(inverse);
}

Matrix random_matrix(std::int64_t n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  Matrix a(at(n * n));
  for (double& v : a) v = entry(generator);
  return a;
}

/// Returns a nearly dependent matrix: the last column is the sum of the others, except for `distance` of its entries.
Matrix nearly_singular(std::int64_t n, double distance, unsigned seed) {
  Matrix a = random_matrix(n, seed);
  for (std::int64_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::int64_t j = 0; j + 1 < n; ++j) sum += a[at(i + j * n)];
    a[at(i + (n - 1) * n)] = sum + distance * a[at(i + (n - 1) * n)];
  }
  return a;
}

TEST(FactoredMatrix, condition_is_estimated_within_a_small_factor) {
  double least = 1, most = 0;
  FactoredMatrix f;
  for (const std::int64_t n : {1, 2, 3, 5, 8, 13, 40, 100, 513})
    for (unsigned seed = 1; seed <= (n > 500 ? 3U : 40U); ++seed) {
      const Matrix a = random_matrix(n, seed);
      ASSERT_TRUE(factor(f, a, n));
      const double ratio = f.condition() / exact_condition(f, a, n);
      least = std::min(least, ratio);
      most = std::max(most, ratio);
    }
  std::printf("estimate over condition: %.3f to %.3f (0.02 to 3)\n", least, most);
  EXPECT_GE(least, 0.02);
  EXPECT_LE(most, 3);
}

TEST(FactoredMatrix, in_two_steps_the_end_of_a_solution_alone) {
  FactoredMatrix f;
  double worst = 0;
  for (const std::int64_t n : {1, 7, 40, 300}) {
    ASSERT_TRUE(factor(f, random_matrix(n, 5), n));
    const std::int64_t columns = std::min<std::int64_t>(n, 5);
    const Matrix b = random_matrix(n, 6);
    Matrix whole(b.begin(), b.begin() + n * columns), eliminated = whole;
    f.solve(whole.data(), columns);
    f.eliminate(eliminated.data(), columns);
    for (const std::int64_t first : {std::int64_t{0}, n / 3, n - 1, n}) {
      Matrix x = eliminated;
      f.substitute(x.data(), columns, first);
      double size = 0;
      for (const double v : whole) size = std::max(size, std::abs(v));
      for (std::int64_t i = 0; i < n * columns; ++i) {
        if (i % n < first)
          EXPECT_EQ(x[at(i)], eliminated[at(i)]);
        else
          worst = std::max(worst, std::abs(x[at(i)] - whole[at(i)]) / size);
      }
    }
  }
  std::printf("end of the solution against all of it: %.1e (1e-12)\n", worst);
  EXPECT_LE(worst, 1e-12);
}

TEST(FactoredMatrix, condition_of_nearly_singular_matrices_is_close) {
  FactoredMatrix f;
  double least = 1;
  for (const double distance : {1e-9, 1e-11, 1e-13})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Matrix a = nearly_singular(30, distance, seed);
      ASSERT_TRUE(factor(f, a, 30));
      EXPECT_GT(f.condition(), 0.1 / distance);
      least = std::min(least, f.condition() / exact_condition(f, a, 30));
    }
  std::printf("least estimate over condition: %.6f (0.99)\n", least);
  EXPECT_GE(least, 0.99);
}

TEST(FactoredMatrix, units_do_not_matter) {
  FactoredMatrix f;
  const Matrix a = nearly_singular(20, 1e-9, 3);
  ASSERT_TRUE(factor(f, a, 20));
  const double condition = f.condition();
  for (const double unit : {0x1p-960, 0x1p-500, 0x1p500, 0x1p960}) {
    Matrix scaled = a;
    for (double& v : scaled) v *= unit;
    ASSERT_TRUE(factor(f, scaled, 20));
    EXPECT_EQ(f.condition(), condition) << unit;
  }
}

TEST(FactoredMatrix, what_has_no_inverse_is_told) {
  FactoredMatrix f;
  EXPECT_FALSE(factor(f, Matrix(9, 0.0), 3));
  Matrix twice = random_matrix(3, 1);
  std::copy_n(twice.begin(), 3, twice.begin() + 3);
  EXPECT_TRUE(!factor(f, twice, 3) || f.condition() > 1e15);
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Matrix a = random_matrix(7, 1);
    for (const std::size_t k : {std::size_t{0}, std::size_t{24}, std::size_t{48}}) {
      Matrix b = a;
      b[k] = wrong;
      EXPECT_FALSE(factor(f, b, 7)) << k;
      EXPECT_FALSE(f.factored());
    }
  }
}

// The norm of large matrices is taken from some columns; the others' entries show in the solution.
TEST(FactoredMatrix, nothing_that_is_not_finite_hides_in_a_large_matrix) {
  FactoredMatrix f;
  const std::int64_t n = 520;
  const Matrix a = random_matrix(n, 2);
  ASSERT_TRUE(factor(f, a, n));
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const std::int64_t k : {n, n + 1, 2 * n - 1, n * n - 3, n * n - 1}) {
      Matrix b = a;
      b[at(k)] = wrong;
      EXPECT_FALSE(factor(f, b, n)) << wrong << " at " << k;
    }
}

TEST(FactoredMatrix, a_condition_beyond_numbers_is_infinite) {
  FactoredMatrix f;
  EXPECT_FALSE(factor(f, {1e200, 0, 0, 1e-200}, 2));
  EXPECT_EQ(f.condition(), std::numeric_limits<double>::infinity());
}

/// Wants a stop when it is asked for the n-th time.
class StopAt final : public Interrupt {
 public:
  explicit StopAt(int n) : n_(n) {}
  bool wanted() const override { return ++asked >= n_; }
  mutable int asked = 0;

 private:
  void tell() override {}
  int n_;
};

/// Returns the largest residual of the solution whose right side is ones.
double residual(const FactoredMatrix& f, const Matrix& a, std::int64_t n) {
  Matrix x(at(n), 1.0), product(at(n), -1.0);
  f.solve(x.data(), 1);
  for (std::int64_t j = 0; j < n; ++j)
    for (std::int64_t i = 0; i < n; ++i) product[at(i)] += a[at(i + j * n)] * x[at(j)];
  double worst = 0;
  for (const double v : product) worst = std::max(worst, std::abs(v));
  return worst;
}

// The matrix is large enough to be factorised in parts.
TEST(FactoredMatrix, factorisation_asks_between_its_parts_whether_to_go_on) {
  constexpr std::int64_t n = 4800;
  const Matrix a = random_matrix(n, 7);
  FactoredMatrix f;
  {
    const StopAt second(2);
    EXPECT_THROW(factor(f, a, n), Cancelled);
    EXPECT_FALSE(f.factored());
  }
  const StopAt never(1000);
  ASSERT_TRUE(factor(f, a, n));
  EXPECT_GE(never.asked, 3);
  // LAPACK's own routine takes the same rows and leaves as small a residual.
  Matrix whole = a;
  const int order = n;
  std::vector<std::int32_t> pivot(at(n));
  int info = 0;
  dgetrf_(&order, &order, whole.data(), &order, pivot.data(), &info);
  ASSERT_EQ(info, 0);
  EXPECT_TRUE(std::equal(pivot.begin(), pivot.end(), f.pivots().begin()));
  FactoredMatrix by_lapack;
  std::copy(whole.begin(), whole.end(), by_lapack.prepare(n));
  ASSERT_TRUE(by_lapack.restore(pivot, f.condition()));
  expect_error("residual over that of LAPACK", residual(f, a, n) / residual(by_lapack, a, n), 2);
}

}  // namespace
}  // namespace rollcon
