#include "linalg/dense.hpp"

#include <cmath>

#include "linalg/lapack.hpp"

namespace rollcon {

void multiply(const double* a, std::int64_t rows, std::int64_t columns, const double* x, double beta, double* y) {
  if (rows == 0) return;
  if (columns == 0) {
    for (std::int64_t i = 0; i < rows; ++i) y[i] = beta == 0 ? 0 : beta * y[i];
    return;
  }
  const int m = static_cast<int>(columns), n = static_cast<int>(rows), one = 1;
  const double alpha = 1;
  dgemv_("T", &m, &n, &alpha, a, &m, x, &one, &beta, y, &one);
}

void add_product(const RowMatrix<double>& a, const RowMatrix<double>& b, RowMatrix<double>& c) {
  const int m = static_cast<int>(b.columns()), n = static_cast<int>(a.rows()), l = static_cast<int>(a.columns());
  const double one = 1;
  if (a.columns() > 0) dgemm_("N", "N", &m, &n, &l, &one, b.data(), &m, a.data(), &l, &one, c.data(), &m);
}

double dot(const double* x, const double* y, std::int64_t n) {
  const int size = static_cast<int>(n), one = 1;
  return ddot_(&size, x, &one, y, &one);
}

void axpy(double alpha, const double* x, double* y, std::int64_t n) {
  const int size = static_cast<int>(n), one = 1;
  daxpy_(&size, &alpha, x, &one, y, &one);
}

double norm2(const double* x, std::int64_t n) {
  double sum = 0;
  for (std::int64_t i = 0; i < n; ++i) sum += x[i] * x[i];
  return std::sqrt(sum);
}

}  // namespace rollcon
