#pragma once
/// Inverts Newton's systems approximately on a lattice of half-spaces, by FFT in single precision.
///
/// Rows of sticking nodes say D (A lambda)_t = given. Convection is undone first, summing slip along the flow from the
/// leading edge (an upwind sweep), which leaves displacements; these are turned into tractions by the symbol of A^-1 on
/// the infinite plane,
///   k / (2 pi) (e e^T / cn + (1 - e e^T) / (cn + cv)),   e = k / |k|,
/// restricted to the nodes in question. Rows of the normal law are inverted by k / (2 pi cn), rows of sliding nodes
/// node by node, borders exactly. Iterations grow slowly with the lattice (docs/theory.md, section 7).

#include <cstdint>
#include <memory>

#include "contact/linear/reduced_system.hpp"
#include "linalg/gmres.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Inverts a system on active nodes approximately where its operators are not formed.
class FieldPreconditioner : public LinearOperator {
 public:
  /// Brings it up to date with the system's nodes, laws and borders.
  virtual void take(const ReducedSystem& system) = 0;
  virtual std::size_t bytes() const = 0;
};

/// Makes a preconditioner for flow along -t1 of the frame's axes.
std::unique_ptr<FieldPreconditioner> make_lattice_preconditioner(const LatticeInfluence& influence);

}  // namespace rollcon
