#pragma once
/// Builds the system of one step, (48), (58), (62) and (88) in one form, in units of traction:
///
///   [ K  -B  . ] [ d ]   bodies that are written out
///   [ R   S  G ] [ c ]   contact of the pairs that touch
///   [ .   L  . ] [ m ]   loads
///
/// d: unknowns of the bodies; c: tractions that no law gives at once; m: unknown motions. Tractions that friction's law
/// gives are left out: those of open pairs, and at sliding pairs the one along the slip, which follows the pressure,
/// and also the one across it where the slip has no part in the law (frozen directions, no friction). S holds the laws'
/// own tractions and what half-spaces, or bodies whose unknowns are eliminated, contribute. Gap vectors and slips,
/// unknowns of the paper's systems as well, follow from d and c by their own equations (Images).

#include <span>

#include "linalg/gmres.hpp"
#include "linalg/sparse_lu.hpp"
#include "procedures/images.hpp"

namespace rollcon {

class ContactEquations final : public LinearOperator {
 public:
  ContactEquations(const Problem& problem, const BodiesEquations& bodies, const Images& images)
      : problem_(problem), bodies_(bodies), images_(images) {}

  /// Takes the unknowns, rows and S of a step.
  void take(const Step& step);
  void right_side(const Step& step, std::vector<double>& b) const;
  void start(const Point& z, std::vector<double>& x) const;
  /// Writes tractions, motions, the bodies' unknowns and all images of a solution into `next`.
  void scatter(const std::vector<double>& x, Point& next) const;
  void apply(const double* x, double* y) override;

  struct Unknown {
    std::int64_t node = 0;
    std::array<double, 3> direction{};     ///< unit vector along the component of the traction that is the unknown
    std::array<double, 3> traction{};      ///< traction per unit, along the direction and what follows it
    std::array<double, 3> image{}, own{};  ///< the unknown's row: weights of the node's images and tractions
    double reach = 0;                      ///< for a row that gives a displacement: displacement per slip of an unknown
                                           ///< motion
  };
  std::span<const Unknown> unknowns() const { return unknown_; }
  const BodiesEquations& bodies() const { return bodies_; }
  /// Returns the number of the bodies' unknowns, which come first.
  std::int64_t inner() const { return bodies_.unknowns(); }
  std::int64_t pairs() const { return static_cast<std::int64_t>(node_.size()); }
  std::int64_t motions() const { return static_cast<std::int64_t>(motion_.size()); }
  /// Returns the order of S with G and L; size() is that of the whole matrix.
  std::int64_t contact_size() const { return static_cast<std::int64_t>(unknown_.size() + motion_.size()); }
  std::int64_t size() const { return inner() + contact_size(); }
  /// Returns S, G and L, row-major.
  const RowMatrix<double>& contact() const { return contact_; }
  /// Says whether tractions of one pair act on another without the bodies' unknowns.
  bool couples_pairs() const { return has_entries(images_.blocks()); }
  /// Computes contact() with other images.
  void contact_matrix(const Blocks& blocks, RowMatrix<double>& out) const;
  /// Computes the tractions of all nodes, 3 per node.
  void tractions(const double* c, std::vector<double>& t) const;
  /// Assembles the whole matrix.
  void assemble(SparseMatrix& out) const;
  void assemble(double* dense) const;  ///< column-major
  std::int64_t nonzeros() const;
  std::size_t bytes() const;

 private:
  struct Motion {
    int which = 0;
    double scale = 1;     ///< unknown = motion times scale, a traction
    double per_load = 1;  ///< scale of the load's row
  };
  void add(const Step& step, std::int64_t k);
  void add_row(std::int64_t k, double q0, double q1, const TangentialLaw& law);
  void take_motions();
  double motion_entry(const Unknown& row, const Motion& motion) const;
  double load_entry(const Motion& motion, const Unknown& column) const;
  SparseMatrix body_rows() const;
  SparseMatrix loads() const;

  const Problem& problem_;
  const BodiesEquations& bodies_;
  const Images& images_;
  Prescribed given_;  ///< motions and loads of the step
  std::vector<Unknown> unknown_;
  std::vector<std::int64_t> node_;  ///< nodes that touch
  std::vector<std::size_t> first_;  ///< first unknown of each of those nodes, and the end
  std::vector<Motion> motion_;
  RowMatrix<double> contact_;
  std::vector<double> t_;
};

}  // namespace rollcon
