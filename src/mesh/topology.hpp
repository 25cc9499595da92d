#pragma once
/// Tells who touches whom: linear cells (elements, or the parts of quadratic ones), their edges, and the neighbours of
/// nodes.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

/// Holds straight-edged triangles and quadrilaterals on the frame's nodes, counter-clockwise.
struct LinearCells {
  std::vector<std::int64_t> start{0};  ///< cells + 1, into node
  std::vector<std::int32_t> node;
  std::vector<std::int64_t> element;  ///< element that each cell is a part of

  std::int64_t size() const { return static_cast<std::int64_t>(element.size()); }
  std::span<const std::int32_t> operator[](std::int64_t c) const {
    const auto begin = static_cast<std::size_t>(start[static_cast<std::size_t>(c)]);
    const auto end = static_cast<std::size_t>(start[static_cast<std::size_t>(c) + 1]);
    return {node.data() + begin, end - begin};
  }
  void add(std::int64_t of_element, std::initializer_list<std::int32_t> nodes);
};

/// Splits elements: linear ones stay whole; tri6 becomes 4 triangles, quad9 8 around its centre, quad8 its 4 corner
/// triangles and the quadrilateral of its midside nodes (no diagonal is preferred there, so that symmetric frames have
/// symmetric operators).
LinearCells split_elements(const SurfaceMesh& mesh);

/// Is one side of a cell, running from `from` to `to` counter-clockwise round it.
struct Side {
  std::int32_t from, to;
  std::int64_t cell;
  std::int32_t low() const { return from < to ? from : to; }
  std::int32_t high() const { return from < to ? to : from; }
};

/// Returns all sides, sorted so that those on one edge stand together.
std::vector<Side> sorted_sides(const LinearCells& cells);

/// Calls f(first side, count) for each edge of sorted sides.
template <class F>
void for_each_edge(std::span<const Side> side, F f) {
  for (std::size_t i = 0; i < side.size();) {
    std::size_t j = i + 1;
    while (j < side.size() && side[j].low() == side[i].low() && side[j].high() == side[i].high()) ++j;
    f(side[i], j - i);
    i = j;
  }
}

/// Returns 1 for nodes that belong to an element, else 0.
std::vector<std::uint8_t> nodes_of_elements(const SurfaceMesh& mesh);
/// Returns 1 for nodes on an edge that belongs to one cell only, else 0.
std::vector<std::uint8_t> rim_nodes(std::int64_t nodes, std::span<const Side> side);

/// Holds lists of nodes by node, each ascending, without the node itself.
struct Neighbours {
  std::vector<std::int64_t> start;
  std::vector<std::int32_t> node;
  std::span<const std::int32_t> operator[](std::int64_t k) const {
    const auto begin = static_cast<std::size_t>(start[static_cast<std::size_t>(k)]);
    const auto end = static_cast<std::size_t>(start[static_cast<std::size_t>(k) + 1]);
    return {node.data() + begin, end - begin};
  }
};

/// Joins nodes by an edge of a cell; with `across`, also the opposite corners of quadrilaterals.
Neighbours neighbours(std::int64_t nodes, const LinearCells& cells, bool across);

}  // namespace rollcon
