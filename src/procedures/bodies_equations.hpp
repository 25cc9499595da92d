#pragma once
/// Holds the equations of bodies whose unknowns are written out, balanced row by row, and such that the unknowns are
/// tractions. It is empty where the bodies' unknowns are eliminated, or they have none.

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "linalg/factored_matrix.hpp"
#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_lu.hpp"
#include "linalg/sparse_matrix.hpp"

namespace rollcon {

/// Calls visit(row, value) for the entries of a column.
template <class Visit>
void entries(const SparseMatrix& a, std::int64_t column, Visit visit) {
  const auto j = static_cast<std::size_t>(column);
  for (auto k = static_cast<std::size_t>(a.start[j]); k < static_cast<std::size_t>(a.start[j + 1]); ++k)
    visit(a.row[k], a.value[k]);
}

class BodiesEquations {
 public:
  BodiesEquations() = default;
  /// Takes equations and loads, and leaves the displacements.
  explicit BodiesEquations(ExpandedCompliance& expanded);

  struct Body {
    std::shared_ptr<const BodyEquations> equations;
    std::int64_t first = 0;           ///< first of the body's unknowns among those of all bodies
    std::vector<double> row, column;  ///< scales: row K column is of order one
    SparseMatrix load;                ///< B
    /// Calls visit(i, value) for the entries of column j of row K column.
    template <class Visit>
    void scaled(std::int64_t j, Visit visit) const;
  };

  std::int64_t unknowns() const { return unknowns_; }
  const std::vector<Body>& bodies() const { return body_; }
  /// Computes y = row (K column d - B t), with 3 entries of t per node.
  void balance(const double* d, const double* t, double* y) const;
  /// Adds row B t to y.
  void add_loads(const double* t, double* y) const;
  /// Solves row K column d = y, in place. Factorises K when called for the first time.
  void solve(double* y);
  /// Returns an equation of its own for every unknown. Boundary elements have their rows in another order, so the
  /// equation in which the unknown weighs most stands for it.
  const std::vector<std::int64_t>& own_rows();
  std::int64_t factorizations() const { return factorizations_; }
  std::size_t bytes() const;

 private:
  struct Factor {
    std::unique_ptr<SparseFactor> symmetric;
    SparseLu sparse;
    FactoredMatrix dense;
  };
  static Factor factor(const BodyEquations& equations);

  std::int64_t unknowns_ = 0, factorizations_ = 0;
  std::vector<Body> body_;
  std::vector<std::int64_t> own_rows_;
  std::vector<Factor> factor_;
};

template <class Visit>
void BodiesEquations::Body::scaled(std::int64_t j, Visit visit) const {
  const BodyEquations& e = *equations;
  const double scale = column[static_cast<std::size_t>(j)];
  const auto entry = [&](std::int64_t i, double v) { visit(i, row[static_cast<std::size_t>(i)] * v * scale); };
  if (e.dense.empty()) return entries(e.matrix, j, entry);
  const double* from = e.dense.data() + j * e.unknowns;
  for (std::int64_t i = 0; i < e.unknowns; ++i) entry(i, from[i]);
}

}  // namespace rollcon
