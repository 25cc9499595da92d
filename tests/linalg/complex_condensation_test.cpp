/// Compares condensed complex symmetric matrices with those of real ones and with their own inverse.

#include "linalg/complex_condensation.hpp"

#include <numeric>

#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_matrices.hpp"
#include "linalg/sparse_order.hpp"

namespace rollcon {
namespace {

using namespace sparse;
using Complex = std::complex<double>;

/// Returns a matrix whose imaginary part is that of other springs than its real part.
std::vector<Complex> lossy(const SparseMatrix& a, const SparseMatrix& b, double loss) {
  std::vector<Complex> value;
  for (std::size_t k = 0; k < a.value.size(); ++k) value.emplace_back(a.value[k], loss * b.value[k]);
  return value;
}

TEST(complex_condensation, is_the_inverse_of_what_is_left) {
  const SparseMatrix a = springs(5, 3, 1), b = springs(5, 3, 1, 30);
  const std::int64_t n = a.columns, kept = 12;
  Unknowns condensed;
  for (std::int64_t k = 0; k < kept; ++k) condensed.push_back((7 * k + 3) % n);
  const SparseOrder order = order_unknowns(a, condensed);
  const ComplexCondensation condensation(a, order.unknown, kept);
  for (const double loss : {0.0, 0.3, 3.0}) {
    const std::vector<Complex> value = lossy(a, b, loss), found = condensation.inverse(value, 2);
    // Gauss's elimination of the whole matrix with unit right sides at the condensed unknowns.
    std::vector<Complex> m(at(n * n)), x(at(n * kept));
    for (std::int64_t j = 0; j < n; ++j)
      for (std::int64_t k = a.start[at(j)]; k < a.start[at(j + 1)]; ++k)
        m[at(a.row[at(k)] * n + j)] = m[at(j * n + a.row[at(k)])] = value[at(k)];
    for (std::int64_t c = 0; c < kept; ++c) x[at(order.unknown[at(n - kept + c)] * kept + c)] = 2;
    for (std::int64_t p = 0; p < n; ++p)
      for (std::int64_t i = 0; i < n; ++i) {
        if (i == p) continue;
        const Complex f = m[at(i * n + p)] / m[at(p * n + p)];
        for (std::int64_t k = p; k < n; ++k) m[at(i * n + k)] -= f * m[at(p * n + k)];
        for (std::int64_t k = 0; k < kept; ++k) x[at(i * kept + k)] -= f * x[at(p * kept + k)];
      }
    double worst = 0, largest = 0;
    for (std::int64_t c = 0; c < kept; ++c)
      for (std::int64_t r = 0; r < kept; ++r) {
        const std::int64_t u = order.unknown[at(n - kept + r)];
        const Complex exact = x[at(u * kept + c)] / m[at(u * n + u)];
        worst = std::max(worst, std::abs(found[at(c * kept + r)] - exact));
        largest = std::max(largest, std::abs(exact));
      }
    std::printf("loss %g: off by %.1e (bound 1e-12)\n", loss, worst / largest);
    EXPECT_LT(worst, 1e-12 * largest);
  }
}

TEST(complex_condensation, names_the_unknown_without_stiffness) {
  const SparseMatrix a = springs(4, 2, 1);
  std::vector<Complex> value(a.value.begin(), a.value.end());
  constexpr std::int64_t loose = 17;
  for (std::int64_t j = 0; j < a.columns; ++j)
    for (std::int64_t k = a.start[at(j)]; k < a.start[at(j + 1)]; ++k)
      if (j == loose || a.row[at(k)] == loose) value[at(k)] = 0;
  const Unknowns condensed{0, 1};
  const ComplexCondensation condensation(a, order_unknowns(a, condensed).unknown, 2);
  try {
    condensation.inverse(value, 1);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const ZeroPivot& pivot) {
    EXPECT_EQ(pivot.unknown(), loose);
  }
}

}  // namespace
}  // namespace rollcon
