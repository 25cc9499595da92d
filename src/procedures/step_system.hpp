#pragma once
/// Solves the steps of the generalised Newton method, with the bodies' unknowns eliminated (condensed) or written out
/// (monolithic): two choices of the same equations.

#include "contact/scene/linear_method.hpp"
#include "procedures/step_preconditioners.hpp"

namespace rollcon {

struct StepOptions {
  bool monolithic = false;
  Tangential tangential = Tangential::slip;  ///< shift stands for reduced unknowns
  LinearMethod linear = LinearMethod::automatic;
  Preconditioner preconditioner = Preconditioner::automatic;
  bool operator==(const StepOptions&) const = default;
};

class StepSystem {
 public:
  /// Takes scales rn and rt, convection and loads from the problem; its dense blocks are needed by the condensed form
  /// alone. Everything must outlive the object. Throws Error(err_unsupported) when a body cannot be written out.
  StepSystem(const Problem& problem, const Frame& frame, const Compliance& compliance, const StepOptions& options);
  StepSystem(const StepSystem&) = delete;
  StepSystem& operator=(const StepSystem&) = delete;

  /// Finds the next iterate for a full step: directly, or by GMRES to
  /// ||J (next - z) + H(z)|| <= eta ||H(z)||, (71), with rows scaled to the units of tractions.
  /// Returns false if the matrix is singular to working precision, or nothing carries the loads.
  bool solve(const Step& step, const Point& z, double eta, Point& next);
  /// Computes slip, depth, shift and inner of the tractions of z.
  void update(Point& z);
  /// Returns the norm, in units of traction, of what the bodies' equations leave at z: an iterative solution satisfies
  /// them only up to its tolerance.
  double imbalance(const Point& z) const;
  StepCounters counters() const;

 private:
  bool iterates() const;
  bool solve_directly(const std::vector<double>& residual);
  bool solve_plainly(const std::vector<double>& residual, double eta);
  bool solve_with_kept(const std::vector<double>& residual, double eta);
  GmresReport run(LinearOperator& preconditioner, const std::vector<double>& right, double eta, int space, int limit);
  std::vector<double> imbalances(const Point& z) const;

  StepOptions options_;
  BodiesEquations bodies_;
  std::unique_ptr<Images> images_;
  std::unique_ptr<ContactEquations> equations_;
  StepFactors factors_;
  std::unique_ptr<KeptFactors> kept_;
  OwnEntries own_entries_;
  Gmres gmres_;
  double fresh_decades_ = 7;  ///< decades of the residual per Krylov iteration with factors just made
  int excess_ = 0;            ///< Krylov iterations beyond those of fresh factors
  StepCounters counters_;
  std::vector<double> b_, x_, product_, correction_, rest_;
};

}  // namespace rollcon
