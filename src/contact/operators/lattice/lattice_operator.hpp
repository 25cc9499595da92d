#pragma once
/// Applies a contact's operators on a lattice above bodies that respond alike everywhere in n log n time and O(n)
/// memory by convolution, exact to rounding (docs/theory.md, section 3).

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "bodies/model/translation.hpp"
#include "contact/convection/convection.hpp"
#include "contact/operators/operators.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Holds a lattice and what its influence is computed from.
struct LatticeInfluence {
  const Lattice& lattice;
  const TranslationKernel& kernel;
  bool displacements = false;  ///< slip rows give displacements as they are
};

class LatticeOperator final : public Operators {
 public:
  /// Prepares the operators. delta > 0: characteristic scheme, distance to the upstream point (the same at all nodes).
  /// delta = 0: `convection` holds the rows of an upwind scheme; displacements: they are no derivatives. The lattice
  /// needs an inner node. Throws Error(err_unsupported) in a build without FFTW.
  LatticeOperator(Lattice lattice, std::shared_ptr<const TranslationKernel> kernel, double delta, SparseRows convection,
                  bool displacements = false);
  ~LatticeOperator() override;

  /// Computes image[r] at all nodes from tractions lambda[c] at all nodes. Null lambda: zero. Null image: not wanted.
  void apply(const double* const (&lambda)[3], double* const (&image)[3]) const;

  void images(Components wanted, Components columns, std::span<const std::int32_t> at,
              const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const override;
  bool all_at_once() const override { return true; }
  /// Returns the entry of a node amid the others, as all are taken to be.
  double own(int r, int c, std::size_t k) const override;
  double slip_norm(int r, std::size_t k) const override;
  const LatticeInfluence& influence() const;
  std::unique_ptr<FieldPreconditioner> make_preconditioner() const override;  ///< linear/lattice_preconditioner.cpp
  bool on_lattice() const override { return true; }
  std::size_t bytes() const override;
  std::int64_t applications() const override { return applications_.load(); }

 private:
  struct Shared;
  struct Workspace;
  std::unique_ptr<Workspace> take_workspace() const;
  void give_back(std::unique_ptr<Workspace> work) const;

  std::unique_ptr<const Shared> shared_;
  mutable std::mutex idle_lock_;
  mutable std::vector<std::unique_ptr<Workspace>> idle_;  ///< one for each thread that applied it at once
  mutable std::atomic<std::int64_t> applications_ = 0;
};

}  // namespace rollcon
