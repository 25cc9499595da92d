/// Tests that several right sides of one system are all solved, the later ones in fewer iterations.

#include "linalg/gcr.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace rollcon {
namespace {

struct Matrix final : LinearOperator {
  std::size_t n = 0;
  std::vector<double> a;
  int applied = 0;

  void apply(const double* x, double* y) override {
    ++applied;
    for (std::size_t i = 0; i < n; ++i) {
      y[i] = 0;
      for (std::size_t j = 0; j < n; ++j) y[i] += a[i * n + j] * x[j];
    }
  }
};

struct Nothing final : LinearOperator {
  std::size_t n = 0;
  void apply(const double* x, double* y) override {
    for (std::size_t i = 0; i < n; ++i) y[i] = x[i];
  }
};

// Returns the identity and a part of low rank, unsymmetric, such as factors of a neighbouring system leave it.
Matrix near_identity(std::size_t n, std::size_t rank) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Matrix m;
  m.n = n;
  m.a.assign(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) m.a[i * n + i] = 1;
  for (std::size_t k = 0; k < rank; ++k) {
    std::vector<double> u(n), v(n);
    for (std::size_t i = 0; i < n; ++i) u[i] = normal(random), v[i] = normal(random);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) m.a[i * n + j] += u[i] * v[j] / static_cast<double>(n);
  }
  return m;
}

TEST(gcr, later_right_sides_use_what_earlier_ones_found) {
  constexpr std::size_t n = 60, rank = 12;
  constexpr double tolerance = 1e-12;
  Matrix matrix = near_identity(n, rank);
  Nothing none;
  none.n = n;
  RecyclingGcr gcr;
  gcr.reserve(n, 50);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> b(n), x(n), ax(n);
  double worst = 0;
  int iterations[4] = {};
  for (int& count : iterations) {
    for (double& v : b) v = normal(random);
    const GmresReport report = gcr.solve(n, matrix, none, b.data(), x.data(), tolerance, 30);
    EXPECT_TRUE(report.converged);
    count = report.iterations;
    matrix.apply(x.data(), ax.data());
    double error = 0, size = 0;
    for (std::size_t i = 0; i < n; ++i) {
      error += (b[i] - ax[i]) * (b[i] - ax[i]);
      size += b[i] * b[i];
    }
    worst = std::max(worst, std::sqrt(error / size));
  }
  std::printf("residual %.1e (bound 2e-12); iterations %d, then %d, %d, %d (at most 14, then 2)\n", worst,
              iterations[0], iterations[1], iterations[2], iterations[3]);
  EXPECT_LE(worst, 2e-12);
  EXPECT_GT(iterations[0], 5);
  EXPECT_LE(iterations[0], static_cast<int>(rank) + 2);
  for (int k = 1; k < 4; ++k) EXPECT_LE(iterations[k], 2);
}

TEST(gcr, says_when_it_did_not_get_there) {
  constexpr std::size_t n = 40;
  Matrix matrix = near_identity(n, 20);
  Nothing none;
  none.n = n;
  RecyclingGcr gcr;
  gcr.reserve(n, 8);
  std::vector<double> b(n, 1.0), x(n);
  b[3] = 5;
  GmresReport report = gcr.solve(n, matrix, none, b.data(), x.data(), 1e-12, 5);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 5);
  EXPECT_GT(report.residual, 1e-12);
  report = gcr.solve(n, matrix, none, b.data(), x.data(), 1e-12, 30);
  EXPECT_FALSE(report.converged) << "no room for more directions";
  EXPECT_EQ(report.iterations, 3);

  matrix.a.assign(n * n, 0.0);  // singular
  gcr.forget();
  report = gcr.solve(n, matrix, none, b.data(), x.data(), 1e-12, 30);
  EXPECT_FALSE(report.converged);
  b.assign(n, 0.0);
  report = gcr.solve(n, matrix, none, b.data(), x.data(), 1e-12, 30);
  EXPECT_TRUE(report.converged);
  for (const double v : x) EXPECT_EQ(v, 0);
}

}  // namespace
}  // namespace rollcon
