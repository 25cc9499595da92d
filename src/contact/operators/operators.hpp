#pragma once
/// Defines the discrete operators of one contact, made once per bodies, frame and scheme, asked for every load,
/// creepage and friction: rows r = 0, 1 are the convective slip per unit rolling speed, D (A lambda)_t; row r = 2 is
/// the normal displacement (A lambda)_n. Columns c: traction components t1, t2, n.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bodies/model/translation.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

class DenseOperators;

/// Selects some of the rows or columns.
struct Components {
  int first = 0, last = 2;
  bool slip() const { return first < 2; }
  bool normal() const { return last == 2; }
};
inline constexpr Components slip_components{0, 1}, normal_component{2, 2};

/// Holds a lattice and what its influence is computed from.
struct LatticeInfluence {
  const Lattice& lattice;
  const TranslationKernel& kernel;
  bool displacements = false;  ///< slip rows give displacements as they are
};

class Operators {
 public:
  virtual ~Operators() = default;

  // Members that tell what there is follow.
  std::int64_t nodes = 0;
  bool coupled = false;
  bool coupling_vanished = false;           ///< assembled and found to be zero to rounding
  bool normal = false, tangential = false;  ///< rows that are there

  /// Computes image[r], the wanted rows times the tractions of the wanted columns, at these nodes at least. Several
  /// threads may ask at once.
  virtual void images(Components wanted, Components columns, std::span<const std::int32_t> nodes,
                      const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const = 0;
  /// Says whether images() finds those of all nodes at once, and with coupling all rows at the price of one.
  virtual bool all_at_once() const = 0;
  /// Returns the entry of node k's own row r and column c.
  virtual double own(int r, int c, std::size_t k) const = 0;
  /// Returns the 2-norm of the tangential columns of slip row r of node k.
  virtual double slip_norm(int r, std::size_t k) const = 0;
  /// Returns the rows as matrices; null: they are not formed.
  virtual const DenseOperators* dense() const { return nullptr; }
  /// Returns the lattice's influence; null: not known.
  virtual const LatticeInfluence* influence() const { return nullptr; }
  virtual std::size_t bytes() const = 0;
  /// Counts applications to whole fields, so far.
  virtual std::int64_t applications() const { return 0; }
};

}  // namespace rollcon
