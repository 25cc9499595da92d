#pragma once
/// Computes what tractions and the bodies' unknowns do at the nodes of the frame.

#include <memory>

#include "contact/problem/problem.hpp"
#include "procedures/bodies_equations.hpp"
#include "procedures/step.hpp"

namespace rollcon {

/// Says what the tangential images are: nothing (no friction), slip D (A lambda)_t, or displacement (A lambda)_t, from
/// which D makes the slip (reduced unknowns).
enum class Tangential { none, slip, shift };

/// Holds image r (0, 1 tangential, 2 normal) per traction c, n by n, row by row; null stands for zero.
using Blocks = std::array<std::array<const double*, 3>, 3>;

inline bool has_entries(const Blocks& blocks) {
  return blocks[2][2] != nullptr;
}

class Images {
 public:
  /// Serves bodies whose unknowns are eliminated: takes the operators of the problem, which must be assembled and
  /// outlive this, and the compliance's displacements.
  Images(const Problem& problem, const Frame& frame, const Compliance& compliance, Tangential kind);
  /// Serves bodies with unknowns written out, at the nodes and, behind them, at the points upstream.
  Images(const Problem& problem, const ExpandedCompliance& expanded, const BodiesEquations& bodies, Tangential kind);
  Images(const Images&) = delete;
  Images& operator=(const Images&) = delete;

  Tangential kind() const { return kind_; }
  /// Computes the images of unknowns and tractions into slip, depth and shift of a point.
  void apply(Point& z) const;
  /// Returns the images per traction; null where these have none.
  const Blocks& blocks() const { return block_; }
  /// Calls visit(unknown, value) for image r of node k per unknown of the bodies.
  template <class Visit>
  void per_unknown(std::int64_t k, int r, Visit visit) const {
    if (!unknown_.start.empty()) entries(unknown_, 3 * k + r, visit);
  }
  /// Returns rough images of half-spaces of the pair's modulus, whatever the bodies are.
  Blocks rough(const Frame& frame);
  std::size_t bytes() const;

 private:
  bool wanted(int r, int c) const { return kind_ != Tangential::none || (r == 2 && c == 2); }
  template <class Visit>
  void stencil(std::int64_t k, int r, Visit visit) const;

  const Problem& problem_;
  Tangential kind_;
  Blocks block_{};
  RowMatrix<double> own_[3][3], rough_[2];
  SparseMatrix unknown_;  ///< columns by image
};

}  // namespace rollcon
