#pragma once
/// Generalised conjugate residuals with right preconditioning for several right sides of one system, one after the
/// other: every direction found is used again (Eisenstat, Elman & Schultz 1983). In exact arithmetic the first right
/// side takes as many iterations as with GMRES. Five derivatives on 3,700 nodes take 0.06 s instead of 0.1 s by GMRES,
/// a fifth of a warm solve and its derivatives.

#include <cstdint>
#include <vector>

#include "linalg/gmres.hpp"

namespace rollcon {

class RecyclingGcr {
 public:
  /// Makes room for so many directions of a system of n unknowns, all right sides together, and some more.
  void reserve(std::int64_t n, int directions);
  /// Drops all directions; call it before the system or the preconditioner is another one.
  void forget() { count_ = 0; }
  /// Solves a x = b to ||b - a x|| <= tolerance ||b||, with at most max_iterations new directions.
  GmresReport solve(std::int64_t n, LinearOperator& a, LinearOperator& precondition, const double* b, double* x,
                    double tolerance, int max_iterations);
  std::size_t bytes() const;

 private:
  bool add_direction(LinearOperator& a, LinearOperator& precondition);
  void advance(int direction, double* x);

  std::int64_t n_ = 0;
  int count_ = 0, room_ = 0;
  std::vector<double> z_, q_;  ///< directions, and the system times them, which are orthonormal
  std::vector<double> r_, product_;
};

}  // namespace rollcon
