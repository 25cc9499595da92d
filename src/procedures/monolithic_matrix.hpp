#pragma once
/// The matrix of the monolithic system (48), (58), (62) of one step, in units of traction.
///
/// Unknowns: those of the bodies; per pair tractions (t1, t2, n), gap vector (displacements t1, t2
/// and gap n) and slip; motions. Without friction: normal traction and gap alone. Reduced (88):
/// three per pair, the gap vector of an open pair, the tractions of a sticking one, normal traction
/// and tangential displacement of a sliding one.
///
/// Equations, in the places of the unknowns they are paired with: the bodies'; displacements (with
/// the tractions); slip and normal law (with the gap vector); tangential laws (with the slip);
/// loads (with the motions).

#include <array>
#include <cstdint>
#include <vector>

#include "linalg/gmres.hpp"
#include "procedures/monolithic_bodies.hpp"
#include "procedures/step_system.hpp"

namespace rollcon {

enum class MonolithicForm { frictionless, full, reduced };

class MonolithicMatrix final : public LinearOperator {
 public:
  MonolithicMatrix(const Problem& problem, const MonolithicBodies& bodies, MonolithicForm form);

  /// States, laws and unknown motions; the step must outlive the uses.
  void set(const Step& step);

  void apply(const double* x, double* y) override;
  void right_side(std::vector<double>& b);
  void start(const Point& z, std::vector<double>& x) const;
  /// Everything of a point at all nodes.
  void scatter(const std::vector<double>& x, Point& next);

  struct Border {
    int motion = 0;
    double scale = 1;     ///< unknown = motion times scale, a traction
    double per_load = 1;  ///< row per load
  };
  MonolithicForm form() const { return form_; }
  std::int64_t size() const { return motion_ + static_cast<std::int64_t>(border_.size()); }
  const std::vector<Border>& borders() const { return border_; }
  const MonolithicBodies& bodies() const { return bodies_; }
  const Problem& problem() const { return problem_; }
  const Step& step() const { return *step_; }
  bool touching(std::int64_t k) const {
    return step_->state[static_cast<std::size_t>(k)] >= PairState::stick;
  }
  /// Law of a pair in units of traction: its own tractions, and slip times rt() of the bodies.
  TangentialLaw law(std::int64_t k) const;
  // Places of unknowns.
  std::int64_t traction(std::int64_t k, int c) const {
    return form_ == MonolithicForm::frictionless ? traction_ + k : traction_ + 3 * k + c;
  }
  std::int64_t gap(std::int64_t k, int c) const {
    return form_ == MonolithicForm::frictionless ? gap_ + k : gap_ + 3 * k + c;
  }
  std::int64_t slip(std::int64_t k, int c) const { return slip_ + 2 * k + c; }
  std::int64_t motion(std::size_t border) const {
    return motion_ + static_cast<std::int64_t>(border);
  }
  /// Sign of the gap vector in the displacement rows: displacements are given by it (tangential),
  /// or make up for it (normal).
  static double sign(int c) { return c == 2 ? 1 : -1; }
  /// rt D of displacements: gap vectors, in units of traction, and those upstream among u at
  /// places.
  double convected(const double* gap, const double* u, std::int64_t k, int c) const;
  std::int64_t nonzeros() const;
  double load_entry(const Border& border, std::int64_t k, int c) const;
  /// Entry of a motion in displacement row (k, c) and in slip row (k, c).
  double gap_entry(const Border& border, std::int64_t k, int c) const;
  double slip_entry(const Border& border, std::int64_t k, int c) const;
  std::size_t bytes() const;

 private:
  bool full() const { return form_ == MonolithicForm::full; }
  bool reduced() const { return form_ == MonolithicForm::reduced; }
  int first_component() const { return form_ == MonolithicForm::frictionless ? 2 : 0; }
  void take_borders();
  void expand(const double* x);

  const Problem& problem_;
  const MonolithicBodies& bodies_;
  MonolithicForm form_;
  const Step* step_ = nullptr;
  std::int64_t traction_ = 0, gap_ = 0, slip_ = 0, motion_ = 0;
  std::vector<Border> border_;
  std::vector<double> t_, k_, u_;
};

}  // namespace rollcon
