#include "mesh/frame.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mesh/dual_cells.hpp"
#include "mesh/frame_check.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "mesh/topology.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

void check_axes(const Axes& axes) {
  const Vec3 &a = axes.t1, &b = axes.t2, &n = axes.n;
  const Vec3 cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
  constexpr double tolerance = 1e-10;
  const bool orthonormal = std::abs(dot(a, a) - 1) < tolerance &&
                           std::abs(dot(b, b) - 1) < tolerance && std::abs(dot(a, b)) < tolerance &&
                           std::abs(dot(cross, n) - 1) < tolerance &&
                           std::abs(dot(n, n) - 1) < tolerance;
  if (!orthonormal)
    fail(Status::err_argument, "the axes (t1, t2, n) are not orthonormal and right-handed");
}

/// Squares and products of lengths must stay in the range of double precision.
void check_range(const SurfaceMesh& mesh, const Axes& axes) {
  double extent = 0;
  for (std::size_t k = 0; k < mesh.node.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      if (!std::isfinite(mesh.node[k][i]))
        fail(Status::err_nonfinite,
             "coordinate %c of node %lld (counting from %d) of the contact frame is not finite",
             "xyz"[i], static_cast<long long>(k) + mesh.index_base, mesh.index_base);
      extent = std::max(extent, std::abs(mesh.node[k][i] - axes.origin[i]));
    }
  constexpr double smallest = 1e-60, largest = 1e60;
  if (extent < smallest || extent > largest)
    fail(Status::err_mesh,
         "the contact frame extends %g from the origin of its axes; allowed: %g to %g", extent,
         smallest, largest);
}

/// Rule exact for N_i times the Jacobian of the projection.
PlaneRule weight_rule(ElementType type) {
  if (corner_count(type) == 3) return triangle_rule(is_quadratic(type) ? 4 : 1);
  return square_rule(is_quadratic(type) ? 5 : 2);
}

struct Rule {
  std::vector<Shape> shape;
  std::vector<double> w;
};

Rule tabulate(ElementType type) {
  const PlaneRule plane = weight_rule(type);
  Rule rule{std::vector<Shape>(plane.size()), plane.w};
  for (std::size_t q = 0; q < plane.size(); ++q)
    evaluate_shape(type, plane.xi[q], plane.eta[q], rule.shape[q]);
  return rule;
}

void integrate_weights(Frame& frame) {
  const SurfaceMesh& mesh = frame.mesh;
  std::map<ElementType, Rule> rules;
  frame.weight.assign(static_cast<std::size_t>(mesh.nodes()), 0);
  frame.area = 0;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto nodes = mesh.element(e);
    Rule& rule = rules[type];
    if (rule.w.empty()) rule = tabulate(type);
    const double x0 = frame.x[static_cast<std::size_t>(nodes[0])];
    const double y0 = frame.y[static_cast<std::size_t>(nodes[0])];
    for (std::size_t q = 0; q < rule.w.size(); ++q) {
      const Shape& s = rule.shape[q];
      double x_xi = 0, x_eta = 0, y_xi = 0, y_eta = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto k = static_cast<std::size_t>(nodes[i]);
        x_xi += s.d_xi[i] * (frame.x[k] - x0);
        x_eta += s.d_eta[i] * (frame.x[k] - x0);
        y_xi += s.d_xi[i] * (frame.y[k] - y0);
        y_eta += s.d_eta[i] * (frame.y[k] - y0);
      }
      const double w = rule.w[q] * (x_xi * y_eta - x_eta * y_xi);
      frame.area += w;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        frame.weight[static_cast<std::size_t>(nodes[i])] += w * s.value[i];
    }
  }
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
  frame.used.assign(n, 0);
  for (std::int32_t k : frame.mesh.connectivity) frame.used[static_cast<std::size_t>(k)] = 1;
  frame.cell_area = build_dual_cells(cells, frame.x, frame.y).area;
  integrate_weights(frame);
  return frame;
}

}  // namespace rollcon
