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
  /// n by n; rows of nodes that are not there hold nothing.
  RowMatrix<double> block[3][3];
  std::vector<std::uint8_t> there;  ///< nodes whose rows are assembled; empty: all that ever were
  std::int64_t rows = 0;            ///< number of those nodes
  /// Instead of blocks, which are then empty: the same rows applied without being formed.
  std::shared_ptr<FieldOperator> field;
  Convection convection;

  /// Row r of node k times tractions, of the components first to last. Not with a field.
  double product(int r, std::size_t k, const std::vector<double> (&lambda)[3], int first = 0, int last = 2) const;
  bool has_row(std::size_t k) const { return there.empty() || there[k] != 0; }
  std::size_t bytes() const;
};

/// Throws Error(err_memory) where this process cannot have these blocks, of which `rows` rows will be written, beside
/// those that are there.
void require_operator_memory(const ContactOperators& op, const bool (&block)[3][3], std::int64_t rows);

/// Assembles the rows asked for that are not there yet, of nodes with wanted[k] != 0 (empty: of all) and of those that
/// have rows already. Coupling blocks that turn out to be zero (two bodies that mirror each other) are dropped.
/// docs/theory.md, sections 3 and 5.
void assemble_operators(const Frame& frame, const Compliance& compliance, bool want_tangential, ContactOperators& op,
                        std::span<const std::uint8_t> wanted = {});

}  // namespace rollcon
