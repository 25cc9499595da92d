#pragma once
/// Assembles the rows of a whole body from packs of points, in a layout that tests read easily.

#include <span>
#include <vector>

#include "bodies/bem/boundary_integrals.hpp"

namespace rollcon::assembled_rows {

struct Rows {
  std::int64_t columns = 0;
  std::vector<double> value;  ///< [(3 * point + i) * 3 * columns + 3 * column + c]
  double operator()(std::size_t point, int i, std::size_t column, int c) const {
    return value[(3 * point + static_cast<std::size_t>(i)) * 3 * static_cast<std::size_t>(columns) + 3 * column +
                 static_cast<std::size_t>(c)];
  }
  double largest() const;
};

std::vector<bem::CollocationPoint> all_nodes(const SurfaceMesh& mesh);

/// Holds h, and g with one column per node where it is asked for.
struct System {
  Rows h, g;
};
System assemble(const bem::BoundaryIntegrals& integrals, const SurfaceMesh& mesh,
                std::span<const bem::CollocationPoint> points, bool double_layer, bool single_layer);
/// Returns the largest difference of two rows.
double difference(const Rows& a, const Rows& b);

}  // namespace rollcon::assembled_rows
