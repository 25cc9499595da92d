#pragma once
/// Solves Newton's linear systems: dense LU in double precision, or GMRES preconditioned by a
/// single-precision LU that is kept from earlier iterations and solves as long as it serves.

#include <cstdint>
#include <vector>

#include "contact/linear_method.hpp"
#include "contact/pair_blocks.hpp"
#include "contact/reduced_system.hpp"
#include "linalg/gcr.hpp"
#include "linalg/gmres.hpp"
#include "linalg/lu.hpp"

namespace rollcon {

class LinearSolver {
 public:
  /// Up to this many unknowns `automatic` factorises every system (crossing measured by the bench
  /// case linear_solver).
  static constexpr std::int64_t direct_limit = 240;

  LinearMethod method = LinearMethod::automatic;
  Preconditioner preconditioner = Preconditioner::automatic;  ///< automatic: kept_lu

  /// Solves system x = b to a relative residual `tolerance` (LU: to rounding). node_count: of the
  /// frame. Returns false when no usable solution was found (singular to working precision). On
  /// return system.product() belongs to x.
  bool solve(ReducedSystem& system, std::int64_t node_count, const std::vector<double>& b,
             double tolerance, std::vector<double>& x);
  /// For rates of a solution: solves to rounding or a residual of 1e-9. Until forget_exact() or
  /// the next solve() the system of each part must stay what it is: double-precision factors made
  /// for one right side serve the others, and nothing that solve() keeps is touched.
  bool solve_exactly(ReducedSystem& system, const std::vector<double>& b, std::vector<double>& x);
  void forget_exact();
  /// Forgets the kept factors, for instance when the operators change.
  void forget();

  std::int64_t iterations = 0;      ///< Krylov, since construction
  std::int64_t factorizations = 0;  ///< dense, since construction
  std::int64_t unknowns = 0;        ///< of the last system
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

  /// GMRES with no preconditioner or the pairs' own blocks.
  bool solve_plainly(ReducedSystem& system, const std::vector<double>& b, double tolerance,
                     std::vector<double>& x);
  bool solve_direct(ReducedSystem& system, const std::vector<double>& b, std::vector<double>& x);

  Lu<double> lu_;
  Lu<double> normal_lu_;  ///< solve_exactly() of the normal part, which may come with another
  bool exact_[3] = {};    ///< those two hold the part's system of solve_exactly()
  Kept kept_[3];          ///< one per part
  Gmres gmres_;
  PairBlocks pair_blocks_;
  RecyclingGcr gcr_[3];  ///< of solve_exactly(), one per part
  std::vector<double> check_;
  double decades_[3] = {};  ///< of the residual per Krylov iteration, in the part's last system
  int excess_[3] = {};      ///< Krylov iterations beyond good ones since the factors were made
};

}  // namespace rollcon
