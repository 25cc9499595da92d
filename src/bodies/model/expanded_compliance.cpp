#include "bodies/model/expanded_compliance.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "bodies/model/compliance.hpp"
#include "support/memory_limit.hpp"

namespace rollcon {

void require_direct(std::int64_t points, std::int64_t nodes, ExpandedCompliance& out) {
  if (!out.direct.empty()) return;
  // Callers make a copy of this, without normal displacements of the points upstream.
  const auto columns = static_cast<double>(3 * nodes);
  const auto rows = static_cast<double>(3 * points);
  const auto copied = static_cast<double>(3 * nodes + 2 * (points - nodes));
  const double bytes = 8 * columns * (rows + copied);
  require_memory({bytes, bytes}, "choose the condensed system (rollcon_contact_set_procedure), or take a coarser frame",
                 "the monolithic system of a frame of %lld nodes on half-spaces needs", static_cast<long long>(nodes));
  out.direct.resize(3 * points, 3 * nodes);
  std::fill_n(out.direct.data(), static_cast<std::size_t>(9 * points * nodes), 0.0);
}

void add_block(const Compliance& local, Points points, std::span<const std::size_t> target, RowMatrix<double>& direct) {
  const std::int64_t n = local.nodes();
  constexpr std::size_t slab = 256;  // points at a time
  double some = 0;
  ComplianceBlock wanted;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (local.couples() || (i == 2) == (j == 2)) wanted.a[i][j] = &some;
  const BlockBuffer buffer(wanted, std::min(slab, points.size()), n);
  for (std::size_t first = 0; first < points.size(); first += slab) {
    const std::size_t count = std::min(slab, points.size() - first);
    local.block({points.x.subspan(first, count), points.y.subspan(first, count)}, buffer.block());
    for (std::size_t p = 0; p < count; ++p)
      for (std::size_t i = 0; i < 3; ++i) {
        double* row = direct.row(static_cast<std::int64_t>(3 * target[first + p] + i));
        for (std::size_t j = 0; j < 3; ++j) {
          if (!wanted.a[i][j]) continue;
          const double* from = buffer.row(i, j, p);
          for (std::int64_t k = 0; k < n; ++k) row[3 * k + static_cast<std::int64_t>(j)] += from[k];
        }
      }
  }
}

void add_direct(const Compliance& local, Points points, ExpandedCompliance& out) {
  require_direct(static_cast<std::int64_t>(points.size()), local.nodes(), out);
  std::vector<std::size_t> target(points.size());
  std::iota(target.begin(), target.end(), std::size_t{0});
  add_block(local, points, target, out.direct);
}

}  // namespace rollcon
