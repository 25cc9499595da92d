#include "mesh/quadrature.hpp"

#include "support/testing.hpp"

namespace rollcon {
namespace {

TEST(Quadrature, GaussLegendreIntegratesMonomials) {
  for (int n : {1, 2, 3, 5, 8, 16, 40}) {
    const LineRule rule = gauss_legendre(n);
    double error = 0;
    for (int k = 0; k < 2 * n; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < rule.x.size(); ++i) sum += rule.w[i] * std::pow(rule.x[i], k);
      error = std::max(error, std::abs(sum - (k % 2 ? 0 : 2.0 / (k + 1))));
    }
    expect_error("Gauss-Legendre, points: " + std::to_string(n), error, 1e-13);
  }
}

TEST(Quadrature, GaussLegendreIsNotExactBeyondItsDegree) {
  // The error of x^2n is 2^(2n+1) (n!)^4 / ((2n+1) ((2n)!)^2).
  const LineRule rule = gauss_legendre(3);
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += rule.w[i] * std::pow(rule.x[i], 6);
  expect_error("Gauss-Legendre's known error of x^6", 2.0 / 7 - sum - 128.0 * 1296 / (7 * 518400.0), 1e-15);
}

TEST(Quadrature, GaussJacobiIntegratesItsWeight) {
  // The integral of (1 - x) x^k is 2/(k+1) for even k, -2/(k+2) for odd k.
  for (int n : {1, 2, 5, 12}) {
    const LineRule rule = gauss_jacobi(n, 1);
    double error = 0;
    for (int k = 0; k < 2 * n; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < rule.x.size(); ++i) sum += rule.w[i] * std::pow(rule.x[i], k);
      error = std::max(error, std::abs(sum - (k % 2 ? -2.0 / (k + 2) : 2.0 / (k + 1))));
    }
    expect_error("Gauss-Jacobi, points: " + std::to_string(n), error, 1e-13);
  }
}

TEST(Quadrature, TriangleRulesIntegrateMonomials) {
  for (int degree : {0, 1, 2, 4, 7, 12}) {
    const PlaneRule rule = triangle_rule(degree);
    double error = 0, least = 1;
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b) {
        double sum = 0;
        for (std::size_t q = 0; q < rule.size(); ++q)
          sum += rule.w[q] * std::pow(rule.xi[q], a) * std::pow(rule.eta[q], b);
        const double exact = std::tgamma(a + 1) * std::tgamma(b + 1) / std::tgamma(a + b + 3);
        error = std::max(error, std::abs(sum - exact));
      }
    for (std::size_t q = 0; q < rule.size(); ++q)
      least = std::min({least, rule.xi[q], rule.eta[q], 1 - rule.xi[q] - rule.eta[q], rule.w[q]});
    EXPECT_GT(least, 0) << "a point outside or a weight not positive";
    expect_error("triangle rule of degree " + std::to_string(degree), error, 1e-15);
  }
}

TEST(Quadrature, SquareRulesIntegrateMonomials) {
  for (int degree : {1, 3, 5, 6}) {
    const PlaneRule rule = square_rule(degree);
    double error = 0;
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; b <= degree; ++b) {
        double sum = 0;
        for (std::size_t q = 0; q < rule.size(); ++q)
          sum += rule.w[q] * std::pow(rule.xi[q], a) * std::pow(rule.eta[q], b);
        error = std::max(error, std::abs(sum - (a % 2 || b % 2 ? 0 : 4.0 / ((a + 1) * (b + 1)))));
      }
    expect_error("square rule of degree " + std::to_string(degree), error, 5e-15);
  }
}

}  // namespace
}  // namespace rollcon
