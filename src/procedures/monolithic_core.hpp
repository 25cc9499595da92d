#pragma once
/// The monolithic system of one step after its trivial pivots: gap vectors and slips, whose own
/// equations give them, tractions of open pairs, known gaps of others. What remains are the
/// unknowns of the bodies, the tractions of the pairs in contact and the motions; every contact
/// equation is then a sum over displacements at a few places. A copy of the step is kept: the core
/// of an earlier step still solves that step's system.

#include <span>

#include "procedures/monolithic_matrix.hpp"

namespace rollcon {

class MonolithicCore {
 public:
  /// Takes the step of the matrix, and its form.
  void take(const MonolithicMatrix& matrix);

  std::int64_t size() const { return motion_ + static_cast<std::int64_t>(borders()); }
  void assemble(SparseMatrix& out) const;
  /// Column-major.
  void assemble(double* dense) const;

  /// From a right side of the whole system to one of the core, and from the core's solution to the
  /// whole one.
  void reduce(const double* whole, std::vector<double>& core);
  void recover(const double* whole, const std::vector<double>& core, double* solution);

  struct Unknown {
    std::int64_t node = 0;
    int component = 0;
    std::array<double, 3> traction{};  ///< per unit
  };
  std::span<const Unknown> unknowns() const { return unknown_; }
  std::int64_t first() const { return matrix_->bodies().unknowns(); }
  std::size_t borders() const { return matrix_->borders().size(); }
  const MonolithicMatrix& matrix() const { return *matrix_; }
  /// Contact equation of unknown a: its displacements at places, with their weights.
  template <class Visit>
  void row(std::size_t a, Visit visit) const {
    for (std::size_t e = row_start_[a]; e < row_start_[a + 1]; ++e) visit(place_[e], weight_[e]);
  }
  /// First unknown of a node, or of the next that has any.
  std::size_t of_node(std::int64_t k) const { return of_node_[static_cast<std::size_t>(k)]; }
  /// ... entry of the tractions of unknown b in it, displacements aside.
  double own(std::size_t a, std::size_t b) const;
  /// ... entry of a motion in it, and of unknown a in that motion's load.
  double border(std::size_t a, std::size_t b) const { return border_[a * borders() + b]; }
  double load(std::size_t b, std::size_t a) const;
  std::size_t bytes() const;

 private:
  void add_rows(std::int64_t k);
  void add_convected(std::int64_t k, int c, double factor);
  template <class Sink>
  void columns(Sink& sink) const;

  Step step_;
  std::unique_ptr<MonolithicMatrix> matrix_;  ///< of that step
  std::int64_t motion_ = 0;
  std::vector<Unknown> unknown_;
  std::vector<std::size_t> row_start_, of_node_;  ///< of_node_: first unknown of each node
  std::vector<std::int64_t> place_;
  std::vector<double> weight_, border_;
  std::vector<std::size_t> user_start_;  ///< contact equations that use a place
  std::vector<std::pair<std::size_t, double>> user_;
  std::vector<double> x_, product_, t_, gap_, u_;
};

}  // namespace rollcon
