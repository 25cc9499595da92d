#include "contact/estimate/few_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "contact/solution.hpp"

namespace rollcon {
namespace {

// Bounds measured over grids and triangles that see Hertzian contacts of ratios 0.1 to 10 through 1 to 300 nodes:
// without a node inside, forces are off by up to 135 %, pressures by up to 200 %; from one on the normal force is
// within 6 %, from five on nine of ten friction forces are within 17 %.
constexpr std::int64_t least_inside = 1, least_inside_with_friction = 5;

std::int64_t least(const Solution& s) {
  return s.frictionless ? least_inside : least_inside_with_friction;
}

constexpr std::uint8_t touching = 1, edge = 2;

// Marks all nodes of an element where some nodes touch and some are open: they are at the edge.
template <std::size_t count>
void mark_edge(std::uint8_t* state, const std::int32_t* node) {
  int all = touching, any = 0;
  for (std::size_t i = 0; i < count; ++i) {
    all &= state[node[i]];
    any |= state[node[i]];
  }
  if (all == (any & touching)) return;
  for (std::size_t i = 0; i < count; ++i) state[node[i]] |= edge;
}

}  // namespace

std::int64_t nodes_inside(const SurfaceMesh& mesh, const std::vector<double>& normal, std::vector<std::uint8_t>& node,
                          const std::uint8_t* inner) {
  node.resize(normal.size());
  for (std::size_t k = 0; k < normal.size(); ++k) node[k] = normal[k] < 0 || (inner && !inner[k]) ? touching : 0;
  // Locals hold what the loop reads, as bytes may alias anything.
  std::uint8_t* const state = node.data();
  const ElementType* const type = mesh.type.data();
  const std::int32_t* n = mesh.connectivity.data();
  for (std::size_t e = 0, elements = mesh.type.size(); e < elements; ++e) {
    switch (type[e]) {
      case ElementType::tri3:
        mark_edge<3>(state, n);
        break;
      case ElementType::quad4:
        mark_edge<4>(state, n);
        break;
      case ElementType::tri6:
        mark_edge<6>(state, n);
        break;
      case ElementType::quad8:
        mark_edge<8>(state, n);
        break;
      case ElementType::quad9:
        mark_edge<9>(state, n);
    }
    n += node_count(type[e]);
  }
  std::int64_t inside = 0;
  for (std::size_t k = 0; k < node.size(); ++k) inside += normal[k] < 0 && state[k] == touching;
  return inside;
}

std::int64_t nodes_inside(const Solution& s) {
  // The edge beyond the last nodes that may touch is known.
  const Frame& frame = s.prepared->frame;
  return nodes_inside(frame.mesh, s.iterate.lambda[2], s.marks, s.prepared->ends_at_edge ? frame.used.data() : nullptr);
}

bool too_few_nodes(const Solution& s) {
  return nodes_inside(s) < least(s);
}

namespace {

// Tells of few nodes, or corners of quad8, whose weights are negative, that carry more than friction can.
Line beyond_friction(const Solution& s) {
  Vec3 force{}, moment{};
  sum_tractions(s.prepared->problem, s.iterate.lambda, force, moment);
  const std::vector<double>& mu = s.prepared->problem.mu;
  const double carried = mu.empty() ? 0 : *std::max_element(mu.begin(), mu.end()) * std::abs(force[2]);
  const double tangential = std::hypot(force[0], force[1]);
  constexpr double rounding = 1e-6;
  if (s.frictionless || tangential <= (1 + rounding) * carried) return {};
  return line_of("; the tangential force is %.3g times what friction carries under the normal force",
                 tangential / carried);
}

}  // namespace

Line describe_few_nodes(const Solution& s) {
  const std::vector<double>& normal = s.iterate.lambda[2];
  return line_of(
      "too few nodes in contact to trust: %lld touch, %lld of them with all their neighbours "
      "(at least %lld should): forces, pressures and the approach (%.6g) are those of the "
      "frame and may be off by half and more%s; take a finer frame where the bodies touch",
      static_cast<long long>(std::count_if(normal.begin(), normal.end(), [](double l) { return l < 0; })),
      static_cast<long long>(nodes_inside(s)), static_cast<long long>(least(s)),
      s.given.approach_of(s.iterate.motion, s.prepared->problem.datum), beyond_friction(s).c_str());
}

}  // namespace rollcon
