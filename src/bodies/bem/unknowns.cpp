#include "bodies/bem/unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "mesh/box.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/index.hpp"

namespace rollcon::bem {
namespace {

/// Part of the way from a node to the middle of its element at which an extra equation is written.
constexpr double inward = 0.3;

/// Returns nodes in the order of their unknowns. Nodes that frames will ask for come last, as far as it can be told
/// before there is a frame: nodes on and around faces that may be in contact, the finer the later. Solutions are then
/// needed at their end only.
std::vector<std::int32_t> order_of_nodes(const BodyMesh& mesh) {
  const SurfaceMesh& surface = mesh.surface;
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> size(at(surface.nodes()), none);
  double smallest = none;
  for (const std::int32_t k : nodes_around(surface, contact_elements(mesh))) size[at(k)] = 0;
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const double diameter = element_diameter(surface, e);
    for (const std::int32_t k : surface.element(e)) {
      double& own = size[at(k)];
      if (own == none) continue;
      own = own == 0 ? diameter : std::min(own, diameter);
      smallest = std::min(smallest, own);
    }
  }
  // Sizes fall in classes, four for each doubling, so that nodes alike stay in the order given, whatever the last
  // digits of their elements' sizes. (Sizes are often equal, or halves and doubles.)
  const auto class_of = [&](std::int32_t k) {
    return size[at(k)] == none ? none : std::floor(4 * std::log2(size[at(k)] / smallest) + 0.37);
  };
  std::vector<double> key(size.size());
  std::vector<std::int32_t> order(size.size());
  std::iota(order.begin(), order.end(), 0);
  std::transform(order.begin(), order.end(), key.begin(), class_of);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return key[at(a)] > key[at(b)]; });
  return order;
}

/// Returns the position along a space-filling (Morton) curve through the box of all points.
std::vector<std::uint64_t> curve_positions(const std::vector<CollocationPoint>& point) {
  Box box;
  for (const CollocationPoint& p : point) box.add(p.x);
  const double extent = box.longest();
  constexpr int bits = 20;
  std::vector<std::uint64_t> position(point.size(), 0);
  for (std::size_t k = 0; k < point.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double part = extent > 0 ? (point[k].x[c] - box.low[c]) / extent : 0;
      const auto cell = static_cast<std::uint64_t>(part * ((1U << bits) - 1));
      for (unsigned b = 0; b < bits; ++b) position[k] |= ((cell >> b) & 1U) << (3 * b + static_cast<unsigned>(c));
    }
  return position;
}

/// Returns the place of a fan's extra equation: inside one of its elements, preferably one whose nodes are all held.
CollocationPoint inner_point(const SurfaceMesh& mesh, std::int64_t element, std::size_t local) {
  const ElementType type = mesh.type[at(element)];
  const ReferencePoint node = reference_nodes(type)[local];
  const bool triangle = corner_count(type) == 3;
  const double middle = triangle ? 1.0 / 3 : 0.0;
  CollocationPoint p;
  p.element = static_cast<std::int32_t>(element);
  p.xi = node.xi + inward * (middle - node.xi);
  p.eta = node.eta + inward * (middle - node.eta);
  p.x = evaluate_surface(mesh, element, p.xi, p.eta).x;
  return p;
}

/// Adds the midside nodes (1/2) and the centre (1/4) next to the corners: with them the corner's shape function becomes
/// the bilinear one.
void find_others(const SurfaceMesh& mesh, const TractionNodes& fans, std::vector<SpreadReaction>& spread) {
  if (spread.empty()) return;
  std::map<std::int32_t, std::vector<std::size_t>> spread_of_fan;
  for (std::size_t s = 0; s < spread.size(); ++s) spread_of_fan[spread[s].fan].push_back(s);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[at(e)];
    if (!is_quadratic(type)) continue;
    const int corners = corner_count(type);
    const std::int32_t* fan = fans.of.data() + mesh.offset[at(e)];
    for (int i = 0; i < corners; ++i) {
      const auto found = spread_of_fan.find(fan[i]);
      if (found == spread_of_fan.end()) continue;
      for (const std::size_t s : found->second) {
        spread[s].others[fan[corners + i]] = 0.5;
        spread[s].others[fan[corners + (i + corners - 1) % corners]] = 0.5;
        if (type == ElementType::quad9) spread[s].others[fan[8]] = 0.25;
      }
    }
  }
}

/// Puts neighbours in space together, with a row for each component wanted.
void sort_points(Unknowns& u, const std::vector<std::uint8_t>& wanted) {
  const std::vector<std::uint64_t> position = curve_positions(u.point);
  std::vector<std::size_t> order(u.point.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return position[a] < position[b]; });
  std::vector<CollocationPoint> sorted;
  std::vector<std::int32_t> fan;
  sorted.reserve(order.size());
  u.row.assign(3 * order.size(), -1);
  std::int32_t row = 0;
  // Rows of a pack run over its points first: the integrals come in that order.
  for (std::size_t first = 0; first < order.size(); first += lanes) {
    const std::size_t last = std::min(order.size(), first + lanes);
    for (std::size_t k = first; k < last; ++k) {
      sorted.push_back(u.point[order[k]]);
      fan.push_back(u.fan[order[k]]);
    }
    for (unsigned c = 0; c < 3; ++c)
      for (std::size_t k = first; k < last; ++k)
        if (wanted[order[k]] & (1U << c)) u.row[3 * k + c] = row++;
  }
  u.point = std::move(sorted);
  u.fan = std::move(fan);
}

}  // namespace

std::vector<std::int32_t> Unknowns::column_of_rows(const TractionNodes& fans) const {
  std::vector<std::int32_t> of(at(columns), -1);
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] < 0) continue;
    const std::size_t p = k / 3, c = k % 3;
    std::int32_t& column = of[at(row[k])];
    if (fan[p] >= 0) {
      column = traction[3 * at(fan[p]) + c];
      continue;
    }
    column = displacement[3 * at(point[p].node) + c];
    for (std::int64_t f = fans.start[at(point[p].node)]; column < 0; ++f) column = traction[3 * at(f) + c];
  }
  return of;
}

Unknowns choose_unknowns(const BodyMesh& mesh, const TractionNodes& fans) {
  const SurfaceMesh& surface = mesh.surface;
  const std::vector<std::uint8_t> held_element = held_elements(mesh);
  std::vector<std::uint8_t> held_fan(at(fans.size()), 0);
  struct Entry {
    std::int64_t element = -1;
    std::size_t local = 0;
  };
  std::vector<Entry> of_fan(at(fans.size()));
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const auto nodes = surface.element(e);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const auto f = at(fans.of[at(surface.offset[at(e)]) + a]);
      held_fan[f] |= held_element[at(e)];
      Entry& entry = of_fan[f];
      if (entry.element < 0 || held_element[at(e)] > held_element[at(entry.element)]) entry = {e, a};
    }
  }

  Unknowns u;
  u.displacement.assign(3 * at(surface.nodes()), -1);
  u.traction.assign(3 * at(fans.size()), -1);
  std::vector<std::uint8_t> extra(at(fans.size()), 0);  // components with an equation of the fan's
  std::vector<std::uint8_t> at_node(at(surface.nodes()), 0);
  std::int32_t column = 0;
  for (const std::int32_t i : order_of_nodes(mesh))
    for (unsigned c = 0; c < 3; ++c) {
      const auto bit = static_cast<std::uint8_t>(1U << c);
      if (!(mesh.held[at(i)] & bit)) {
        u.displacement[3 * at(i) + c] = column++;
        at_node[at(i)] |= bit;
        continue;
      }
      const std::int64_t first = fans.start[at(i)], last = fans.start[at(i) + 1];
      const auto unknown = std::count_if(held_fan.begin() + first, held_fan.begin() + last,
                                         [&](std::uint8_t held) { return (held & bit) != 0; });
      for (std::int64_t f = first; f < last; ++f) {
        // A node held alone, without a face: its reaction spreads over its first fan.
        const bool takes = unknown > 0 ? (held_fan[at(f)] & bit) != 0 : f == first;
        if (!takes) continue;
        u.traction[3 * at(f) + c] = column++;
        if (unknown == 0) u.spread.push_back({static_cast<std::int32_t>(f), static_cast<int>(c), {}});
        if (unknown > 1) extra[at(f)] |= bit;
      }
      if (unknown <= 1) at_node[at(i)] |= bit;
    }
  u.columns = column;
  find_others(surface, fans, u.spread);

  std::vector<std::uint8_t> wanted;
  for (std::int64_t i = 0; i < surface.nodes(); ++i) {
    if (!at_node[at(i)]) continue;
    CollocationPoint p;
    p.x = surface.node[at(i)];
    p.node = static_cast<std::int32_t>(i);
    u.point.push_back(p);
    u.fan.push_back(-1);
    wanted.push_back(at_node[at(i)]);
  }
  for (std::size_t f = 0; f < extra.size(); ++f) {
    if (!extra[f]) continue;
    u.point.push_back(inner_point(surface, of_fan[f].element, of_fan[f].local));
    u.fan.push_back(static_cast<std::int32_t>(f));
    wanted.push_back(extra[f]);
  }
  sort_points(u, wanted);
  return u;
}

}  // namespace rollcon::bem
