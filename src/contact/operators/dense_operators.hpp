#pragma once
/// Holds operators as matrices.

#include "bodies/model/compliance.hpp"
#include "contact/convection/convection.hpp"
#include "contact/operators/operators.hpp"
#include "linalg/dense.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

struct AssemblySpace;

class DenseOperators final : public Operators {
 public:
  std::shared_ptr<AssemblySpace> space;  ///< room of assemble_operators(), kept where frames are small

  /// Blocks [r][c], n by n; those that vanish or are not needed are empty.
  RowMatrix<double> block[3][3];

  /// Returns row r of node k times tractions.
  double product(int r, std::size_t k, const std::vector<double> (&lambda)[3], Components columns = {}) const;
  void release_slip();  ///< tangential rows alone
  /// Releases all that is there.
  void release();
  /// Throws Error(err_memory) where this process cannot have these blocks beside those that are there.
  void require_memory_for(const bool (&wanted)[3][3]) const;
  /// Gives nodes whose slip equation has no unknowns, as a support keeps them from moving along one tangent (a plane of
  /// symmetry), a little compliance of their own, so that the traction can be found: none where no slip is forced on
  /// it, friction's bound where there is. both: also where both rows vanish, as upwind schemes leave them at the inflow
  /// rim. used: the frame's.
  void loosen_held_tangents(std::span<const std::uint8_t> used, bool both);

  void images(Components wanted, Components columns, std::span<const std::int32_t> at,
              const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const override;
  bool all_at_once() const override { return false; }
  const double* row(int r, int c, std::size_t k) const override {
    return block[r][c].empty() ? nullptr : block[r][c].row(static_cast<std::int64_t>(k));
  }
  double own(int r, int c, std::size_t k) const override {
    const double* all = row(r, c, k);
    return all ? all[k] : 0;
  }
  double slip_norm(int r, std::size_t k) const override;
  std::size_t bytes() const override;
};

/// Assembles the blocks asked for that are not there yet (docs/theory.md, sections 3 and 5). Coupling blocks that turn
/// out to be zero (two bodies that mirror each other) are dropped. mirror, if not empty: node at (x, -y) for each node,
/// of a frame that is its own mirror image above bodies that are, under the characteristic scheme; nodes of y < 0
/// before the others. Half the rows are then assembled, the others mirrored.
void assemble_operators(const Frame& frame, const Compliance& compliance, const Convection& convection,
                        bool want_tangential, DenseOperators& op, std::span<const std::int32_t> mirror = {});

}  // namespace rollcon
