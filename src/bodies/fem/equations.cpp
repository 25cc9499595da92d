/// Finite elements written out: matrix and right sides, nothing factorised.

#include "bodies/fem/equations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/fem/system.hpp"
#include "support/index.hpp"

namespace rollcon::fem {
namespace {

/// By columns, numbered by their place in `column`; rows are places in coupling.node.
SparseColumns by_columns(const SurfaceCoupling& coupling, const std::vector<std::int32_t>& column) {
  SparseColumns result;
  result.rows = static_cast<std::int64_t>(coupling.node.size());
  result.columns = static_cast<std::int64_t>(column.size());
  result.start.assign(column.size() + 1, 0);
  std::vector<std::size_t> place;
  for (const std::int32_t k : coupling.column) {
    place.push_back(at(std::lower_bound(column.begin(), column.end(), k) - column.begin()));
    ++result.start[place.back() + 1];
  }
  for (std::size_t k = 0; k < column.size(); ++k) result.start[k + 1] += result.start[k];
  result.row.resize(place.size());
  result.value.resize(place.size());
  std::vector<std::int64_t> next(result.start.begin(), result.start.end() - 1);
  for (std::int64_t r = 0; r < result.rows; ++r)
    for (std::int64_t i = coupling.start[at(r)]; i < coupling.start[at(r) + 1]; ++i) {
      const std::size_t to = at(next[place[at(i)]]++);
      result.row[to] = r;
      result.value[to] = coupling.value[at(i)];
    }
  return result;
}

/// Without what is below the rounding of the largest entry of its column.
SparseColumns by_columns(const RowMatrix<double>& matrix) {
  constexpr double negligible = 1e-17;
  SparseColumns result;
  result.rows = matrix.rows();
  result.columns = matrix.columns();
  std::vector<double> least(at(matrix.columns()), 0.0);
  for (std::int64_t r = 0; r < matrix.rows(); ++r)
    for (std::int64_t k = 0; k < matrix.columns(); ++k)
      least[at(k)] = std::max(least[at(k)], negligible * std::abs(matrix.row(r)[k]));
  result.start.push_back(0);
  for (std::int64_t k = 0; k < matrix.columns(); ++k) {
    for (std::int64_t r = 0; r < matrix.rows(); ++r)
      if (const double v = matrix.row(r)[k]; std::abs(v) > least[at(k)]) {
        result.row.push_back(r);
        result.value.push_back(v);
      }
    result.start.push_back(static_cast<std::int64_t>(result.row.size()));
  }
  return result;
}

}  // namespace

SparseColumns whole_matrix(const SparseSymmetric& lower) {
  SparseColumns whole;
  whole.rows = whole.columns = lower.n;
  whole.start.assign(at(lower.n) + 1, 0);
  for (std::int64_t c = 0; c < lower.n; ++c)
    for (std::int64_t i = lower.start[at(c)]; i < lower.start[at(c) + 1]; ++i) {
      ++whole.start[at(c) + 1];
      if (lower.row[at(i)] != c) ++whole.start[at(lower.row[at(i)]) + 1];
    }
  for (std::size_t c = 0; c < at(lower.n); ++c) whole.start[c + 1] += whole.start[c];
  whole.row.resize(at(whole.start.back()));
  whole.value.resize(whole.row.size());
  // Column by column of the lower triangle: to each column come its rows above, which are earlier
  // columns, before its own.
  std::vector<std::int64_t> next(whole.start.begin(), whole.start.end() - 1);
  const auto put = [&](std::int64_t row, std::int64_t column, double value) {
    const std::size_t to = at(next[at(column)]++);
    whole.row[to] = row;
    whole.value[to] = value;
  };
  for (std::int64_t c = 0; c < lower.n; ++c)
    for (std::int64_t i = lower.start[at(c)]; i < lower.start[at(c) + 1]; ++i) {
      put(lower.row[at(i)], c, lower.value[at(i)]);
      if (lower.row[at(i)] != c) put(c, lower.row[at(i)], lower.value[at(i)]);
    }
  return whole;
}

std::shared_ptr<const BodyEquations> System::equations(int threads) {
  const std::lock_guard lock(mutex_);
  if (auto known = equations_.lock()) return known;
  require_matrix(threads);
  auto equations = std::make_shared<BodyEquations>();
  equations->unknowns = unknowns_.count;
  equations->symmetric = true;
  equations->matrix = whole_matrix(matrix_);
  statistics_.peak_bytes =
      std::max(statistics_.peak_bytes, bytes_of(matrix_) + bytes_of(equations->matrix));
  if (options_.keep_factors == 0) matrix_ = {};
  equations_ = equations;
  return equations;
}

void System::write_loads(const std::vector<std::int32_t>& loaded, const SparseColumns& entries,
                         SurfaceLoads& loads) const {
  loads.unknown.clear();
  for (const std::int32_t k : loads.row)
    for (std::size_t c = 0; c < 3; ++c) loads.unknown.push_back(unknowns_.of[3 * at(k) + c]);
  SparseColumns& b = loads.load;
  b.rows = unknowns_.count;
  b.columns = 3 * entries.columns;
  b.start.push_back(0);
  for (std::int64_t k = 0; k < entries.columns; ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::int64_t i = entries.start[at(k)]; i < entries.start[at(k) + 1]; ++i) {
        const std::int64_t u = unknowns_.of[3 * at(loaded[at(entries.row[at(i)])]) + c];
        if (u < 0) continue;
        b.row.push_back(u);
        b.value.push_back(entries.value[at(i)] / reference_);
      }
      b.start.push_back(static_cast<std::int64_t>(b.row.size()));
    }
}

void System::load(std::span<const std::int64_t> face, SurfaceLoads& loads, int /*threads*/) {
  const SurfaceCoupling mass = couple_faces(surface_, face);
  write_loads(mass.node, by_columns(mass, loads.column), loads);
}

void System::load(const SurfaceMesh& layer, SurfaceLoads& loads, int /*threads*/) {
  FeltTractions felt = feel(layer, loads);
  write_loads(felt.node, by_columns(felt.load), loads);
  if (felt.traction.rows() == 0) return;
  loads.seen_node = std::move(felt.node);
  loads.seen = std::move(felt.traction);
}

}  // namespace rollcon::fem
