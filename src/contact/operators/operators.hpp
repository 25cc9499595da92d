#pragma once
/// The discrete operators of one contact: dense, computed once per bodies, frame and scheme, reused for every load,
/// creepage and friction.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "contact/operators/convection/convection.hpp"
#include "contact/operators/field_operator.hpp"
#include "linalg/dense.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// block[r][c]: rows r = 0, 1 are the convective slip per unit rolling speed, D (A lambda)_t; row r = 2 is the normal
/// displacement (A lambda)_n. Columns c: traction components t1, t2, n. Blocks that vanish or are not needed are empty.
struct ContactOperators {
  std::int64_t nodes = 0;
  bool coupled = false;
  bool coupling_vanished = false;           ///< assembled and found to be zero to rounding
  bool normal = false, tangential = false;  ///< which rows are assembled
  RowMatrix<double> block[3][3];            ///< n by n
  /// Instead of blocks, which are then empty: the same rows applied without being formed.
  std::shared_ptr<FieldOperator> field;
  Convection convection;

  /// Row r of node k times tractions, of the components first to last. Not with a field.
  double product(int r, std::size_t k, const std::vector<double> (&lambda)[3], int first = 0, int last = 2) const;
  std::size_t bytes() const;
};

/// Throws Error(err_memory) where this process cannot have these blocks beside those that are there.
void require_operator_memory(const ContactOperators& op, const bool (&block)[3][3]);

/// Assembles the blocks asked for that are not there yet. Coupling blocks that turn out to be zero (two bodies that
/// mirror each other) are dropped.
/// docs/theory.md, sections 3 and 5.
void assemble_operators(const Frame& frame, const Compliance& compliance, bool want_tangential, ContactOperators& op);

}  // namespace rollcon
