#pragma once
/// A contact's operators on a lattice above half-spaces: applied in n log n time and O(n) memory by convolution, exact
/// to rounding. docs/theory.md, section 3.

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "contact/operators/convection/convection.hpp"
#include "contact/operators/field_operator.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

class LatticeOperator final : public FieldOperator {
 public:
  /// delta > 0: characteristic scheme, distance to the upstream point (the same at all nodes). delta = 0: `convection`
  /// holds the rows of an upwind scheme. The lattice needs an inner node. Throws Error(err_unsupported) in a build
  /// without FFTW.
  LatticeOperator(Lattice lattice, HalfspaceConstants c, double delta, SparseRows convection);
  ~LatticeOperator() override;

  void apply(const double* const (&lambda)[3], double* const (&image)[3]) const override;
  double entry(int r, int c) const override;
  double row_norm(int r) const override;
  bool couples() const override;
  LatticeInfluence influence() const override;
  std::size_t bytes() const override;
  std::int64_t applications() const override { return applications_.load(); }

 private:
  struct Shared;
  struct Workspace;
  std::unique_ptr<Workspace> take_workspace() const;
  void give_back(std::unique_ptr<Workspace> work) const;

  std::unique_ptr<const Shared> shared_;
  mutable std::mutex idle_lock_;
  mutable std::vector<std::unique_ptr<Workspace>> idle_;  ///< as many as threads applied it at once
  mutable std::atomic<std::int64_t> applications_ = 0;
};

}  // namespace rollcon
