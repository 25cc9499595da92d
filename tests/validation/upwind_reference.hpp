#pragma once
/// The convective derivative of equations (41)-(42) of the source paper once more, written for these tests alone:
/// inflow through the faces of median-dual cells of linear elements.

#include <array>
#include <cmath>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon::validation {

/// v . grad w at every node for v = (vx, vy); w: one pair per node, mesh in the plane z = 0.
inline std::vector<std::array<double, 2>> inflow_derivative(const SurfaceMesh& mesh, double vx, double vy,
                                                            const std::vector<std::array<double, 2>>& w) {
  std::vector<std::array<double, 2>> sum(mesh.node.size());
  std::vector<double> cell(mesh.node.size());
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto node = mesh.element(e);
    const std::size_t n = node.size();
    auto at = [&](std::size_t i) { return mesh.node[static_cast<std::size_t>(node[i % n])]; };
    double gx = 0, gy = 0;
    for (std::size_t i = 0; i < n; ++i) {
      gx += at(i)[0] / static_cast<double>(n);
      gy += at(i)[1] / static_cast<double>(n);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 a = at(i), b = at(i + 1);
      const auto from = static_cast<std::size_t>(node[i]);
      const auto to = static_cast<std::size_t>(node[(i + 1) % n]);
      const double mx = 0.5 * (a[0] + b[0]), my = 0.5 * (a[1] + b[1]);
      // The triangle (a, b, centroid) is shared equally by the cells of a and b.
      const double area = 0.5 * ((b[0] - a[0]) * (gy - a[1]) - (b[1] - a[1]) * (gx - a[0]));
      cell[from] += 0.5 * area;
      cell[to] += 0.5 * area;
      const double flux = vx * (gy - my) - vy * (gx - mx);  // from -> to
      const std::size_t receiver = flux < 0 ? from : to, giver = flux < 0 ? to : from;
      for (std::size_t c = 0; c < 2; ++c) sum[receiver][c] -= std::abs(flux) * (w[giver][c] - w[receiver][c]);
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k)
    for (double& value : sum[k])
      if (cell[k] > 0) value /= cell[k];
  return sum;
}

}  // namespace rollcon::validation
