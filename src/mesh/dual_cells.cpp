#include "mesh/dual_cells.hpp"

namespace rollcon {

DualCells build_dual_cells(const LinearCells& cells, std::span<const double> x, std::span<const double> y) {
  DualCells dual;
  dual.area.assign(x.size(), 0);
  dual.face.reserve(cells.node.size());
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    const double count = static_cast<double>(n.size());
    // Coordinates relative to the first node lose no digits in frames far from their origin.
    const double x0 = x[static_cast<std::size_t>(n[0])], y0 = y[static_cast<std::size_t>(n[0])];
    double cx = 0, cy = 0;
    for (std::int32_t k : n) {
      cx += (x[static_cast<std::size_t>(k)] - x0) / count;
      cy += (y[static_cast<std::size_t>(k)] - y0) / count;
    }
    for (std::size_t i = 0; i < n.size(); ++i) {
      const auto a = static_cast<std::size_t>(n[i]);
      const auto b = static_cast<std::size_t>(n[(i + 1) % n.size()]);
      const double ax = x[a] - x0, ay = y[a] - y0, bx = x[b] - x0, by = y[b] - y0;
      const double dx = cx - 0.5 * (ax + bx), dy = cy - 0.5 * (ay + by);
      dual.face.push_back({n[i], n[(i + 1) % n.size()], dy, -dx});
      // The edge's midpoint halves triangle (a, b, centroid) between the two nodes.
      const double half = 0.25 * ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay));
      dual.area[a] += half;
      dual.area[b] += half;
    }
  }
  return dual;
}

}  // namespace rollcon
