#include "mesh/strip_mesh.hpp"

#include <algorithm>
#include <initializer_list>

#include "support/index.hpp"

namespace rollcon::strips {
namespace {

/// Calls take(x, y) for every node in the order of the mesh: the lower end of a part, its rows, its upper end.
template <class Take>
void for_each_node(const StripFrame& strips, Take take) {
  const StripLayout& l = strips.layout;
  const double* g = strips.geometry.data();
  const std::size_t ends = at(l.nodes) + 2 * at(l.rows);  // observers beyond the widths come last
  for (int part = 0; part < l.parts; ++part) {
    const double middle = g[l.centre_of(part)], width = g[l.width_of(part)];
    const StripPoint &low = l.observers[ends + 2 * at(part)], &high = l.observers[ends + 2 * at(part) + 1];
    take(l.x(low, g), middle - width);
    for (int line = 0; line < l.rows_each; ++line) {
      const int row = part * l.rows_each + line;
      for (const double t : l.along)
        take(g[l.middle_of(row)] + t * g[l.half_of(row)], middle + l.across[at(line) + 1] * width);
    }
    take(l.x(high, g), middle + width);
  }
}

}  // namespace

SurfaceMesh strip_mesh(StripFrame& strips) {
  const StripLayout& l = strips.layout;
  const std::size_t columns = at(l.counts.along) + 1, lines = at(l.rows_each), each = lines * columns + 2;
  SurfaceMesh mesh;
  mesh.node.resize(at(l.parts) * each);
  mesh.offset.push_back(0);
  const auto add = [&](ElementType type, std::initializer_list<std::size_t> of) {
    mesh.type.push_back(type);
    mesh.tag.push_back(0);
    for (const std::size_t k : of) mesh.connectivity.push_back(static_cast<std::int32_t>(k));
    mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
  };
  strips.node.clear();
  for (std::size_t part = 0; part < at(l.parts); ++part) {
    const std::size_t first = part * each, last = first + each - 1;
    const auto number = [&](std::size_t line, std::size_t i) { return first + 1 + line * columns + i; };
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      add(ElementType::tri3, {first, number(0, i + 1), number(0, i)});
      for (std::size_t k = 0; k + 1 < lines; ++k)
        add(ElementType::quad4, {number(k, i), number(k, i + 1), number(k + 1, i + 1), number(k + 1, i)});
      add(ElementType::tri3, {number(lines - 1, i), number(lines - 1, i + 1), last});
    }
    for (std::size_t k = 0; k < lines; ++k)
      for (std::size_t i = 1; i + 1 < columns; ++i) strips.node.push_back(static_cast<std::int32_t>(number(k, i)));
  }
  return mesh;
}

void put_nodes(const StripFrame& strips, const Axes& axes, std::vector<Vec3>& node) {
  std::size_t k = 0;
  for_each_node(strips, [&](double x, double y) { node[k++] = axes.origin + x * axes.t1 + y * axes.t2; });
}

void put_frame(Frame& frame) {
  const StripLayout& l = frame.strips->layout;
  const double* g = frame.strips->geometry.data();
  std::size_t k = 0;
  for_each_node(*frame.strips, [&](double x, double y) {
    frame.x[k] = x;
    frame.y[k] = y;
    frame.z[k] = 0;
    ++k;
  });
  std::fill(frame.weight.begin(), frame.weight.end(), 0.0);
  frame.area = 0;
  for (std::size_t i = 0; i < at(l.nodes); ++i) {
    const double size = l.cell(l.node[i], g);
    const std::size_t node = at(frame.strips->node[i]);
    frame.weight[node] = l.unit_weight[i] * size;
    frame.cell_area[node] = l.unit_cell[i] * size;
    frame.area += frame.cell_area[node];
  }
}

}  // namespace rollcon::strips
