#include <umfpack.h>

#include <algorithm>
#include <new>
#include <numeric>

#include "linalg/sparse_metis_random.hpp"
#include "linalg/sparse_order.hpp"

namespace rollcon {

GraphOrder dissect_by_umfpack(const SparseGroups& groups) {
  using Long = SuiteSparse_long;
  static_assert(sizeof(Long) == sizeof(std::int64_t));
  GraphOrder out;
  out.group.resize(static_cast<std::size_t>(groups.count));
  std::iota(out.group.begin(), out.group.end(), 0);
  if (groups.neighbour.empty()) return out;

  // With a diagonal, so that the order is one for both rows and columns; rows ascending.
  std::vector<Long> start{0}, row;
  row.reserve(groups.neighbour.size() + out.group.size());
  for (std::size_t g = 0; g < out.group.size(); ++g) {
    const auto from = groups.neighbour.begin() + groups.start[g];
    const auto to = groups.neighbour.begin() + groups.start[g + 1];
    const auto after = std::lower_bound(from, to, static_cast<std::int64_t>(g));
    row.insert(row.end(), from, after);
    row.push_back(static_cast<Long>(g));
    row.insert(row.end(), after, to);
    start.push_back(static_cast<Long>(row.size()));
  }
  double control[UMFPACK_CONTROL], info[UMFPACK_INFO];
  umfpack_dl_defaults(control);
  control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
  control[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
  const auto n = static_cast<Long>(out.group.size());
  std::vector<Long> column(out.group.size());
  void* symbolic = nullptr;
  const MetisRandom random;
  if (umfpack_dl_symbolic(n, n, start.data(), row.data(), nullptr, &symbolic, control, info) < 0) {
    control[UMFPACK_ORDERING] = UMFPACK_ORDERING_AMD;
    if (umfpack_dl_symbolic(n, n, start.data(), row.data(), nullptr, &symbolic, control, info) < 0)
      throw std::bad_alloc();
  }
  const Long status =
      umfpack_dl_get_symbolic(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, column.data(), nullptr,
                              nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, symbolic);
  umfpack_dl_free_symbolic(&symbolic);
  if (status < 0) throw std::bad_alloc();
  out.group.assign(column.begin(), column.end());
  out.peak_bytes = sizeof(Long) * (start.size() + row.size()) +
                   static_cast<std::size_t>(info[UMFPACK_SYMBOLIC_PEAK_MEMORY] * info[UMFPACK_SIZE_OF_UNIT]);
  return out;
}

}  // namespace rollcon
