#include "mesh/overlap.hpp"

#include <algorithm>
#include <vector>

#include "mesh/box_tree.hpp"

namespace rollcon {
namespace {

Vec3 in_plane(double x, double y) {
  return {x, y, 0};
}

}  // namespace

ElementOverlap find_overlap(const LinearCells& cells, std::span<const double> x, std::span<const double> y,
                            double tolerance) {
  BoxTree tree;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    Box box;
    for (const std::int32_t k : cells[c])
      box.add(in_plane(x[static_cast<std::size_t>(k)], y[static_cast<std::size_t>(k)]));
    tree.add(box);
  }
  tree.build();
  auto inside = [&](std::int64_t cell, double px, double py) {
    const auto n = cells[cell];
    for (std::size_t i = 0; i < n.size(); ++i) {
      const auto a = static_cast<std::size_t>(n[i]);
      const auto b = static_cast<std::size_t>(n[(i + 1) % n.size()]);
      const double ex = x[b] - x[a], ey = y[b] - y[a];
      // Twice the area over the edge squared is the depth over the edge's length.
      const double area = ex * (py - y[a]) - ey * (px - x[a]);
      if (area <= tolerance * (ex * ex + ey * ey)) return false;
    }
    return true;
  };
  const auto cover = [&](double px, double py, auto own) {
    std::int64_t other = -1;
    tree.walk([&](const Box& box) { return box.holds(in_plane(px, py)) ? 0 : BoxTree::missed; },
              [&] { return other < 0 ? 0 : -1; },
              [&](std::int64_t d) {
                if (!own(d) && inside(d, px, py)) other = d;
              });
    return other;
  };
  constexpr std::int64_t unknown = -2;
  std::vector<std::int64_t> over(x.size(), unknown);  // another cell that covers the vertex; -1: none
  ElementOverlap result;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto own = cells[c];
    std::int64_t other = -1;
    double cx = 0, cy = 0;
    for (const std::int32_t k : own) {
      const auto v = static_cast<std::size_t>(k);
      cx += x[v] / static_cast<double>(own.size());
      cy += y[v] / static_cast<double>(own.size());
      if (over[v] == unknown)
        over[v] = cover(x[v], y[v], [&](std::int64_t d) {
          const auto n = cells[d];
          return std::find(n.begin(), n.end(), k) != n.end();
        });
      if (other < 0) other = over[v];
    }
    if (other < 0) other = cover(cx, cy, [&](std::int64_t d) { return d == c; });
    if (other < 0) continue;
    if (result.count++ == 0) result.first = c, result.second = other;
  }
  return result;
}

}  // namespace rollcon
