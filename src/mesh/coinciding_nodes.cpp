#include "mesh/coinciding_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/mesh_errors.hpp"

namespace rollcon {
namespace {

/// Nodes of different elements closer than this fraction of the distance to their own elements' nodes are one node
/// given twice.
constexpr double coincidence = 1e-6;

}  // namespace

/// Sweeps nodes along a direction in which no usual mesh has its layers, so that few of them share a strip.
void check_coinciding_nodes(std::span<const Vec3> node, std::span<const double> nearest, std::int32_t index_base,
                            const char* where) {
  struct Entry {
    double position, tolerance;
    std::size_t node;
  };
  const Vec3 direction{0.577, 0.626, 0.523};
  std::vector<Entry> order;
  order.reserve(node.size());
  for (std::size_t k = 0; k < node.size(); ++k) {
    if (std::isinf(nearest[k])) continue;
    double magnitude = 0;
    for (double c : node[k]) magnitude = std::max(magnitude, std::abs(c));
    order.push_back({dot(direction, node[k]), coincidence * nearest[k] + coordinate_rounding * magnitude, k});
  }
  std::sort(order.begin(), order.end(), [](const Entry& a, const Entry& b) { return a.position < b.position; });
  Tally together;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Entry& a = order[i];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Entry& b = order[j];
      // The direction is not longer than 1, so nodes within the tolerance are within the strip.
      if (b.position - a.position > a.tolerance) break;
      if (length(node[a.node] - node[b.node]) > std::min(a.tolerance, b.tolerance)) continue;
      together.add("nodes %lld and %lld", static_cast<long long>(std::min(a.node, b.node)) + index_base,
                   static_cast<long long>(std::max(a.node, b.node)) + index_base);
    }
  }
  together.fail_if_any("two nodes lie at the same place: give the elements one node there", where, index_base);
}

}  // namespace rollcon
