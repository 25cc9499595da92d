#pragma once
/// Applies operators of bodies that respond nearly as half-spaces do: those of half-spaces on a lattice, and a
/// correction of low rank.

#include <memory>

#include "bodies/halfspace/near_halfspaces.hpp"
#include "contact/operators/lattice/lattice_operator.hpp"

namespace rollcon {

class CorrectedLattice final : public Operators {
 public:
  /// Takes operators of the half-spaces, and what displacements of all samples of `convection` have besides. rest: size
  /// of what may be left out of the correction of a row, over the row's own entry.
  CorrectedLattice(std::shared_ptr<const LatticeOperator> half_spaces, const NearHalfspaces& near,
                   const Convection& convection, double rest);

  void images(Components wanted, Components columns, std::span<const std::int32_t> at,
              const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const override;
  bool all_at_once() const override { return true; }
  double own(int r, int c, std::size_t k) const override;
  double slip_norm(int r, std::size_t k) const override { return half_spaces_->slip_norm(r, k); }
  std::unique_ptr<FieldPreconditioner> make_preconditioner() const override {
    return half_spaces_->make_preconditioner();
  }
  std::size_t bytes() const override;
  std::int64_t applications() const override { return half_spaces_->applications(); }
  std::int64_t rank() const { return left_[0].columns(); }

 private:
  std::shared_ptr<const LatticeOperator> half_spaces_;
  RowMatrix<double> left_[3], right_[3];  ///< rows by node
};

}  // namespace rollcon
