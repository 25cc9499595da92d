#include "mesh/frame.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/dual_cells.hpp"
#include "mesh/frame_check.hpp"
#include "mesh/plane_quadrature.hpp"
#include "mesh/topology.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

void check_axes(const Axes& axes) {
  const Vec3 &a = axes.t1, &b = axes.t2, &n = axes.n;
  constexpr double tolerance = 1e-10;
  const bool orthonormal = std::abs(dot(a, a) - 1) < tolerance && std::abs(dot(b, b) - 1) < tolerance &&
                           std::abs(dot(a, b)) < tolerance && std::abs(dot(cross(a, b), n) - 1) < tolerance &&
                           std::abs(dot(n, n) - 1) < tolerance;
  if (!orthonormal) fail(Status::err_argument, "the axes (t1, t2, n) are not orthonormal and right-handed");
}

/// Refuses coordinates whose squares and products would leave the range of double precision.
void check_range(const SurfaceMesh& mesh, const Axes& axes) {
  double extent = 0;
  for (std::size_t k = 0; k < mesh.node.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      if (!std::isfinite(mesh.node[k][i]))
        fail(Status::err_nonfinite, "coordinate %c of node %lld (counting from %d) of the contact frame is not finite",
             "xyz"[i], static_cast<long long>(k) + mesh.index_base, mesh.index_base);
      extent = std::max(extent, std::abs(mesh.node[k][i] - axes.origin[i]));
    }
  constexpr double smallest = 1e-60, largest = 1e60;
  if (extent < smallest || extent > largest)
    fail(Status::err_mesh, "the contact frame extends %g from the origin of its axes; allowed: %g to %g", extent,
         smallest, largest);
}

void integrate_weights(Frame& frame) {
  constexpr int degree = 5;  // degree of N_i times the Jacobian of the projection, for any element
  frame.weight.assign(static_cast<std::size_t>(frame.nodes()), 0);
  frame.area = 0;
  integrate_projection(frame, degree, [&](auto nodes, const Shape& shape, double, double, double area) {
    frame.area += area;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      frame.weight[static_cast<std::size_t>(nodes[i])] += area * shape.value[i];
  });
}

}  // namespace

Frame build_frame(SurfaceMesh mesh, const Axes& axes) {
  check_axes(axes);
  check_connectivity(mesh);
  check_range(mesh, axes);
  Frame frame;
  frame.mesh = std::move(mesh);
  frame.axes = axes;
  const auto n = static_cast<std::size_t>(frame.mesh.nodes());
  frame.x.resize(n);
  frame.y.resize(n);
  frame.z.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3& p = frame.mesh.node[k];
    const Vec3 r = {p[0] - axes.origin[0], p[1] - axes.origin[1], p[2] - axes.origin[2]};
    frame.x[k] = dot(r, axes.t1);
    frame.y[k] = dot(r, axes.t2);
    frame.z[k] = dot(r, axes.n);
  }
  check_elements(frame.mesh, frame.x, frame.y, frame.z);
  const LinearCells cells = split_elements(frame.mesh);
  const std::vector<Side> side = sorted_sides(cells);
  check_cells(frame.mesh, cells, side, frame.x, frame.y);
  frame.rim = rim_nodes(frame.mesh.nodes(), side);
  frame.used = nodes_of_elements(frame.mesh);
  frame.cell_area = build_dual_cells(cells, frame.x, frame.y).area;
  integrate_weights(frame);
  return frame;
}

}  // namespace rollcon
