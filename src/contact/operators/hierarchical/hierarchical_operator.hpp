#pragma once
/// Applies a contact's operators on an irregular plane frame above bodies that respond alike everywhere, in time and
/// memory that grow with the number of nodes: integrals near each node, and series between squares that are far from
/// each other (docs/theory.md, section 3).

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "bodies/model/translation.hpp"
#include "contact/convection/convection.hpp"
#include "contact/operators/hierarchical/cell_series.hpp"
#include "contact/operators/operators.hpp"

namespace rollcon {

class HierarchicalOperator final : public Operators {
 public:
  /// Prepares the operators. The compliance knows parts and its kernel points; accuracy: that of the compliance's
  /// integrals. Slip rows are made if wanted. Everything that is needed is copied but the kernel. Throws err_memory
  /// where there is no room for them, before anything is integrated.
  HierarchicalOperator(const Frame& frame, const Compliance& compliance, const Convection& convection, bool slip,
                       double accuracy, int threads);
  ~HierarchicalOperator() override;

  void images(Components wanted, Components columns, std::span<const std::int32_t> at,
              const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const override;
  bool all_at_once() const override { return true; }
  double own(int r, int c, std::size_t k) const override { return near(r, c, k, k); }
  double slip_norm(int r, std::size_t k) const override;
  std::unique_ptr<FieldPreconditioner> make_preconditioner() const override;
  std::size_t bytes() const override;
  std::int64_t applications() const override { return applications_.load(); }

  /// Returns the entry of node k's row r and node l's column c as far as it is integrated; 0 where l is not near.
  double near(int r, int c, std::size_t k, std::size_t l) const;
  /// Returns the nodes near node k, in ascending order.
  std::span<const std::int32_t> near_nodes(std::size_t k) const { return leaf_[leaf_of_[k]].column; }
  /// Holds what undoes convection: rows of an upwind derivative, and nodes from upstream to downstream.
  struct Flow {
    SparseRows rows;
    std::vector<std::int32_t> order;
  };
  const Flow& flow() const { return flow_; }
  Vec2 place(std::size_t k) const { return place_[k]; }
  const TranslationKernel& kernel() const { return *kernel_; }

 private:
  struct Leaf {
    std::vector<std::int32_t> row, column;       ///< observing nodes, and nodes that are near
    RowMatrix<double> block[3][3];               ///< [row][column]; empty: zero or not wanted
    std::vector<std::int32_t> source;            ///< nodes of the leaf's own elements
    RowMatrix<double> moments;                   ///< [point of the square][source]
    RowMatrix<double> of_displacement, of_slip;  ///< [row][point of the square]
    std::size_t bytes() const;
  };
  struct Workspace;
  void require_room(const Frame& frame) const;
  void fill_leaf(const Frame& frame, const Compliance& compliance, const Convection& convection, std::int32_t cell);
  void apply(Components wanted, Components columns, std::span<const std::int32_t> asked,
             const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3], Workspace& w) const;
  void mark(Components columns, std::span<const std::int32_t> asked, const std::vector<double> (&lambda)[3],
            Workspace& w) const;
  void gather_moments(Components columns, const std::vector<double> (&lambda)[3], Workspace& w) const;
  const RowMatrix<double>* kernel_of(std::int32_t shift, int r, int c, double& sign) const;
  void transfer(Components wanted, Components columns, int share, int shares, Workspace& w) const;
  void hand_down(Components wanted, Workspace& w) const;
  void spread(Components wanted, Components columns, std::size_t cell, const std::vector<double> (&lambda)[3],
              std::vector<double> (&image)[3], const Workspace& w) const;

  std::shared_ptr<const TranslationKernel> kernel_;
  SquareCells cells_;
  CellSeries series_;
  int threads_;
  std::vector<Leaf> leaf_;                     ///< by cell; others than leaves are empty
  std::vector<std::size_t> leaf_of_, row_of_;  ///< by node
  std::vector<std::array<RowMatrix<double>, point_displacements>> shift_;
  std::vector<Vec2> place_;
  Flow flow_;
  mutable std::mutex idle_lock_;
  mutable std::vector<std::unique_ptr<Workspace>> idle_;  ///< one for each thread that asked at once
  mutable std::atomic<std::int64_t> applications_ = 0;
};

}  // namespace rollcon
