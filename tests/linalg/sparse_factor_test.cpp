/// Sparse factorisations against LAPACK's dense one and against each other.

#include "linalg/sparse_factor.hpp"

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <thread>
#include <tuple>

#include "build_info.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/sparse_matrices.hpp"
#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using namespace sparse;

std::unique_ptr<SparseFactor> by_umfpack(const SparseMatrix& a, std::span<const std::int64_t> condensed) {
  return factor_by_umfpack(a, condensed, 2);
}

struct Method {
  const char* name;
  std::unique_ptr<SparseFactor> (*factor)(const SparseMatrix&, std::span<const std::int64_t>);
};

std::vector<Method> methods() {
  std::vector<Method> all;
  if (ROLLCON_BUILD_CHOLMOD) all.push_back({"CHOLMOD", factor_by_cholmod});
  if (ROLLCON_BUILD_UMFPACK) all.push_back({"UMFPACK", by_umfpack});
  return all;
}

/// One method, and one thread of BLAS.
class sparse_factor : public testing::TestWithParam<Method> {
 protected:
  static std::unique_ptr<SparseFactor> factor(const SparseMatrix& a, const Unknowns& condensed = {}) {
    return GetParam().factor(a, condensed);
  }

 private:
  const BlasThreads one_{1};
};
class sparse_factors : public testing::Test {
  const BlasThreads one_{1};
};

INSTANTIATE_TEST_SUITE_P(by, sparse_factor, testing::ValuesIn(methods()),
                         [](const auto& param) { return std::string(param.param.name); });

/// Of these unknowns' rows.
std::vector<double> condensed_part(const SparseMatrix& a, const Unknowns& condensed) {
  const std::vector<double> columns = dense_columns(a, condensed);
  std::vector<double> part;
  for (std::size_t r = 0; r < condensed.size(); ++r)
    for (const std::int64_t u : condensed) part.push_back(columns[r * at(a.columns) + at(u)]);
  return part;
}

// Full solutions, condensed ones before and after the factor is dropped: all against LAPACK.
void compare_with_dense(SparseFactor& factor, const SparseMatrix& a, const Unknowns& condensed, double bound) {
  const std::vector<double> exact = dense_columns(a, condensed), part = condensed_part(a, condensed);
  const auto count = static_cast<std::int64_t>(condensed.size());
  EXPECT_EQ(factor.size(), a.columns);
  std::vector<double> full(exact.size());
  for (std::int64_t r = 0; r < count; ++r) full[at(r * a.columns + condensed[at(r)])] = 1;
  factor.solve(full.data(), count);
  expect_error("full", difference(full, exact), bound);
  for (const bool alone : {false, true}) {
    if (alone) factor.keep_condensed();
    std::vector<double> x = identity(condensed.size());
    factor.solve_condensed(x.data(), count);
    expect_error(alone ? "condensed, alone" : "condensed", difference(x, part), bound);
  }
}

TEST_P(sparse_factor, like_the_dense_one) {
  struct Case {
    const char* what;
    SparseMatrix a;
    double bound;
    bool all = false;
  };
  for (const Case& c : {Case{"7 x 7 x 7 points, 3 unknowns each", springs(7, 3, 1), 1e-12},
                        Case{"600 unknowns, random", random_matrix(600, 0.02), 1e-13},
                        // Their condensed matrix is in blocks.
                        Case{"two bodies apart", side_by_side(springs(4, 3, 1), springs(5, 2, 0.3)), 1e-12},
                        Case{"192 of 192 condensed", springs(4, 3, 1), 1e-12, true}}) {
    SCOPED_TRACE(c.what);
    Unknowns condensed = scattered(c.a.columns);
    if (c.all) {
      condensed.resize(at(c.a.columns));
      std::iota(condensed.rbegin(), condensed.rend(), 0);
    }
    compare_with_dense(*factor(c.a, condensed), c.a, condensed, c.bound);
  }
}

TEST_P(sparse_factor, no_unknown_condensed) {
  const SparseMatrix a = springs(6, 3, 1);
  std::vector<double> exact(at(a.columns));
  for (std::size_t k = 0; k < exact.size(); ++k) exact[k] = std::sin(static_cast<double>(k));
  const auto f = factor(a);
  std::vector<double> x = multiply(a, exact);
  f->solve(x.data(), 1);
  expect_error("nothing condensed", difference(x, exact), 1e-12);
  f->solve_condensed(nullptr, 1);
  f->keep_condensed();
  EXPECT_LT(f->statistics().bytes, 1000U);
}

TEST_P(sparse_factor, no_unknown_at_all) {
  const auto f = factor(Entries(0).matrix());
  f->solve(nullptr, 1);
  f->solve_condensed(nullptr, 1);
  f->keep_condensed();
  EXPECT_EQ(f->size(), 0);
}

// More right sides than are solved at a time, and not a multiple of that.
TEST_P(sparse_factor, many_right_sides) {
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
  factor(a, scattered(a.columns))->solve(x.data(), count);
  expect_error("71 right sides", difference(x, exact), 1e-12);
}

// Springs of 1e-3 to 1e3 on a soft ground.
TEST_F(sparse_factors, both_methods_agree_on_an_ill_conditioned_matrix) {
  if (methods().size() < 2) GTEST_SKIP() << "needs CHOLMOD and UMFPACK";
  const SparseMatrix a = springs(9, 3, 1e-3, 1e3);
  const Unknowns condensed = scattered(a.columns);
  std::vector<std::vector<double>> solution;
  for (const Method& method : methods()) {
    const auto factor = method.factor(a, condensed);
    std::printf("  %-8s condition %.1e\n", method.name, factor->statistics().condition);
    EXPECT_GT(factor->statistics().condition, 1e6);
    solution.push_back(identity(condensed.size()));
    factor->keep_condensed();
    factor->solve_condensed(solution.back().data(), static_cast<std::int64_t>(condensed.size()));
  }
  expect_error("ill conditioned", difference(solution[0], solution[1]), 1e-9);
}

std::int64_t zero_pivot(const Method& method, const SparseMatrix& a, const Unknowns& condensed) {
  try {
    method.factor(a, condensed);
  } catch (const ZeroPivot& pivot) {
    return pivot.unknown();
  }
  return -1;
}

// A body on the ground and one in the air: rounding may leave the pivots of the latter small and positive.
TEST_P(sparse_factor, a_body_in_the_air_is_found) {
  const SparseMatrix held = springs(5, 3, 1);
  for (const std::int64_t n : {2, 3, 5, 8, 12}) {
    const SparseMatrix a = side_by_side(held, springs(n, 3, 0));
    for (const Unknowns& condensed : {Unknowns{}, Unknowns{0, a.columns - 1}, scattered(a.columns)}) {
      const std::int64_t unknown = zero_pivot(GetParam(), a, condensed);
      EXPECT_GE(unknown, held.columns) << n;
      EXPECT_LT(unknown, a.columns) << n;
    }
  }
}

TEST_P(sparse_factor, an_unknown_without_stiffness_is_named) {
  SparseMatrix a = springs(5, 3, 1);
  const std::int64_t dead = 217;
  for (std::int64_t j = 0; j < a.columns; ++j)
    for (std::int64_t k = a.start[at(j)]; k < a.start[at(j + 1)]; ++k)
      if (j == dead || a.row[at(k)] == dead) a.value[at(k)] = 0;
  EXPECT_EQ(zero_pivot(GetParam(), a, {1, 2, 3}), dead);
}

TEST_P(sparse_factor, indefinite_matrices_are_for_umfpack) {
  SparseMatrix a = springs(4, 3, 1);
  a.value[at(a.start[50])] *= -1;
  if (GetParam().factor == factor_by_cholmod) {
    EXPECT_EQ(zero_pivot(GetParam(), a, {}), 50);
    EXPECT_NE(zero_pivot(GetParam(), two_by_two(1, 2, 1), {}), -1) << "positive diagonal, negative eigenvalue";
    return;
  }
  const std::vector<double> exact(at(a.columns), 1.0);
  std::vector<double> x = multiply(a, exact);
  factor(a)->solve(x.data(), 1);
  expect_error("indefinite", difference(x, exact), 1e-12);
}

// Zeros on the diagonal. Of the pair apart, whose second unknown is condensed, the first is the only one left to come
// last: the end of the factors is not that of the condensed matrix.
TEST_F(sparse_factors, pivots_off_the_diagonal_still_condense) {
  if (!ROLLCON_BUILD_UMFPACK) GTEST_SKIP() << "needs UMFPACK";
  SparseMatrix a = random_matrix(60, 0.3);
  for (std::int64_t j = 0; j < a.columns; j += 2) a.value[at(a.start[at(j)])] = 0;
  for (const bool apart : {false, true}) {
    const SparseMatrix b = apart ? side_by_side(a, two_by_two(0, 2, 3)) : a;
    const Unknowns condensed = {30, 2, apart ? a.columns + 1 : 4, 51};
    std::vector<double> x = identity(4);
    by_umfpack(b, condensed)->solve_condensed(x.data(), 4);
    expect_error(apart ? "with a pair apart" : "zeros on the diagonal", difference(x, condensed_part(b, condensed)),
                 1e-12);
  }
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

TEST_P(sparse_factor, entries_that_are_not_finite_are_named) {
  std::string message;
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    SparseMatrix a = springs(4, 3, 1);
    const std::int64_t column = 7, entry = a.start[7] + 1;
    a.value[at(entry)] = bad;
    EXPECT_EQ(status_of([&] { factor(a); }, &message), Status::err_nonfinite);
    const std::string where = "(" + std::to_string(a.row[at(entry)]) + ", " + std::to_string(column) + ")";
    EXPECT_NE(message.find(where), std::string::npos) << message;
  }
}

// Finite entries, infinite products.
TEST_P(sparse_factor, overflow_does_not_pass_for_a_solution) {
  SparseMatrix a = springs(4, 3, 1);
  for (double& value : a.value) value *= 1e308;
  EXPECT_ANY_THROW(factor(a));
}

TEST_P(sparse_factor, condensed_unknowns_are_checked) {
  const SparseMatrix a = springs(3, 3, 1);
  std::string message;
  for (const Unknowns& wrong : {Unknowns{-1}, Unknowns{a.columns}, Unknowns{4, 4}}) {
    EXPECT_EQ(status_of([&] { factor(a, wrong); }, &message), Status::err_internal);
    EXPECT_NE(message.find(std::to_string(wrong[0])), std::string::npos) << message;
  }
}

// A condensed matrix of 8 TB.
TEST_P(sparse_factor, too_large_a_condensed_matrix_is_refused_with_the_need) {
  SparseMatrix a;
  a.columns = 1000000;
  a.start.resize(at(a.columns + 1));
  std::iota(a.start.begin(), a.start.end(), 0);
  a.row.assign(a.start.begin(), a.start.end() - 1);
  a.value.assign(at(a.columns), 1.0);
  std::string message;
  EXPECT_EQ(status_of([&] { factor(a, a.row)->keep_condensed(); }, &message), Status::err_memory);
  double need = 0;
  const std::size_t number = message.find("needs ");
  ASSERT_NE(number, std::string::npos) << message;
  EXPECT_EQ(std::sscanf(message.c_str() + number, "needs %lf GB", &need), 1) << message;
  EXPECT_GE(need, 8e3);
  EXPECT_LE(need, 2e4);
}

TEST_P(sparse_factor, statistics) {
  const SparseMatrix a = springs(12, 3, 1);
  const auto f = factor(a, {5, 4, 3, 100, 101, 102});
  const SparseStatistics full = f->statistics();
  EXPECT_GT(full.nonzeros, 2 * static_cast<std::int64_t>(a.row.size()));
  EXPECT_LT(full.nonzeros, a.columns * a.columns / 4);
  EXPECT_GT(full.flops, static_cast<double>(full.nonzeros));
  EXPECT_GT(full.condition, 10);
  EXPECT_LT(full.condition, 1e4);
  EXPECT_GT(full.seconds_order, 0);
  EXPECT_GT(full.seconds_factor, 0);
  EXPECT_GT(full.bytes, 4 * at(full.nonzeros));
  EXPECT_GT(full.peak_bytes, full.bytes);
  EXPECT_LT(full.peak_bytes, 20 * at(full.nonzeros));
  f->keep_condensed();
  EXPECT_LT(f->statistics().bytes, 2000U);
  f->keep_condensed();
}

TEST_F(sparse_factors, a_build_without_a_method_says_so) {
  const SparseMatrix a = springs(2, 3, 1);
  std::string message;
  for (const auto& [built, method, option] :
       {std::tuple{ROLLCON_BUILD_CHOLMOD, &factor_by_cholmod, "ROLLCON_WITH_CHOLMOD"},
        std::tuple{ROLLCON_BUILD_UMFPACK, &by_umfpack, "ROLLCON_WITH_UMFPACK"}}) {
    if (built) continue;
    EXPECT_EQ(status_of([&, make = method] { make(a, {}); }, &message), Status::err_unsupported);
    EXPECT_NE(message.find(option), std::string::npos) << message;
  }
}

// The order of the unknowns is drawn by a generator that belongs to the process.
TEST_P(sparse_factor, threads_give_the_same_bits_and_leave_random_numbers_alone) {
  const SparseMatrix a = springs(10, 3, 1);
  const Unknowns condensed = scattered(a.columns);
  srand(5);
  const int first = rand(), second = rand();
  srand(5);
  EXPECT_EQ(rand(), first);
  const auto run = [&](std::vector<double>& x) {
    x.assign(at(a.columns), 1.0);
    factor(a, condensed)->solve(x.data(), 1);
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
TEST_F(sparse_factors, cholmod_starts_no_threads) {
  if (!ROLLCON_BUILD_CHOLMOD || !std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "needs CHOLMOD and /proc";
  const SparseMatrix a = springs(14, 3, 1);
  const std::int64_t before = threads_alive();
  const auto factor = factor_by_cholmod(a, scattered(a.columns));
  std::vector<double> x(at(a.columns), 1.0);
  factor->solve(x.data(), 1);
  EXPECT_EQ(threads_alive(), before);
}

}  // namespace
}  // namespace rollcon
