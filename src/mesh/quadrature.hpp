#pragma once
/// Computes Gauss rules on demand, for any number of points.

#include <vector>

namespace rollcon {

struct LineRule {
  std::vector<double> x, w;
};

struct PlaneRule {
  std::vector<double> xi, eta, w;
  std::size_t size() const { return w.size(); }
};

/// Returns the n-point rule on [-1, 1] for the weight (1 - x)^alpha, alpha >= 0, which is exact to degree 2n - 1. Finds
/// the zeros of the Jacobi polynomial by Newton's method with deflation, in ascending order.
LineRule gauss_jacobi(int n, double alpha);
inline LineRule gauss_legendre(int n) {
  return gauss_jacobi(n, 0);
}

/// Returns a rule exact for polynomials of total degree `degree` on the triangle (0,0), (1,0), (0,1); all points are
/// inside, all weights positive (product rule collapsed at a corner).
PlaneRule triangle_rule(int degree);
/// Returns the product of both rules on [-1,1]^2; eta runs first.
PlaneRule product_rule(const LineRule& xi, const LineRule& eta);
/// Returns a rule exact for polynomials of degree `degree` in each variable on [-1,1]^2.
PlaneRule square_rule(int degree);

}  // namespace rollcon
