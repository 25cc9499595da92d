#pragma once
/// Condenses complex symmetric matrices with positive definite real part, which need no pivots.

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "linalg/sparse_matrix.hpp"

namespace rollcon {

/// Eliminates unknowns front by front; all matrices of one pattern share the analysis.
class ComplexCondensation {
 public:
  /// Takes the lower triangle of the pattern, and the unknown at each place of an order, the condensed ones last.
  ComplexCondensation(const SparseMatrix& pattern, std::span<const std::int64_t> order, std::int64_t condensed);
  /// Returns the inverse of the condensed matrix, times a scale, column-major in the order of its unknowns. value: that
  /// of each entry of the pattern. Throws ZeroPivot. Safe for several threads.
  std::vector<std::complex<double>> inverse(std::span<const std::complex<double>> value, double scale) const;
  /// Returns all unknowns of the pattern, column-major, under a right-hand side of `scale` at each condensed unknown in
  /// turn. Throws ZeroPivot. Safe for several threads.
  std::vector<std::complex<double>> everywhere(std::span<const std::complex<double>> value, double scale) const;
  std::int64_t nonzeros() const { return nonzeros_; }

 private:
  using Front = std::vector<std::complex<double>>;  ///< lower triangle of a dense matrix, column-major
  /// Names the rows of a front, of which the first `columns` are eliminated there.
  struct Step {
    std::int64_t columns = 0;
    std::vector<std::int64_t> row;    ///< places in the order, ascending
    std::vector<std::size_t> child;   ///< steps whose remainders it takes
    std::vector<std::int64_t> entry;  ///< entries of the pattern, and
    std::vector<std::size_t> target;  ///< where they go in the front
  };
  /// Replaces the first columns of a front by those of L in A = LL', and the rest by what is left of it.
  void eliminate(const Step& step, Front& a) const;
  /// Returns the fronts with all columns eliminated; those that are not kept are empty but for the last.
  std::vector<Front> factorised(std::span<const std::complex<double>> value, bool keep) const;

  std::vector<std::int64_t> order_;
  std::vector<Step> step_;  ///< the last one has the condensed unknowns
  std::int64_t nonzeros_ = 0;
};

}  // namespace rollcon
