#pragma once
/// Solves Newton's linear systems: dense LU in double precision, or GMRES preconditioned by a single-precision LU that
/// is kept from earlier iterations and solves as long as it serves.

#include <cstdint>
#include <memory>
#include <vector>

#include "contact/linear/free_system.hpp"
#include "contact/linear/lattice_preconditioner.hpp"
#include "contact/linear/reduced_system.hpp"
#include "contact/linear/split_factors.hpp"
#include "contact/scene/linear_method.hpp"
#include "linalg/gcr.hpp"
#include "linalg/gmres.hpp"
#include "linalg/lu.hpp"

namespace rollcon {

class LinearSolver {
 public:
  /// Up to this many free unknowns `automatic` factorises every system (crossing measured by the bench case
  /// linear_solver).
  static constexpr std::int64_t direct_limit = 60;

  LinearMethod method = LinearMethod::automatic;

  /// Solves system x = b to a relative residual `tolerance` (LU: to rounding). node_count: of the frame. Returns false
  /// when no usable solution was found (singular to working precision). On return system.product() belongs to x.
  bool solve(ReducedSystem& system, std::int64_t node_count, const std::vector<double>& b, double tolerance,
             std::vector<double>& x);
  /// For rates of a solution: solves to rounding or a residual of 1e-9. Until forget_exact() or the next solve() the
  /// system of each part must stay what it is: double-precision factors made for one right side serve the others, and
  /// nothing that solve() keeps is touched.
  bool solve_exactly(ReducedSystem& system, const std::vector<double>& b, std::vector<double>& x);
  void forget_exact();
  /// Forgets the kept factors, for instance when the operators change.
  void forget();
  /// And how well they served.
  void forget_all();

  std::int64_t iterations = 0;      ///< Krylov, since construction
  std::int64_t factorizations = 0;  ///< dense, since construction
  std::int64_t right_sides = 0;     ///< of solve(), since construction
  std::int64_t unknowns = 0;        ///< of the last system
  double seconds = 0;
  std::size_t bytes() const;

 private:
  /// GMRES for operators that are not formed.
  /// enough: residual that will do where the tolerance was not reached.
  bool solve_field(ReducedSystem& system, const std::vector<double>& b, double tolerance, double enough,
                   std::vector<double>& x);
  void take(ReducedSystem& system, std::vector<double>& x);
  bool solve_direct(const std::vector<double>& b, std::vector<double>& x);
  bool solve_with_kept(std::int64_t node_count, const std::vector<double>& b, double tolerance, std::vector<double>& x);
  bool factor_free(Lu<double>& lu);
  bool finish(const double* y, std::vector<double>& x);

  Lu<double> lu_;
  Lu<double> normal_lu_;  ///< solve_exactly() of the normal part, which may come with another
  bool exact_[3] = {};    ///< those two hold the part's system of solve_exactly()
  FreeSystem free_;       ///< what is left of the present system
  SplitFactors kept_;
  Gmres gmres_;
  std::unique_ptr<FieldPreconditioner> field_blocks_;
  RecyclingGcr gcr_[3];  ///< of solve_exactly(), one per part
  std::vector<double> reduced_, found_, check_;
  double decades_[3] = {};  ///< of the residual per Krylov iteration, in the part's last system
  static constexpr double usual_decades = 7;
  double fresh_decades_ = usual_decades;  ///< likewise with factors just made
  int excess_ = 0;                        ///< Krylov iterations beyond those of fresh factors
};

}  // namespace rollcon
