#include "procedures/held_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr double rounding = 1e-12;

// How much each displacement component at the nodes follows anything at all, over the most that a
// body's own unknowns or a half-space make of one.
std::vector<double> mobility(const MonolithicBodies& bodies) {
  const auto places = static_cast<std::size_t>(3 * bodies.nodes());
  std::vector<double> sum(places, 0.0), part(places);
  const auto add_part = [&] {
    const double most = *std::max_element(part.begin(), part.end());
    for (std::size_t i = 0; i < places && most > 0; ++i) sum[i] += part[i] / most;
  };
  for (const MonolithicBodies::Body& body : bodies.bodies()) {
    for (std::size_t i = 0; i < places; ++i) {
      part[i] = 0;
      for (auto k = static_cast<std::size_t>(body.place.start[i]);
           k < static_cast<std::size_t>(body.place.start[i + 1]); ++k)
        part[i] = std::max(part[i], std::abs(body.place.value[k]));
    }
    add_part();
  }
  const double* direct = bodies.direct();
  if (!direct) return sum;
  std::fill(part.begin(), part.end(), 0.0);
  for (std::size_t j = 0; j < places; ++j)
    for (std::size_t i = 0; i < places; ++i)
      part[i] =
          std::max(part[i], std::abs(direct[i + j * static_cast<std::size_t>(bodies.places())]));
  add_part();
  return sum;
}

}  // namespace

void refuse_held_nodes(const MonolithicBodies& bodies, const Frame& frame) {
  const std::vector<double> moves = mobility(bodies);
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
