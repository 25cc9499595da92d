/// Compares LU and GMRES with known solutions.

#include "linalg/gmres.hpp"
#include "linalg/lu.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

// Returns an unsymmetric, well conditioned matrix: diagonal plus a decaying random part.
std::vector<double> test_matrix(std::int64_t n) {
  frames::Random random(7);
  std::vector<double> a(static_cast<std::size_t>(n * n));
  for (std::int64_t i = 0; i < n; ++i)
    for (std::int64_t j = 0; j < n; ++j)
      a[static_cast<std::size_t>(i * n + j)] =
          (i == j ? 2.0 : 0.0) + 0.5 * random() / (1 + std::abs(static_cast<double>(i - j)));
  return a;
}

struct Dense final : LinearOperator {
  const std::vector<double>& a;
  std::int64_t n;
  int calls = 0;
  Dense(const std::vector<double>& matrix, std::int64_t size) : a(matrix), n(size) {}
  void apply(const double* x, double* y) override {
    ++calls;
    multiply(a.data(), n, n, x, 0, y);
  }
};

struct Identity final : LinearOperator {
  std::int64_t n;
  explicit Identity(std::int64_t size) : n(size) {}
  void apply(const double* x, double* y) override { std::copy(x, x + n, y); }
};

template <class T>
double lu_error(std::int64_t n) {
  const std::vector<double> a = test_matrix(n);
  std::vector<double> exact(static_cast<std::size_t>(n)), b(exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) exact[i] = std::sin(1.0 + static_cast<double>(i));
  multiply(a.data(), n, n, exact.data(), 0, b.data());
  Lu<T> lu;
  T* storage = lu.prepare(n);
  for (std::size_t k = 0; k < a.size(); ++k) storage[k] = static_cast<T>(a[k]);
  EXPECT_TRUE(lu.factor());
  std::vector<T> x(b.begin(), b.end());
  lu.solve(x.data());
  double error = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    error = std::max(error, std::abs(static_cast<double>(x[i]) - exact[i]));
  return error;
}

TEST(lu, solves_row_major_systems) {
  const double in_double = lu_error<double>(90), in_single = lu_error<float>(90);
  std::printf("LU of 90: error %.1e (bound 1e-13), single %.1e (bound 1e-5)\n", in_double, in_single);
  EXPECT_LT(in_double, 1e-13);
  EXPECT_LT(in_single, 1e-5);
}

TEST(lu, refuses_a_singular_matrix) {
  Lu<double> lu;
  double* a = lu.prepare(2);
  a[0] = a[1] = a[2] = a[3] = 1;
  EXPECT_FALSE(lu.factor());
}

TEST(gmres, reaches_the_tolerance_and_reports_the_true_residual) {
  const std::int64_t n = 90;
  const std::vector<double> a = test_matrix(n);
  std::vector<double> b(static_cast<std::size_t>(n), 1.0), x(b.size()), r(b.size());
  Dense matrix(a, n);
  Identity identity(n);
  Gmres gmres;
  gmres.reserve(n, 40);
  const GmresReport report = gmres.solve(n, matrix, identity, b.data(), x.data(), 1e-11, 200);
  multiply(a.data(), n, n, x.data(), 0, r.data());
  for (std::size_t i = 0; i < r.size(); ++i) r[i] -= b[i];
  const double residual = norm2(r.data(), n) / norm2(b.data(), n);
  std::printf("GMRES: %d iterations, residual %.1e (bound 2e-11)\n", report.iterations, residual);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(residual, 2e-11);
  EXPECT_NEAR(report.residual, residual, 1e-14);
}

TEST(gmres, restarts_converge_too) {
  const std::int64_t n = 90;
  const std::vector<double> a = test_matrix(n);
  std::vector<double> b(static_cast<std::size_t>(n), 1.0), x(b.size());
  Dense matrix(a, n);
  Identity identity(n);
  Gmres gmres;
  gmres.reserve(n, 4);
  EXPECT_TRUE(gmres.solve(n, matrix, identity, b.data(), x.data(), 1e-9, 400).converged);
}

// One solver serves small systems with many vectors and large ones with few.
TEST(gmres, a_larger_system_with_fewer_vectors) {
  Gmres gmres;
  for (const auto& [n, vectors] : {std::pair<std::int64_t, int>{20, 60}, {90, 20}, {20, 60}}) {
    const std::vector<double> a = test_matrix(n);
    std::vector<double> b(static_cast<std::size_t>(n), 1.0), x(b.size());
    Dense matrix(a, n);
    Identity identity(n);
    gmres.reserve(n, vectors);
    const std::size_t room = gmres.bytes();
    EXPECT_TRUE(gmres.solve(n, matrix, identity, b.data(), x.data(), 1e-9, 400).converged);
    EXPECT_GE(room, sizeof(double) * static_cast<std::size_t>(n * (vectors + 1)));
    EXPECT_LE(matrix.calls, n <= vectors ? n + 2 : 400 + 400 / vectors + 1);
  }
}

TEST(gmres, zero_right_side_needs_no_iteration) {
  const std::int64_t n = 5;
  const std::vector<double> a = test_matrix(n);
  std::vector<double> b(5, 0.0), x(5, 3.0);
  Dense matrix(a, n);
  Identity identity(n);
  Gmres gmres;
  gmres.reserve(n, 5);
  const GmresReport report = gmres.solve(n, matrix, identity, b.data(), x.data(), 1e-9, 10);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(matrix.calls, 0);
  for (const double v : x) EXPECT_EQ(v, 0);
}

}  // namespace
}  // namespace rollcon
