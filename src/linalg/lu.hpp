#pragma once
/// Computes the dense LU factors with partial pivoting (LAPACK getrf) of a row-major matrix, in double or single
/// precision.

#include <cstdint>
#include <vector>

#include "linalg/dense.hpp"

namespace rollcon {

template <class T>
class Lu {
 public:
  /// Returns storage for an n by n matrix, to be filled row by row before factor(). Room for `spare` more rows is
  /// reserved so that slightly larger systems need no allocation.
  T* prepare(std::int64_t n, std::int64_t spare = 0);
  /// Returns false when a pivot is exactly zero or the factors are not finite.
  bool factor();
  void solve(T* b) const;
  std::int64_t size() const { return matrix_.rows(); }
  std::size_t bytes() const { return matrix_.bytes() + pivot_.capacity() * sizeof(int); }

 private:
  RowMatrix<T> matrix_;
  std::vector<int> pivot_;
};

extern template class Lu<double>;
extern template class Lu<float>;

}  // namespace rollcon
