#pragma once
/// Solves by GMRES with right preconditioning and modified Gram-Schmidt (Saad & Schultz 1986). The workspace is sized
/// once; solving allocates nothing.

#include <cstdint>
#include <vector>

namespace rollcon {

struct LinearOperator {
  virtual ~LinearOperator() = default;
  virtual void apply(const double* x, double* y) = 0;
};

struct GmresReport {
  int iterations = 0;
  double residual = 0;  ///< relative to the norm of b
  bool converged = false;
};

class Gmres {
 public:
  /// Sizes the workspace for the largest Krylov space; restarts begin afresh from the best iterate.
  void reserve(std::int64_t n, int krylov);
  /// Solves a x = b from x = 0 to ||b - a x|| <= tolerance ||b||. The preconditioner may be the identity.
  GmresReport solve(std::int64_t n, LinearOperator& a, LinearOperator& precondition, const double* b, double* x,
                    double tolerance, int max_iterations);
  std::size_t bytes() const;

 private:
  GmresReport cycle(std::int64_t n, LinearOperator& a, LinearOperator& precondition, double* x, double target,
                    int max_iterations);
  int krylov_ = 0;
  std::vector<double> basis_, hessenberg_, cosine_, sine_, rhs_, z_, r_;
};

}  // namespace rollcon
