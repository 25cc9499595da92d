/// Tests Newton's systems without the tractions that sliding gives.

#include "contact/linear/free_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "contact/linear/linear_solver.hpp"
#include "contact/operators/dense_operators.hpp"
#include "contact/results/condition.hpp"
#include "linalg/lu.hpp"

namespace rollcon {
namespace {

using Rows = FreeSystem::Rows;

constexpr std::int64_t nodes = 40;
constexpr Part parts[] = {Part::normal, Part::tangential, Part::full};

/// Makes random operators with heavy diagonals; a third of the nodes stick, one has no friction.
struct Example {
  Problem problem;
  ReducedSystem system;
  std::vector<double> lambda[3], b;
  std::mt19937 generator{7};

  double random() { return std::uniform_real_distribution<double>(-1, 1)(generator); }

  Example(Part part, bool by_force) {
    Problem& p = problem;
    const auto n = static_cast<std::size_t>(nodes);
    p.nodes = nodes;
    const auto op = std::make_shared<DenseOperators>();
    p.op = op;
    op->nodes = nodes;
    op->coupled = op->normal = op->tangential = true;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        op->block[r][c].resize(nodes, nodes);
        for (std::int64_t k = 0; k < nodes * nodes; ++k) op->block[r][c].data()[k] = 0.1 * random();
        for (std::int64_t k = 0; r == c && k < nodes; ++k) op->block[r][c].row(k)[k] += 4;
      }
    for (auto* v : {&p.rn, &p.rt, &p.weight, &p.moment_x, &p.moment_y, &p.convection.slip_x, &p.convection.slip_y})
      for (std::size_t k = 0; k < n; ++k) v->push_back(1 + 0.3 * random());
    p.used.assign(n, 1);
    for (auto& v : lambda) v.assign(n, 0.0);
    Prescribed given;
    given.by_force = {by_force, false, by_force, by_force};
    std::vector<std::int32_t> active;
    for (std::int32_t k = 0; k < nodes; k += 1 + (k % 5 == 0)) active.push_back(k);
    system.gather(p, given, part, active, lambda, true);
    if (part != Part::normal) slide(part);
    for (std::int64_t i = 0; i < system.size(); ++i) b.push_back(random());
  }

  void slide(Part part) {
    for (std::int64_t a = 0; a < system.active(); ++a) {
      const double pressure = a % 3 == 0 ? 30 : 1;
      system.law(a) = coulomb().linearise({0.3, a == 4 ? 0 : pressure, a == 4 ? 0 : random(), a == 4 ? 0 : random()},
                                          part == Part::full);
    }
  }

  double residual(const std::vector<double>& x) {
    std::vector<double> y(b.size());
    system.apply(x.data(), y.data());
    double worst = 0;
    for (std::size_t i = 0; i < b.size(); ++i) worst = std::max(worst, std::abs(y[i] - b[i]));
    return worst;
  }
};

TEST(free_system, matrix_and_product_agree) {
  for (const Part part : parts)
    for (const bool by_force : {false, true}) {
      Example e(part, by_force);
      FreeSystem free;
      free.take(e.system);
      const auto n = static_cast<std::size_t>(free.size());
      if (part != Part::normal) {
        EXPECT_LT(free.size(), e.system.size());
      }
      std::vector<double> matrix(n * n), y(n), product(n);
      free.dense(Rows::all, matrix.data());
      for (double& v : y) v = e.random();
      free.apply(y.data(), product.data());
      double worst = 0;
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) product[i] -= matrix[i * n + j] * y[j];
        worst = std::max(worst, std::abs(product[i]));
      }
      std::printf("%lld of %lld unknowns: rows times y against the matrix: %.1e (bound 1e-12)\n",
                  static_cast<long long>(n), static_cast<long long>(e.system.size()), worst);
      EXPECT_LT(worst, 1e-12);
    }
}

TEST(free_system, every_row_of_the_whole_system_is_solved) {
  for (const Part part : parts)
    for (const bool by_force : {false, true})
      for (const LinearMethod method : {LinearMethod::lu, LinearMethod::gmres}) {
        Example e(part, by_force);
        LinearSolver solver;
        solver.method = method;
        std::vector<double> x;
        ASSERT_TRUE(solver.solve(e.system, nodes, e.b, 1e-12, x));
        const std::vector<double> product(e.system.product().begin(), e.system.product().end());
        const double worst = e.residual(x);
        double drift = 0;
        for (std::size_t i = 0; i < product.size(); ++i)
          drift = std::max(drift, std::abs(product[i] - e.system.product()[i]));
        std::printf("%s: residual %.1e, product %.1e (bounds 1e-10)\n", method == LinearMethod::lu ? "LU" : "GMRES",
                    worst, drift);
        EXPECT_LT(worst, 1e-10);
        EXPECT_LT(drift, 1e-10);
        EXPECT_EQ(solver.factorizations, 1);
      }
}

TEST(free_system, factors_serve_a_system_in_another_state) {
  for (const Part part : {Part::tangential, Part::full}) {
    Example e(part, true);
    LinearSolver solver;
    solver.method = LinearMethod::gmres;
    std::vector<double> x;
    ASSERT_TRUE(solver.solve(e.system, nodes, e.b, 1e-10, x));
    const std::int64_t fresh = solver.iterations;
    // One node lets go, another turns.
    e.system.law(3) = coulomb().linearise({0.3, 1, 1, 0.5}, part == Part::full);
    e.system.law(1) = coulomb().linearise({0.3, 1, 0.1, 1}, part == Part::full);
    ASSERT_TRUE(solver.solve(e.system, nodes, e.b, 1e-10, x));
    const std::int64_t kept = solver.iterations - fresh;
    std::printf("%lld iterations with fresh factors, %lld with kept ones\n", static_cast<long long>(fresh),
                static_cast<long long>(kept));
    EXPECT_EQ(solver.factorizations, 1);
    EXPECT_LE(kept, fresh + 8);
    EXPECT_LT(e.residual(x), 1e-8);
  }
}

double largest_row_sum(const double* a, std::size_t n) {
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += std::abs(a[i * n + j]);
    worst = std::max(worst, sum);
  }
  return worst;
}

// Returns the condition from the inverse, column by column.
double exact_condition(ReducedSystem& system) {
  FreeSystem free;
  free.take(system);
  const auto n = static_cast<std::size_t>(free.size());
  std::vector<double> a(n * n), inverse(n * n), unit(n);
  free.dense(FreeSystem::Rows::all, a.data());
  Lu<double> lu;
  std::copy(a.begin(), a.end(), lu.prepare(free.size()));
  EXPECT_TRUE(lu.factor());
  for (std::size_t j = 0; j < n; ++j) {
    unit.assign(n, 0.0);
    unit[j] = 1;
    lu.solve(unit.data());
    for (std::size_t i = 0; i < n; ++i) inverse[i * n + j] = unit[i];
  }
  return largest_row_sum(a.data(), n) * largest_row_sum(inverse.data(), n);
}

TEST(free_system, condition_is_estimated_within_a_small_factor_below_the_exact_one) {
  for (const Part part : parts) {
    Example e(part, true);
    const double exact = exact_condition(e.system), estimate = estimate_condition(e.system);
    std::printf("part %d: condition %.4g, estimate %.4g (0.3 to 1 of it)\n", static_cast<int>(part), exact, estimate);
    EXPECT_LE(estimate, exact * (1 + 1e-10));
    EXPECT_GE(estimate, 0.3 * exact);
  }
}

}  // namespace
}  // namespace rollcon
