/// Carries the characteristic scheme's slip, which belongs half a step upstream of each node, back to the node.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "contact/convection/convection.hpp"
#include "mesh/topology.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::int32_t none = -1;

/// Fraction of a line's length at its upstream end that the contact may not reach: outlines are found to 0.3 %, strips
/// are 0.4 % longer, friction between unlike bodies moves the edge by up to 2.5 % (measured).
constexpr double doubtful = 0.03;

/// Finds the next node upstream of each on a line along the flow.
std::vector<std::int32_t> next_upstream(const Frame& frame) {
  constexpr double same_line = 1e-9;
  const std::vector<Side> sides = sorted_sides(split_elements(frame.mesh));
  std::vector<std::int32_t> next(at(frame.nodes()), none);
  for_each_edge(std::span<const Side>(sides), [&](const Side& side, std::size_t) {
    std::int32_t behind = side.from, before = side.to;
    if (frame.x[at(behind)] > frame.x[at(before)]) std::swap(behind, before);
    const double along = frame.x[at(before)] - frame.x[at(behind)];
    if (std::abs(frame.y[at(before)] - frame.y[at(behind)]) <= same_line * along) next[at(behind)] = before;
  });
  return next;
}

/// Drops those near the upstream ends of their lines.
void drop_doubtful(const Frame& frame, std::vector<std::int32_t>& next) {
  std::vector<std::size_t> order(next.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return frame.x[a] > frame.x[b]; });
  std::vector<std::size_t> first(next.size());  // first node of each node's line
  std::vector<double> last(next.size(), 0.0);   // x where the line of this first node ends
  for (const std::size_t k : order) {
    first[k] = next[k] == none ? k : first[at(next[k])];
    last[first[k]] = frame.x[k];
  }
  for (std::size_t k = 0; k < next.size(); ++k) {
    const double begin = frame.x[first[k]], end = last[first[k]];
    if (next[k] != none && begin - frame.x[at(next[k])] < doubtful * (begin - end)) next[k] = none;
  }
}

}  // namespace

void take_slip_at_nodes(const Frame& frame, Convection& convection) {
  std::vector<std::int32_t> next = next_upstream(frame);
  drop_doubtful(frame, next);
  const std::vector<double> between = convection.slip_x;  // where differences are centred
  const std::vector<double>& step = convection.ahead;
  const std::size_t n = step.size();
  SparseRows rows;
  rows.start.push_back(0);
  const auto add_difference = [&](std::size_t k, double value) {
    rows.column.push_back(static_cast<std::int32_t>(k));
    rows.value.push_back(value);
    rows.column.push_back(static_cast<std::int32_t>(n + k));
    rows.value.push_back(-value);
  };
  for (std::size_t k = 0; k < n; ++k) {
    const bool extrapolated = step[k] > 0 && next[k] != none && step[at(next[k])] > 0;
    if (extrapolated) {
      const std::size_t j = at(next[k]);
      const double part = step[k] / 2 / (between[j] - between[k]);
      add_difference(k, 1 + part);
      add_difference(j, -part * step[k] / step[j]);
      convection.slip_x[k] = frame.x[k];
    } else if (step[k] > 0) {
      add_difference(k, 1);
    }
    rows.start.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  convection.rows = std::move(rows);
}

}  // namespace rollcon
