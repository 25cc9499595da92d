#pragma once
/// Solves Newton's linear systems: dense LU in double precision, or GMRES preconditioned by a single-precision LU that
/// is kept from earlier iterations and solves as long as it serves.

#include <cstdint>
#include <memory>
#include <vector>

#include "contact/linear/free_system.hpp"
#include "contact/linear/reduced_system.hpp"
#include "contact/linear/split_factors.hpp"
#include "contact/scene/linear_method.hpp"
#include "linalg/gcr.hpp"
#include "linalg/gmres.hpp"
#include "linalg/lu.hpp"

namespace rollcon {

class LinearSolver {
 public:
  /// Most free unknowns at which `automatic` factorises every system (crossing measured by bench case linear_solver).
  static constexpr std::int64_t direct_limit = 60;

  LinearMethod method = LinearMethod::automatic;

  /// Solves system x = b to a relative residual `tolerance` (LU: to rounding) on a frame of node_count nodes. Returns
  /// false when no usable solution was found (singular to working precision). On return system.product() belongs to x.
  bool solve(ReducedSystem& system, std::int64_t node_count, const std::vector<double>& b, double tolerance,
             std::vector<double>& x);
  /// Solves for rates of a solution, to rounding or a residual of 1e-9. Until forget_exact() or the next solve() the
  /// system of each part must stay what it is: double-precision factors made for one right side serve the others, and
  /// nothing that solve() keeps is touched.
  bool solve_exactly(ReducedSystem& system, const std::vector<double>& b, std::vector<double>& x);
  void forget_exact();
  /// Forgets the factors, for instance when the operators change.
  void forget();
  /// Forgets the factors and how well they served.
  void forget_all();

  std::int64_t iterations = 0;      ///< Krylov iterations since construction
  std::int64_t factorizations = 0;  ///< dense factorisations since construction
  std::int64_t right_sides = 0;     ///< right sides of solve() since construction
  std::int64_t unknowns = 0;        ///< unknowns of the last system
  double seconds = 0;
  std::size_t bytes() const;

 private:
  /// Solves by GMRES where operators are not formed. enough: residual that will do where the tolerance was not reached.
  bool solve_field(ReducedSystem& system, const std::vector<double>& b, double tolerance, double enough,
                   std::vector<double>& x);
  void take(ReducedSystem& system, std::vector<double>& x);
  bool solve_direct(const std::vector<double>& b, std::vector<double>& x);
  bool solve_with_kept(std::int64_t node_count, const std::vector<double>& b, double tolerance, std::vector<double>& x);
  bool factor_free(Lu<double>& lu);
  bool finish(const double* y, std::vector<double>& x);

  Lu<double> lu_;
  Lu<double> normal_lu_;  ///< factors of solve_exactly() for the normal part, which may come with another
  bool exact_[3] = {};    ///< lu_ or normal_lu_ holds the part's system of solve_exactly()
  FreeSystem free_;       ///< free unknowns of the present system
  SplitFactors kept_;
  Gmres gmres_;
  std::unique_ptr<FieldPreconditioner> field_blocks_;
  RecyclingGcr gcr_[3];  ///< solvers of solve_exactly(), one per part
  std::vector<double> reduced_, found_, check_;
  double decades_[3] = {};  ///< decades of the residual per Krylov iteration, in the part's last system
  static constexpr double usual_decades = 7;
  double fresh_decades_ = usual_decades;  ///< decades with factors just made
  int excess_ = 0;                        ///< Krylov iterations beyond those of fresh factors
};

}  // namespace rollcon
