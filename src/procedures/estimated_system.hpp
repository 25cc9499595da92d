#pragma once
/// The condensed system with the reduced unknowns of the paper's section 11.8: three tractions of a
/// sticking pair, whose displacement is given, one of a sliding pair, whose friction follows its
/// pressure; then the unknown motions.

#include <span>

#include "bodies/model/compliance.hpp"
#include "contact/linear/linear_solver.hpp"
#include "linalg/kept_lu.hpp"
#include "procedures/step_system.hpp"

namespace rollcon {

class EstimatedSystem final : public LinearOperator {
 public:
  EstimatedSystem(const Problem& problem, const Frame& frame, const Compliance& compliance);

  /// Puts the matrix together for the states and laws of a step.
  void gather(const Step& step, std::span<const std::int32_t> active);
  void right_side(const Step& step, const Point& z, std::vector<double>& b) const;
  void start(const Point& z, std::vector<double>& x) const;
  bool solve(const std::vector<double>& b, double eta, const LinearSolver& choice,
             std::vector<double>& x);
  /// Tractions of the active nodes, and unknown motions, of a solution.
  void scatter(const Step& step, const std::vector<double>& x, Point& next) const;
  /// Tangential displacement of tractions at all nodes.
  void shift(Point& z);

  void apply(const double* x, double* y) override;
  std::int64_t size() const { return matrix_.rows(); }
  std::int64_t iterations = 0, factorizations = 0;
  std::size_t bytes() const;

 private:
  struct Motion {
    int which = 0;
    double scale = 1;  ///< unknown = motion times scale, a traction
    double per_load = 1;
  };
  struct Unknown {
    std::int32_t node = 0;
    std::int32_t component = 0;
  };
  void assemble();
  double row_entry(const Step& step, const double* const (&row)[3], std::int32_t node,
                   int component) const;

  const Problem& problem_;
  const Frame& frame_;
  const Compliance& compliance_;
  RowMatrix<double> shift_[2][3];  ///< tangential displacement per unit traction
  std::vector<double> rs_;         ///< traction per tangential displacement
  std::vector<Unknown> unknown_;
  std::vector<Motion> motion_;
  RowMatrix<double> matrix_;
  Lu<double> lu_;
  KeptLu kept_;
  Gmres gmres_;
  std::vector<std::int64_t> key_;
  std::vector<double> diagonal_;
};

}  // namespace rollcon
