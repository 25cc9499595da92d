#pragma once
/// Defines the discrete operators of one contact, made once per bodies, frame and scheme, asked for every load,
/// creepage and friction: rows r = 0, 1 are the convective slip per unit rolling speed, D (A lambda)_t; row r = 2 is
/// the normal displacement (A lambda)_n. Columns c: traction components t1, t2, n.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "linalg/gmres.hpp"

namespace rollcon {

class ReducedSystem;  // contact/linear/reduced_system.hpp

/// Selects some of the rows or columns.
struct Components {
  int first = 0, last = 2;
  bool slip() const { return first < 2; }
  bool normal() const { return last == 2; }
};
inline constexpr Components slip_components{0, 1}, normal_component{2, 2};

/// Inverts a system on active nodes approximately where its operators are not formed.
class FieldPreconditioner : public LinearOperator {
 public:
  /// Brings it up to date with the system's nodes, laws and borders.
  virtual void take(const ReducedSystem& system) = 0;
  virtual std::size_t bytes() const = 0;
};

class Operators {
 public:
  virtual ~Operators() = default;

  // Members that tell what there is follow.
  std::int64_t nodes = 0;
  bool coupled = false;
  bool coupling_vanished = false;           ///< assembled and found to be zero to rounding
  bool normal = false, tangential = false;  ///< rows that are there

  /// Computes image[r], the wanted rows times the tractions of the wanted columns, at these nodes at least, or
  /// at all where none are named. Several threads may ask at once.
  virtual void images(Components wanted, Components columns, std::span<const std::int32_t> nodes,
                      const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const = 0;
  /// Says whether images() finds those of all nodes at once, and with coupling all rows at the price of one: rows are
  /// not formed then.
  virtual bool all_at_once() const = 0;
  /// Returns row r of node k over the tractions c of all nodes, the rows of the nodes one behind the other; null: zero,
  /// or rows are not formed.
  virtual const double* row(int /*r*/, int /*c*/, std::size_t /*k*/) const { return nullptr; }
  /// Returns the entry of node k's own row r and column c.
  virtual double own(int r, int c, std::size_t k) const = 0;
  /// Returns the 2-norm of the tangential columns of slip row r of node k.
  virtual double slip_norm(int r, std::size_t k) const = 0;
  /// Makes what inverts Newton's systems approximately where rows are not formed; else null.
  virtual std::unique_ptr<FieldPreconditioner> make_preconditioner() const { return nullptr; }
  /// Says whether they are a lattice's, whose nodes respond all alike.
  virtual bool on_lattice() const { return false; }
  virtual std::size_t bytes() const = 0;
  /// Counts applications to whole fields, so far.
  virtual std::int64_t applications() const { return 0; }
};

}  // namespace rollcon
