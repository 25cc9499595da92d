#pragma once
/// Operators of a contact that are applied to whole fields and never formed.

#include <cstddef>
#include <cstdint>
#include <memory>

#include "bodies/halfspace/halfspace.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Half-spaces on a lattice: what their influence is computed from.
struct LatticeInfluence {
  const Lattice& lattice;
  HalfspaceConstants constants;
};

class FieldOperator {
 public:
  virtual ~FieldOperator() = default;
  /// image[r] (r = 0, 1: convective slip per unit rolling speed, D (A lambda)_t; 2: normal displacement (A lambda)_n)
  /// at all nodes of the frame, of tractions lambda[c] at all nodes. Null lambda: zero. Null image: not wanted. Several
  /// threads may call at once.
  virtual void apply(const double* const (&lambda)[3], double* const (&image)[3]) const = 0;
  /// Entry of an interior node's own row r and column c.
  virtual double entry(int r, int c) const = 0;
  /// 2-norm of the tangential columns of slip row r of a node amid the others.
  virtual double row_norm(int r) const = 0;
  virtual bool couples() const = 0;
  /// What it convolves with.
  virtual LatticeInfluence influence() const = 0;
  virtual std::size_t bytes() const = 0;
  /// Calls of apply() so far.
  virtual std::int64_t applications() const = 0;
};

}  // namespace rollcon
