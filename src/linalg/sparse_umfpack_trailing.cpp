#include "linalg/sparse_umfpack_trailing.hpp"

#include <umfpack.h>

#include <algorithm>
#include <new>

#include "linalg/lapack.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using Long = SuiteSparse_long;

/// One compressed factor: L by rows or U by columns.
struct Compressed {
  std::vector<Long> start, index;
  std::vector<double> value;
  Compressed(std::int64_t n, Long entries) : start(at(n + 1)), index(at(entries)) { value.resize(at(entries)); }
};

/// Where the condensed unknowns stand among the last pivots; empty when some do not.
std::vector<std::int64_t> trailing_places(const std::vector<Long>& pivot, std::span<const std::int64_t> condensed) {
  std::vector<std::int64_t> place(pivot.size(), -1), out;
  const std::size_t first = pivot.size() - condensed.size();
  for (std::size_t k = first; k < pivot.size(); ++k) place[at(pivot[k])] = static_cast<std::int64_t>(k - first);
  for (const std::int64_t u : condensed) {
    if (place[at(u)] < 0) return {};
    out.push_back(place[at(u)]);
  }
  return out;
}

// It needs memory of its own to copy factors out.
void require_copied(Long status) {
  if (status < 0) throw std::bad_alloc();
}

}  // namespace

// UMFPACK: L U = P R A Q, R the row scales. So the inverse wanted is Q U^-1 L^-1 P R, of the trailing blocks.
std::vector<double> invert_trailing(void* numeric, std::int64_t n, std::span<const std::int64_t> condensed,
                                    std::size_t* copied) {
  std::vector<Long> rows(at(n)), columns(at(n));
  std::vector<double> scale(at(n));
  Long entries_l = 0, entries_u = 0, n_row = 0, n_column = 0, nonzero_pivots = 0, multiply = 0;
  umfpack_dl_get_lunz(&entries_l, &entries_u, &n_row, &n_column, &nonzero_pivots, numeric);
  require_copied(umfpack_dl_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, rows.data(),
                                        columns.data(), nullptr, &multiply, scale.data(), numeric));
  const std::vector<std::int64_t> row_place = trailing_places(rows, condensed);
  const std::vector<std::int64_t> column_place = trailing_places(columns, condensed);
  const auto size = static_cast<std::int64_t>(condensed.size()), first = n - size;
  *copied = 0;
  if (row_place.empty() || column_place.empty()) return {};

  // Scaled right sides, a unit one for every condensed unknown.
  std::vector<double> right(at(size * size)), trailing(at(size * size));
  for (std::int64_t k = 0; k < size; ++k) {
    const double s = scale[at(condensed[at(k)])];
    right[at(k * size + row_place[at(k)])] = multiply != 0 ? s : 1 / s;
  }
  const auto order = static_cast<int>(size);
  const double one = 1;
  {
    Compressed l(n, entries_l);
    require_copied(umfpack_dl_get_numeric(l.start.data(), l.index.data(), l.value.data(), nullptr, nullptr, nullptr,
                                          nullptr, nullptr, nullptr, nullptr, nullptr, numeric));
    for (std::int64_t i = 0; i < size; ++i)
      for (Long k = l.start[at(first + i)]; k < l.start[at(first + i + 1)]; ++k)
        if (l.index[at(k)] >= first) trailing[at((l.index[at(k)] - first) * size + i)] = l.value[at(k)];
  }
  dtrsm_("L", "L", "N", "U", &order, &order, &one, trailing.data(), &order, right.data(), &order);
  {
    Compressed u(n, entries_u);
    require_copied(umfpack_dl_get_numeric(nullptr, nullptr, nullptr, u.start.data(), u.index.data(), u.value.data(),
                                          nullptr, nullptr, nullptr, nullptr, nullptr, numeric));
    for (std::int64_t j = 0; j < size; ++j)
      for (Long k = u.start[at(first + j)]; k < u.start[at(first + j + 1)]; ++k)
        if (u.index[at(k)] >= first) trailing[at(j * size + u.index[at(k)] - first)] = u.value[at(k)];
  }
  *copied = 16 * at(std::max(entries_l, entries_u)) + 16 * at(size * size);
  dtrsm_("L", "U", "N", "N", &order, &order, &one, trailing.data(), &order, right.data(), &order);

  for (std::int64_t r = 0; r < size; ++r)
    for (std::int64_t k = 0; k < size; ++k) trailing[at(r * size + k)] = right[at(r * size + column_place[at(k)])];
  return trailing;
}

}  // namespace rollcon
