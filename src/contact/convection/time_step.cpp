#include <cstdint>
#include <utility>

#include "contact/convection/convection.hpp"

namespace rollcon {

// Makes rows that take every node's own displacement.
Convection make_time_step(const Frame& frame, double /*step*/, bool /*ends_at_edge*/) {
  const std::size_t nodes = frame.x.size();
  SparseRows rows;
  rows.value.assign(nodes, 1.0);
  for (std::size_t k = 0; k < nodes; ++k) rows.column.push_back(static_cast<std::int32_t>(k));
  for (std::size_t k = 0; k <= nodes; ++k) rows.start.push_back(static_cast<std::int64_t>(k));
  return at_nodes(frame, std::move(rows));
}

}  // namespace rollcon
