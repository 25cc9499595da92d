#pragma once
/// What the monolithic system needs of the bodies, in units of traction: their equations balanced
/// row by row, their displacements at the frame's nodes and at the points upstream.

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "contact/problem/problem.hpp"
#include "linalg/factored_matrix.hpp"
#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_lu.hpp"

namespace rollcon {

/// Displacements are listed by place: 3 k + c for component c at node k, then, with the
/// characteristic scheme, 3 n + 2 k + c for tangential component c at its upstream point.
class MonolithicBodies {
 public:
  /// Throws Error(err_unsupported) when a body cannot be written out.
  MonolithicBodies(const Problem& problem, const Frame& frame, const Compliance& compliance);

  struct Body {
    std::shared_ptr<const BodyEquations> equations;
    std::int64_t first = 0;           ///< of its unknowns among those of both bodies
    std::vector<double> row, column;  ///< scales: row K column is of order one
    SparseMatrix load;               ///< B
    SparseMatrix place;              ///< by place: displacement per unknown, unscaled
    SparseMatrix unknown;            ///< by unknown: the same
  };

  std::int64_t unknowns() const { return unknowns_; }
  std::int64_t nodes() const { return nodes_; }
  std::int64_t places() const { return places_; }
  bool ahead() const { return places_ > 3 * nodes_; }
  const std::vector<Body>& bodies() const { return body_; }
  /// Displacement per traction of half-spaces, places by 3 nodes, column-major; null: none.
  const double* direct() const { return direct_.empty() ? nullptr : direct_.data(); }
  /// Of the whole: traction per gap and per slip at every node, positive. Those of the problem at
  /// construction, means where these vanish.
  const std::vector<double>& rn() const { return rn_; }
  const std::vector<double>& rt() const { return rt_; }

  /// y = row (K column d - B t); t: 3 per node.
  void balance(const double* d, const double* t, double* y) const;
  /// u at all places.
  void displacements(const double* d, const double* t, double* u) const;
  /// Likewise from normal tractions, one per node; normal components at nodes alone.
  void normal_displacements(const double* d, const double* t, double* u) const;
  /// Solves row K column d = y, in place. Factorises K when called for the first time.
  void solve(double* y);
  /// An equation of its own for every unknown: of boundary elements, whose rows come in another
  /// order, that in which it weighs most.
  const std::vector<std::int64_t>& own_rows() const;
  std::int64_t factorizations() const { return factorizations_; }
  /// Entries that a solve passes through.
  double factor_entries() const;
  std::size_t bytes() const;

 private:
  void take(const Problem& problem, ExpandedCompliance expanded);
  void factor();

  struct Factor {
    std::unique_ptr<SparseFactor> symmetric;
    SparseLu sparse;
    FactoredMatrix dense;
  };
  std::int64_t nodes_ = 0, places_ = 0, unknowns_ = 0, factorizations_ = 0;
  std::vector<Body> body_;
  std::vector<double> direct_;
  mutable std::vector<double> normal_direct_;  ///< rows and columns of normal components
  mutable std::vector<std::int64_t> own_rows_;
  std::vector<double> rn_, rt_;
  std::vector<Factor> factor_;
};

}  // namespace rollcon
