#include "procedures/held_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double rounding = 1e-12;

// Measures how much each displacement component at the nodes follows anything at all, over the most that a body's own
// unknowns or a half-space make of one.
std::vector<double> mobility(const ExpandedCompliance& expanded, std::size_t places) {
  std::vector<double> sum(places, 0.0), part(places);
  const auto add_part = [&](auto row) {
    for (std::size_t i = 0; i < places; ++i) {
      part[i] = 0;
      for (const double v : row(i)) part[i] = std::max(part[i], std::abs(v));
    }
    const double most = *std::max_element(part.begin(), part.end());
    for (std::size_t i = 0; i < places && most > 0; ++i) sum[i] += part[i] / most;
  };
  for (const ExpandedBody& body : expanded.body)
    add_part([&](std::size_t i) {
      const SparseMatrix& d = body.displacement;
      return std::span(d.value).subspan(at(d.start[i]), at(d.start[i + 1] - d.start[i]));
    });
  if (!expanded.direct.empty())
    add_part([&](std::size_t i) { return std::span(expanded.direct.row(static_cast<std::int64_t>(i)), places); });
  return sum;
}

}  // namespace

void refuse_held_nodes(const ExpandedCompliance& expanded, const Frame& frame) {
  const std::vector<double> moves = mobility(expanded, 3 * frame.used.size());
  for (std::size_t k = 0; k < frame.used.size(); ++k) {
    if (!frame.used[k]) continue;
    const auto node = static_cast<long long>(k) + frame.mesh.index_base;
    if (!(moves[3 * k + 2] > rounding))
      fail(Status::err_state,
           "node %lld of the frame (counting from %d) does not move along its normal under "
           "pressure: a support holds the body there; end the frame before it or hold the body "
           "elsewhere",
           node, frame.mesh.index_base);
    if (!(std::min(moves[3 * k], moves[3 * k + 1]) > rounding))
      fail(Status::err_unsupported,
           "node %lld of the frame (counting from %d) is held along a tangent (a plane of "
           "symmetry): only system = condensed solves such scenes",
           node, frame.mesh.index_base);
  }
}

}  // namespace rollcon
