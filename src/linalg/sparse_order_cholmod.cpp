#include <new>
#include <numeric>

#include "linalg/sparse_cholmod_common.hpp"
#include "linalg/sparse_metis_random.hpp"
#include "linalg/sparse_order.hpp"

namespace rollcon {

GraphOrder dissect(const SparseGroups& groups) {
  GraphOrder out;
  out.group.resize(static_cast<std::size_t>(groups.count));
  std::iota(out.group.begin(), out.group.end(), 0);
  if (groups.neighbour.empty()) return out;

  // The ordering reads the graph only; its lower triangle counts.
  cholmod_sparse graph{};
  graph.nrow = graph.ncol = out.group.size();
  graph.nzmax = groups.neighbour.size();
  graph.p = const_cast<std::int64_t*>(groups.start.data());
  graph.i = const_cast<std::int64_t*>(groups.neighbour.data());
  graph.stype = -1;
  graph.itype = CHOLMOD_LONG;
  graph.xtype = CHOLMOD_PATTERN;
  graph.dtype = CHOLMOD_DOUBLE;
  graph.packed = 1;

  CholmodCommon common;
  // CHOLMOD tries first whether there is enough memory for METIS.
  common.c.metis_memory = 2;
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  auto* order = reinterpret_cast<SuiteSparse_long*>(out.group.data());
  const SerialLoops serial;
  const MetisRandom random;
  const bool dissected = cholmod_l_metis(&graph, nullptr, 0, 0, order, &common.c) && is_permutation(out.group);
  if (!dissected && !cholmod_l_amd(&graph, nullptr, 0, order, &common.c)) throw std::bad_alloc();
  out.peak_bytes = common.c.memory_usage;
  return out;
}

}  // namespace rollcon
