#pragma once
/// Tells which solution procedure the options ask for: rollcon's own iteration, or one of those of Rodriguez-Tembleque
/// & Abascal (2010), section 11. docs/procedures.md compares them.

#include <memory>

#include "contact/scene/linear_method.hpp"
#include "contact/scene/options.hpp"

namespace rollcon {

enum class Jacobian { exact, b_derivative, simplified, reduced };
enum class SlipEstimate { jacobi, pseudo_temporal, extrapolation };
enum class LineSearch { automatic, armijo, off };

struct Procedure {
  bool monolithic = false;
  Jacobian jacobian = Jacobian::exact;
  SlipEstimate estimate = SlipEstimate::jacobi;
  LinearMethod linear = LinearMethod::automatic;
  double eta = 0;         ///< 0: chosen by the iteration
  double eta_max = 0.01;  ///< greatest tolerance of gmres_adaptive
  Preconditioner preconditioner = Preconditioner::automatic;
  LineSearch line_search = LineSearch::automatic;

  /// Says whether it is rollcon's own iteration on the condensed system (newton.hpp), the standard.
  bool standard() const { return !monolithic && jacobian == Jacobian::exact; }
};

/// Throws err_option for combinations that make no sense, with the reason, and err_unsupported for a published
/// procedure in a build without them.
Procedure choose_procedure(const Options& options);

/// Returns the next linear tolerance by (72)-(74) and the safeguard after them. merit: Psi of this and of the last
/// iterate (half the squared norm of the residual), eta: the last tolerance.
double adaptive_tolerance(double eta_max, double merit, double last_merit, double eta);

class PublishedSolver;  // contact/settle/solve_prepared.hpp
/// Makes what solves by the published procedures (src/procedures/).
using MakePublished = std::unique_ptr<PublishedSolver> (*)();

}  // namespace rollcon
