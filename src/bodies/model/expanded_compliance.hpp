#pragma once
/// Holds a compliance with the bodies' own unknowns written out instead of eliminated: the parts of the monolithic
/// systems (48), (58), (62).
///
///   u(points) = sum over bodies of P d  +  N t,     K d = B t
///
/// t are the nodal tractions of the frame (on body 1, local components, t[3 * node + c]), u the displacements u1 - u2
/// that Compliance::block() gives: P K^-1 B + N is that block. For body 2 d is minus its displacement, so that both
/// bodies take the same tractions.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "linalg/dense.hpp"
#include "linalg/sparse_matrix.hpp"

namespace rollcon {

/// Holds K of a body: sparse (finite elements) or dense (boundary elements). Compliance::offset() adds what its own
/// loads and given displacements do.
struct BodyEquations {
  std::int64_t unknowns = 0;
  bool symmetric = false;     ///< true: positive definite
  SparseMatrix matrix;        ///< both triangles; empty when dense
  std::vector<double> dense;  ///< unknowns squared, column-major; empty when sparse

  std::size_t bytes() const { return matrix.bytes() + dense.capacity() * sizeof(double); }
};

struct ExpandedBody {
  std::shared_ptr<const BodyEquations> equations;
  SparseMatrix load;          ///< B: unknowns x (3 nodes of the frame)
  SparseMatrix displacement;  ///< P transposed: unknowns x (3 points)
};

struct ExpandedCompliance {
  std::vector<ExpandedBody> body;  ///< bodies with unknowns of their own
  RowMatrix<double> direct;        ///< N: (3 points) x (3 nodes); empty: zero
};

class Compliance;
struct Points;

/// Makes N with zeros where there is none yet.
void require_direct(std::int64_t points, std::int64_t nodes, ExpandedCompliance& out);
/// Adds the block of a compliance at points to the rows of other points: the rows of point p to those of target[p].
void add_block(const Compliance& local, Points points, std::span<const std::size_t> target, RowMatrix<double>& direct);
/// Adds the block of a compliance without unknowns of its own to N.
void add_direct(const Compliance& local, Points points, ExpandedCompliance& out);

}  // namespace rollcon
