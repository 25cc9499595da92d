#include "linalg/lu.hpp"

#include <cmath>

#include "linalg/lapack.hpp"

namespace rollcon {
namespace {

void getrf(int n, double* a, int* pivot, int* info) {
  dgetrf_(&n, &n, a, &n, pivot, info);
}
void getrf(int n, float* a, int* pivot, int* info) {
  sgetrf_(&n, &n, a, &n, pivot, info);
}
// Solves with 'T', because the row-major matrix is LAPACK's transpose.
void getrs(int n, const double* a, const int* pivot, double* b, int* info) {
  const int one = 1;
  dgetrs_("T", &n, &one, a, &n, pivot, b, &n, info);
}
void getrs(int n, const float* a, const int* pivot, float* b, int* info) {
  const int one = 1;
  sgetrs_("T", &n, &one, a, &n, pivot, b, &n, info);
}

}  // namespace

template <class T>
T* Lu<T>::prepare(std::int64_t n, std::int64_t spare) {
  if (matrix_.bytes() < static_cast<std::size_t>(n * n) * sizeof(T)) {
    matrix_.reserve(n + spare, n + spare);
    pivot_.resize(static_cast<std::size_t>(n + spare));
  }
  matrix_.resize(n, n);
  if (pivot_.size() < static_cast<std::size_t>(n)) pivot_.resize(static_cast<std::size_t>(n));
  return matrix_.data();
}

template <class T>
bool Lu<T>::factor() {
  const auto n = static_cast<int>(matrix_.rows());
  if (n == 0) return true;
  int info = 0;
  getrf(n, matrix_.data(), pivot_.data(), &info);
  if (info != 0) return false;
  for (int i = 0; i < n; ++i)
    if (!std::isfinite(matrix_.row(i)[i])) return false;
  return true;
}

template <class T>
void Lu<T>::solve(T* b) const {
  const auto n = static_cast<int>(matrix_.rows());
  if (n == 0) return;
  int info = 0;
  getrs(n, matrix_.data(), pivot_.data(), b, &info);
}

template class Lu<double>;
template class Lu<float>;

}  // namespace rollcon
