/// Computes local triads, weights and areas of curved frames.

#include <algorithm>
#include <cmath>

#include "mesh/dual_cells.hpp"
#include "mesh/frame.hpp"
#include "mesh/surface_quadrature.hpp"
#include "mesh/topology.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// The slope of the surface against the tangent plane is at most 60 degrees, also for the frame's elements.
constexpr double smallest_cosine = 0.5;
/// Normals closer than this to the axes' make no difference to any result.
constexpr double flat_enough = 1e-12;

/// Returns the area on the surface of each node's median-dual cell: facets of the linear cells, scaled so that those of
/// an element add up to its area.
std::vector<double> cell_areas(const Frame& frame, const std::vector<double>& element_area) {
  const LinearCells cells = split_elements(frame.mesh);
  const auto point = [&](std::int32_t k) { return frame.mesh.node[static_cast<std::size_t>(k)]; };
  std::vector<double> facet(cells.node.size()), sum(element_area.size(), 0);
  std::size_t f = 0;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    // Coordinates relative to the first node lose no digits in frames far from their origin.
    const Vec3 origin = point(n[0]);
    Vec3 centre{};
    for (const std::int32_t k : n) centre = centre + (1 / static_cast<double>(n.size())) * (point(k) - origin);
    for (std::size_t i = 0; i < n.size(); ++i, ++f) {
      const Vec3 a = point(n[i]) - origin, b = point(n[(i + 1) % n.size()]) - origin;
      facet[f] = 0.5 * length(cross(b - a, centre - a));
      sum[static_cast<std::size_t>(cells.element[static_cast<std::size_t>(c)])] += facet[f];
    }
  }
  std::vector<double> area(static_cast<std::size_t>(frame.nodes()), 0);
  f = 0;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    const auto e = static_cast<std::size_t>(cells.element[static_cast<std::size_t>(c)]);
    const double scale = element_area[e] / sum[e];
    for (std::size_t i = 0; i < n.size(); ++i, ++f) {
      // The edge's midpoint halves the facet between the two nodes.
      area[static_cast<std::size_t>(n[i])] += 0.5 * scale * facet[f];
      area[static_cast<std::size_t>(n[(i + 1) % n.size()])] += 0.5 * scale * facet[f];
    }
  }
  return area;
}

}  // namespace

Triad local_triad(const Axes& axes, const Vec3& normal) {
  Vec3 t1 = axes.t1 - dot(axes.t1, normal) * normal;
  t1 = (1 / length(t1)) * t1;
  return {t1, cross(normal, t1), normal};
}

void curve_frame(Frame& frame, std::span<const Vec3> normal) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  std::vector<Vec3> unit(n);
  bool flat = true;
  long long steep = 0, first = -1;
  for (std::size_t k = 0; k < n; ++k) {
    unit[k] = (1 / length(normal[k])) * normal[k];
    flat = flat && length(unit[k] - frame.axes.n) <= flat_enough;
    if (dot(unit[k], frame.axes.n) >= smallest_cosine) continue;
    if (steep++ == 0) first = static_cast<long long>(k);
  }
  if (steep > 0)
    fail(Status::err_mesh,
         "the surface is steeper than 60 degrees against the tangent plane of the axes "
         "(rollcon_contact_set_axes sets it) at %lld node(s) of the frame; first: node %lld "
         "(counting "
         "from %d)",
         steep, first + frame.mesh.index_base, frame.mesh.index_base);
  if (flat) return;
  frame.t1.resize(n);
  frame.t2.resize(n);
  frame.n = std::move(unit);
  for (std::size_t k = 0; k < n; ++k) {
    const Triad triad = local_triad(frame.axes, frame.n[k]);
    frame.t1[k] = triad.t1;
    frame.t2[k] = triad.t2;
  }
  std::fill(frame.weight.begin(), frame.weight.end(), 0.0);
  std::vector<double> element_area(static_cast<std::size_t>(frame.elements()), 0);
  integrate_surface(frame.mesh, [&](std::int64_t e, const Shape& shape, const Vec3&, double area) {
    const auto nodes = frame.mesh.element(e);
    element_area[static_cast<std::size_t>(e)] += area;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      frame.weight[static_cast<std::size_t>(nodes[i])] += area * shape.value[i];
  });
  frame.area = 0;
  for (const double a : element_area) frame.area += a;
  frame.cell_area = cell_areas(frame, element_area);
}

std::vector<double> projected_cell_area(const Frame& frame) {
  if (!frame.curved()) return frame.cell_area;
  return build_dual_cells(split_elements(frame.mesh), frame.x, frame.y).area;
}

}  // namespace rollcon
