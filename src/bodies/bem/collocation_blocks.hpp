#pragma once
/// Gives a boundary-element body's equations by blocks of rows and columns, or as sums of columns. Integrals are taken
/// only over the elements that the columns belong to.

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/bem/lifted_surface.hpp"
#include "bodies/bem/unknowns.hpp"
#include "linalg/hierarchical_factor.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon::bem {

class CollocationBlocks final : public BlockMatrix {
 public:
  /// Holds a part of a column: a factor on the effect of a node's displacement or a traction node's traction over G.
  struct Term {
    std::int32_t of = 0;
    int component = 0;
    bool traction = false;
    double factor = 0;
  };
  /// All references must outlive the object. fan_size scales unknown tractions.
  CollocationBlocks(const BodyMesh& mesh, const TractionNodes& fans, const LiftedSurface& lifted,
                    const BoundaryIntegrals& integrals, const Unknowns& unknowns, const std::vector<double>& fan_size,
                    int threads);

  void block(std::span<const std::int32_t> rows, std::span<const std::int32_t> columns, double* to) const override;
  /// Returns a column of all rows that is the sum of some terms.
  std::vector<double> column(std::span<const Term> terms) const;

 private:
  template <class Item>
  struct Lists {
    std::vector<std::int64_t> start;
    std::vector<Item> item;
    /// Takes pairs of a list's number and an item.
    void build(std::size_t lists, const std::vector<std::pair<std::int32_t, Item>>& from);
    std::span<const Item> operator[](std::int32_t k) const {
      return {item.data() + start[static_cast<std::size_t>(k)], item.data() + start[static_cast<std::size_t>(k) + 1]};
    }
  };
  struct Gathered;
  void gather(std::span<const Term> terms, std::int64_t column, Gathered& to) const;
  void evaluate(std::span<const std::int32_t> rows, Gathered& columns, double* to) const;
  void find_totals() const;

  const LiftedSurface& lifted_;
  const BoundaryIntegrals& integrals_;
  const Unknowns& unknowns_;
  int threads_;
  std::vector<std::int32_t> row_point_;  ///< 3 times the point, plus the component, of each row
  Lists<Term> terms_;                    ///< terms by unknown
  Lists<Part> lifted_of_;                ///< nodes of the lifted mesh that move with a node of the body
  Lists<Part> entries_;                  ///< entries of the lifted connectivity with a part of a traction node
  Lists<std::int32_t> elements_;         ///< elements by node of the lifted mesh
  std::vector<std::int32_t> element_;    ///< element by entry of the lifted connectivity
  mutable std::vector<double> total_;    ///< sums of blocks by point, 9 each; empty until they are needed
  mutable std::vector<std::int32_t> h_column_, g_column_, slot_;  ///< scratch, -1 between calls
  mutable std::vector<std::uint8_t> taken_;                       ///< scratch by element, 0 between calls
};

}  // namespace rollcon::bem
