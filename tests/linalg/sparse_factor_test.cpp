/// Compares the sparse factorisation with LAPACK's dense one.

#include "linalg/sparse_factor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <thread>

#include "linalg/blas_threads.hpp"
#include "linalg/sparse_matrices.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

class sparse_factor : public testing::Test {
  const BlasThreads one_{1};
};

using namespace sparse;

bool report(const char* what, double error, double bound) {
  std::printf("  %-40s error %.2e, bound %.0e\n", what, error, bound);
  return error <= bound;
}

// Compares full solutions, and condensed ones before and after the factor is dropped, with LAPACK.
void compare_with_dense(const char* what, const SparseMatrix& a, const Unknowns& condensed, double bound) {
  const std::vector<double> exact = dense_columns(a, condensed);
  const auto count = static_cast<std::int64_t>(condensed.size());
  std::vector<double> condensed_exact;
  for (std::int64_t r = 0; r < count; ++r)
    for (const std::int64_t u : condensed) condensed_exact.push_back(exact[at(r * a.columns + u)]);
  const auto factor = factor_definite(a, condensed);
  EXPECT_EQ(factor->size(), a.columns);
  std::vector<double> full(exact.size());
  for (std::int64_t r = 0; r < count; ++r) full[at(r * a.columns + condensed[at(r)])] = 1;
  factor->solve(full.data(), count);
  EXPECT_TRUE(report(what, difference(full, exact), bound));
  std::vector<double> before = identity(condensed.size());
  factor->solve_condensed(before.data(), count);
  EXPECT_TRUE(report("  condensed", difference(before, condensed_exact), bound));
  factor->keep_condensed();
  std::vector<double> after = identity(condensed.size());
  factor->solve_condensed(after.data(), count);
  EXPECT_TRUE(report("  condensed, alone", difference(after, condensed_exact), bound));
}

TEST_F(sparse_factor, springs_on_a_grid_against_dense) {
  const SparseMatrix a = springs(7, 3, 1);
  compare_with_dense("7 x 7 x 7 points, 3 unknowns each", a, scattered(a.columns), 1e-12);
}

TEST_F(sparse_factor, random_pattern_against_dense) {
  const SparseMatrix a = random_matrix(600, 0.02);
  compare_with_dense("600 unknowns, random", a, scattered(a.columns), 1e-13);
}

TEST_F(sparse_factor, bodies_apart_have_a_condensed_matrix_in_blocks) {
  const SparseMatrix a = side_by_side(springs(4, 3, 1), springs(5, 2, 0.3));
  compare_with_dense("two bodies", a, scattered(a.columns), 1e-12);
}

TEST_F(sparse_factor, all_unknowns_condensed) {
  const SparseMatrix a = springs(4, 3, 1);
  Unknowns all(at(a.columns));
  std::iota(all.rbegin(), all.rend(), 0);
  compare_with_dense("192 of 192 condensed", a, all, 1e-12);
}

TEST_F(sparse_factor, no_unknown_condensed) {
  const SparseMatrix a = springs(6, 3, 1);
  std::vector<double> exact(at(a.columns));
  for (std::size_t k = 0; k < exact.size(); ++k) exact[k] = std::sin(static_cast<double>(k));
  const auto factor = factor_definite(a, {});
  std::vector<double> x = multiply(a, exact);
  factor->solve(x.data(), 1);
  EXPECT_TRUE(report("nothing condensed", difference(x, exact), 1e-12));
  factor->solve_condensed(nullptr, 1);
  factor->keep_condensed();
  EXPECT_LT(factor->statistics().bytes, 1000U);
}

TEST_F(sparse_factor, no_unknown_at_all) {
  SparseMatrix a;
  a.start = {0};
  const auto factor = factor_definite(a, {});
  factor->solve(nullptr, 1);
  factor->solve_condensed(nullptr, 1);
  factor->keep_condensed();
  EXPECT_EQ(factor->size(), 0);
}

// The right sides are more than are solved at a time, and not a multiple of that.
TEST_F(sparse_factor, many_right_sides) {
  const SparseMatrix a = springs(5, 3, 1);
  const std::int64_t count = 71;
  std::vector<double> exact(at(a.columns * count)), b;
  for (std::size_t k = 0; k < exact.size(); ++k) exact[k] = std::sin(static_cast<double>(k));
  for (std::int64_t r = 0; r < count; ++r) {
    const auto from = exact.begin() + r * a.columns;
    const std::vector<double> y = multiply(a, std::vector<double>(from, from + a.columns));
    b.insert(b.end(), y.begin(), y.end());
  }
  std::vector<double> x = b;
  factor_definite(a, scattered(a.columns))->solve(x.data(), count);
  EXPECT_TRUE(report("71 right sides", difference(x, exact), 1e-12));
}

// Springs of 1e-3 to 1e3 stand on a soft ground.
TEST_F(sparse_factor, ill_conditioned_against_dense) {
  const SparseMatrix a = springs(7, 3, 1e-3, 1e3);
  const auto factor = factor_definite(a, scattered(a.columns));
  std::printf("  condition %.1e\n", factor->statistics().condition);
  EXPECT_GT(factor->statistics().condition, 1e6);
  compare_with_dense("ill conditioned", a, scattered(a.columns), 1e-9);
}

std::int64_t zero_pivot(const SparseMatrix& a, const Unknowns& condensed) {
  try {
    factor_definite(a, condensed);
  } catch (const ZeroPivot& pivot) {
    return pivot.unknown();
  }
  return -1;
}

// Rounding may leave the pivots of a body in the air, beside one on the ground, small and positive.
TEST_F(sparse_factor, a_body_in_the_air_is_found) {
  const SparseMatrix held = springs(5, 3, 1);
  for (const std::int64_t n : {2, 3, 5, 8, 12}) {
    const SparseMatrix a = side_by_side(held, springs(n, 3, 0));
    for (const Unknowns& condensed : {Unknowns{}, Unknowns{0, a.columns - 1}, scattered(a.columns)}) {
      const std::int64_t unknown = zero_pivot(a, condensed);
      EXPECT_GE(unknown, held.columns) << n;
      EXPECT_LT(unknown, a.columns) << n;
    }
  }
}

TEST_F(sparse_factor, an_unknown_without_stiffness_is_named) {
  SparseMatrix a = springs(5, 3, 1);
  const std::int64_t dead = 217;
  for (std::int64_t j = 0; j < a.columns; ++j)
    for (std::int64_t k = a.start[at(j)]; k < a.start[at(j + 1)]; ++k)
      if (j == dead || a.row[at(k)] == dead) a.value[at(k)] = 0;
  EXPECT_EQ(zero_pivot(a, {1, 2, 3}), dead);
}

TEST_F(sparse_factor, indefinite_matrices_are_refused) {
  SparseMatrix a = springs(4, 3, 1);
  a.value[at(a.start[50])] *= -1;
  EXPECT_EQ(zero_pivot(a, {}), 50);
  // The diagonal is positive, an eigenvalue negative.
  EXPECT_NE(zero_pivot(two_by_two(1, 2, 1), {}), -1);
}

Status status_of(const std::function<void()>& call, std::string* message) {
  try {
    call();
  } catch (const Error& error) {
    *message = error.what();
    return error.status();
  }
  return Status::ok;
}

TEST_F(sparse_factor, entries_that_are_not_finite_are_named) {
  std::string message;
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    SparseMatrix a = springs(4, 3, 1);
    const std::int64_t column = 7, entry = a.start[7] + 1;
    a.value[at(entry)] = bad;
    EXPECT_EQ(status_of([&] { factor_definite(a, {}); }, &message), Status::err_nonfinite);
    const std::string where = "(" + std::to_string(a.row[at(entry)]) + ", " + std::to_string(column) + ")";
    EXPECT_NE(message.find(where), std::string::npos) << message;
  }
}

// Finite entries have infinite products.
TEST_F(sparse_factor, overflow_does_not_pass_for_a_solution) {
  SparseMatrix a = springs(4, 3, 1);
  for (double& value : a.value) value *= 1e308;
  std::string message;
  bool refused = false;
  try {
    factor_definite(a, {});
  } catch (const std::exception&) {
    refused = true;
  }
  EXPECT_TRUE(refused);
}

TEST_F(sparse_factor, condensed_unknowns_are_checked) {
  const SparseMatrix a = springs(3, 3, 1);
  std::string message;
  for (const Unknowns& wrong : {Unknowns{-1}, Unknowns{a.columns}, Unknowns{4, 4}}) {
    EXPECT_EQ(status_of([&] { factor_definite(a, wrong); }, &message), Status::err_internal);
    EXPECT_NE(message.find(std::to_string(wrong[0])), std::string::npos) << message;
  }
}

// The condensed matrix would take 8 TB.
TEST_F(sparse_factor, too_large_a_condensed_matrix_is_refused_with_the_need) {
  SparseMatrix a;
  a.columns = 1000000;
  a.start.resize(at(a.columns + 1));
  std::iota(a.start.begin(), a.start.end(), 0);
  a.row.assign(a.start.begin(), a.start.end() - 1);
  a.value.assign(at(a.columns), 1.0);
  std::string message;
  const auto call = [&] { factor_definite(a, a.row)->keep_condensed(); };
  EXPECT_EQ(status_of(call, &message), Status::err_memory);
  double need = 0;
  const std::size_t number = message.find("needs ");
  ASSERT_NE(number, std::string::npos) << message;
  EXPECT_EQ(std::sscanf(message.c_str() + number, "needs %lf GB", &need), 1) << message;
  EXPECT_GE(need, 8e3);
  EXPECT_LE(need, 2e4);
}

TEST_F(sparse_factor, statistics) {
  const SparseMatrix a = springs(12, 3, 1);
  const Unknowns condensed = {5, 4, 3, 100, 101, 102};
  const auto factor = factor_definite(a, condensed);
  const SparseStatistics full = factor->statistics();
  const auto entries = static_cast<std::int64_t>(a.row.size());
  EXPECT_GT(full.nonzeros, 2 * entries);
  EXPECT_LT(full.nonzeros, a.columns * a.columns / 4);
  EXPECT_GT(full.flops, static_cast<double>(full.nonzeros));
  EXPECT_GT(full.condition, 10);
  EXPECT_LT(full.condition, 1e4);
  EXPECT_GT(full.seconds_order, 0);
  EXPECT_GT(full.seconds_factor, 0);
  EXPECT_GT(full.bytes, 4 * at(full.nonzeros));
  EXPECT_GT(full.peak_bytes, full.bytes);
  EXPECT_LT(full.peak_bytes, 20 * at(full.nonzeros));
  factor->keep_condensed();
  EXPECT_LT(factor->statistics().bytes, 2000U);
  factor->keep_condensed();
}

// The order of the unknowns is drawn by a generator that belongs to the process.
TEST_F(sparse_factor, threads_give_the_same_bits_and_leave_random_numbers_alone) {
  const SparseMatrix a = springs(10, 3, 1);
  const Unknowns condensed = scattered(a.columns);
  srand(5);
  const int first = rand(), second = rand();
  srand(5);
  EXPECT_EQ(rand(), first);
  const auto run = [&](std::vector<double>& x) {
    x.assign(at(a.columns), 1.0);
    factor_definite(a, condensed)->solve(x.data(), 1);
  };
  std::vector<double> alone;
  run(alone);
  EXPECT_EQ(rand(), second);
  std::vector<std::vector<double>> together(3);
  std::vector<std::thread> threads;
  threads.reserve(together.size());
  for (auto& x : together) threads.emplace_back(run, std::ref(x));
  for (auto& thread : threads) thread.join();
  for (const auto& x : together) EXPECT_EQ(x, alone);
}

std::int64_t threads_alive() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return std::distance(begin(tasks), end(tasks));
}

// CHOLMOD's own loops would start as many as it was built for.
TEST_F(sparse_factor, cholmod_starts_no_threads) {
  if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "needs /proc";
  const SparseMatrix a = springs(14, 3, 1);
  const std::int64_t before = threads_alive();
  const auto factor = factor_definite(a, scattered(a.columns));
  std::vector<double> x(at(a.columns), 1.0);
  factor->solve(x.data(), 1);
  EXPECT_EQ(threads_alive(), before);
}

}  // namespace
}  // namespace rollcon
