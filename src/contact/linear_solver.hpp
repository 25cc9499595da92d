#pragma once
/// Solves Newton's linear systems: dense LU in double precision, or GMRES preconditioned by a
/// single-precision LU that is kept from earlier iterations and solves as long as it serves.

#include <cstdint>
#include <vector>

#include "contact/reduced_system.hpp"
#include "linalg/gmres.hpp"
#include "linalg/lu.hpp"

namespace rollcon {

enum class LinearMethod { automatic, lu, gmres };

class LinearSolver {
 public:
  /// Up to this many unknowns `automatic` factorises every system (crossing measured by the bench
  /// case linear_solver).
  static constexpr std::int64_t direct_limit = 240;

  LinearMethod method = LinearMethod::automatic;

  /// Solves system x = b to a relative residual `tolerance` (LU: to rounding). node_count: of the
  /// frame. Returns false when no usable solution was found (singular to working precision). On
  /// return system.product() belongs to x.
  bool solve(ReducedSystem& system, std::int64_t node_count, const std::vector<double>& b,
             double tolerance, std::vector<double>& x);
  /// Forgets the kept factors, for instance when the operators change.
  void forget();

  std::int64_t iterations = 0;      ///< Krylov, since construction
  std::int64_t factorizations = 0;  ///< dense, since construction
  double seconds = 0;
  std::size_t bytes() const;

 private:
  /// Factors of an earlier system, mapped onto the present one node by node: nodes that were not
  /// active then keep their diagonal.
  class Kept final : public LinearOperator {
   public:
    void factor(ReducedSystem& system, std::int64_t node_count, bool& good);
    void match(const ReducedSystem& system);
    void apply(const double* x, double* y) override;
    bool usable(const ReducedSystem& system) const;
    void forget() { valid_ = false; }
    std::size_t bytes() const { return lu_.bytes(); }

   private:
    Lu<float> lu_;
    bool valid_ = false;
    Part part_ = Part::normal;
    std::int64_t nodes_ = 0, borders_ = 0;
    int components_ = 0;
    std::vector<std::int32_t> place_;  ///< node -> position among the factorised, or -1
    std::vector<std::int64_t> index_;  ///< present unknown -> factorised unknown, or -1
    std::int64_t index_size_ = 0;
    std::vector<float> work_;
  };

  bool solve_direct(ReducedSystem& system, const std::vector<double>& b, std::vector<double>& x);

  Lu<double> lu_;
  Kept kept_[3];  ///< one per part
  Gmres gmres_;
  std::vector<double> check_;
  int excess_[3] = {};  ///< Krylov iterations beyond good ones since the factors were made
};

}  // namespace rollcon
