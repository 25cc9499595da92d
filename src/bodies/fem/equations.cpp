/// Writes finite elements out as matrix and right sides, with nothing factorised.

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/fem/system.hpp"
#include "support/index.hpp"

namespace rollcon::fem {
namespace {

/// Arranges a coupling by columns, numbered by their place in `column`; rows are places in coupling.node.
SparseMatrix by_columns(SurfaceCoupling coupling, const std::vector<std::int32_t>& column) {
  coupling.rows = static_cast<std::int64_t>(column.size());
  for (std::int64_t& k : coupling.row) k = std::lower_bound(column.begin(), column.end(), k) - column.begin();
  return transposed(coupling);
}

/// Leaves out what is below the rounding of the largest entry of its column.
SparseMatrix by_columns(const RowMatrix<double>& matrix) {
  constexpr double negligible = 1e-17;
  std::vector<double> least(at(matrix.columns()), 0.0);
  for (std::int64_t r = 0; r < matrix.rows(); ++r)
    for (std::int64_t k = 0; k < matrix.columns(); ++k)
      least[at(k)] = std::max(least[at(k)], negligible * std::abs(matrix.row(r)[k]));
  SparseMatrix result;
  result.begin(matrix.rows());
  for (std::int64_t k = 0; k < matrix.columns(); ++k) {
    for (std::int64_t r = 0; r < matrix.rows(); ++r)
      if (const double v = matrix.row(r)[k]; std::abs(v) > least[at(k)]) result.push(r, v);
    result.end_column();
  }
  return result;
}

}  // namespace

std::shared_ptr<const BodyEquations> System::equations(int threads) {
  const std::lock_guard lock(mutex_);
  if (auto known = equations_.lock()) return known;
  require_matrix(threads);
  auto equations = std::make_shared<BodyEquations>();
  equations->unknowns = unknowns_.count;
  equations->symmetric = true;
  equations->matrix = both_triangles(matrix_);
  count_peak(matrix_.bytes() + equations->bytes());
  if (options_.keep_factors == 0) matrix_ = {};
  equations_ = equations;
  return equations;
}

void System::write_loads(const std::vector<std::int32_t>& loaded, const SparseMatrix& entries,
                         SurfaceLoads& loads) const {
  loads.unknown.clear();
  for (const std::int32_t k : loads.row)
    for (std::size_t c = 0; c < 3; ++c) loads.unknown.push_back(unknowns_.of[3 * at(k) + c]);
  SparseMatrix& b = loads.load;
  b.begin(unknowns_.count);
  for (std::int64_t k = 0; k < entries.columns; ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::int64_t i = entries.start[at(k)]; i < entries.start[at(k) + 1]; ++i)
        if (const std::int64_t u = unknowns_.of[3 * at(loaded[at(entries.row[at(i)])]) + c]; u >= 0)
          b.push(u, entries.value[at(i)] / reference_);
      b.end_column();
    }
}

void System::load(const LoadedSurface& surface, SurfaceLoads& loads, int /*threads*/) {
  if (surface.of_faces()) {
    const SurfaceCoupling mass = couple_faces(surface_, surface.face);
    return write_loads(mass.node, by_columns(mass, loads.column), loads);
  }
  FeltTractions felt = feel(surface.layer, loads);
  write_loads(felt.node, by_columns(felt.load), loads);
  felt.tell(loads);
}

}  // namespace rollcon::fem
