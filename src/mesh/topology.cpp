#include "mesh/topology.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace rollcon {

void LinearCells::add(std::int64_t of_element, std::initializer_list<std::int32_t> nodes) {
  node.insert(node.end(), nodes);
  start.push_back(static_cast<std::int64_t>(node.size()));
  element.push_back(of_element);
}

LinearCells split_elements(const SurfaceMesh& mesh) {
  LinearCells cells;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto n = mesh.element(e);
    switch (mesh.type[static_cast<std::size_t>(e)]) {
      case ElementType::tri3:
        cells.add(e, {n[0], n[1], n[2]});
        break;
      case ElementType::quad4:
        cells.add(e, {n[0], n[1], n[2], n[3]});
        break;
      case ElementType::tri6:
        cells.add(e, {n[0], n[3], n[5]});
        cells.add(e, {n[3], n[1], n[4]});
        cells.add(e, {n[5], n[4], n[2]});
        cells.add(e, {n[3], n[4], n[5]});
        break;
      case ElementType::quad8:
        for (std::size_t i = 0; i < 4; ++i) cells.add(e, {n[i], n[4 + i], n[4 + (i + 3) % 4]});
        cells.add(e, {n[4], n[5], n[6], n[7]});
        break;
      case ElementType::quad9:
        for (std::size_t i = 0; i < 4; ++i) {
          cells.add(e, {n[i], n[4 + i], n[8]});
          cells.add(e, {n[4 + i], n[(i + 1) % 4], n[8]});
        }
        break;
    }
  }
  return cells;
}

// Sorts by the lower node in one pass, so that only the few sides of one node are left to be sorted.
std::vector<Side> sorted_sides(const LinearCells& cells) {
  const auto low_end = [](std::int32_t a, std::int32_t b) { return static_cast<std::size_t>(std::min(a, b)); };
  std::size_t nodes = 0;
  for (const std::int32_t k : cells.node) nodes = std::max(nodes, static_cast<std::size_t>(k) + 1);
  std::vector<std::size_t> place(nodes + 1, 0);
  const auto each = [&](auto f) {
    for (std::int64_t c = 0; c < cells.size(); ++c) {
      const auto n = cells[c];
      for (std::size_t i = 0; i < n.size(); ++i) f(n[i], n[(i + 1) % n.size()], c);
    }
  };
  each([&](std::int32_t a, std::int32_t b, std::int64_t) { ++place[low_end(a, b) + 1]; });
  for (std::size_t k = 0; k < nodes; ++k) place[k + 1] += place[k];
  std::vector<Side> side(cells.node.size());
  each([&](std::int32_t a, std::int32_t b, std::int64_t c) { side[place[low_end(a, b)]++] = {a, b, c}; });
  for (std::size_t k = 0, begin = 0; k < nodes; begin = place[k++])  // place[k] is now the end of k's sides
    std::sort(side.begin() + static_cast<std::ptrdiff_t>(begin), side.begin() + static_cast<std::ptrdiff_t>(place[k]),
              [](const Side& a, const Side& b) { return std::tuple(a.high(), a.cell) < std::tuple(b.high(), b.cell); });
  return side;
}

std::vector<std::uint8_t> nodes_of_elements(const SurfaceMesh& mesh) {
  std::vector<std::uint8_t> belongs(static_cast<std::size_t>(mesh.nodes()), 0);
  for (const std::int32_t k : mesh.connectivity) belongs[static_cast<std::size_t>(k)] = 1;
  return belongs;
}

std::vector<std::uint8_t> rim_nodes(std::int64_t nodes, std::span<const Side> side) {
  std::vector<std::uint8_t> rim(static_cast<std::size_t>(nodes), 0);
  for_each_edge(side, [&](const Side& s, std::size_t count) {
    if (count != 1) return;
    rim[static_cast<std::size_t>(s.from)] = 1;
    rim[static_cast<std::size_t>(s.to)] = 1;
  });
  return rim;
}

Neighbours neighbours(std::int64_t nodes, const LinearCells& cells, bool across) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pair;
  pair.reserve(3 * cells.node.size());
  auto join = [&](std::int32_t a, std::int32_t b) {
    pair.emplace_back(a, b);
    pair.emplace_back(b, a);
  };
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    for (std::size_t i = 0; i < n.size(); ++i) join(n[i], n[(i + 1) % n.size()]);
    if (across && n.size() == 4) {
      join(n[0], n[2]);
      join(n[1], n[3]);
    }
  }
  std::sort(pair.begin(), pair.end());
  pair.erase(std::unique(pair.begin(), pair.end()), pair.end());
  Neighbours result;
  result.start.assign(static_cast<std::size_t>(nodes) + 1, 0);
  result.node.reserve(pair.size());
  for (const auto& [a, b] : pair) {
    ++result.start[static_cast<std::size_t>(a) + 1];
    result.node.push_back(b);
  }
  for (std::size_t k = 1; k < result.start.size(); ++k) result.start[k] += result.start[k - 1];
  return result;
}

}  // namespace rollcon
