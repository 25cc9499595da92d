#include "mesh/frame_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "mesh/mesh_errors.hpp"
#include "mesh/overlap.hpp"
#include "mesh/shape.hpp"

namespace rollcon {
namespace {

/// Smallest height of an element over its length, and smallest distance of two nodes likewise.
constexpr double smallest_ratio = 1e-10;
/// cos 60 degrees: the frame's slope against the tangent plane.
constexpr double smallest_cosine = 0.5;

/// Points where an element's Jacobian is checked. A linear element's is linear in each variable, so
/// its corners decide; quadratic ones get a lattice with spacing 1/8 of the element, corners
/// included.
std::vector<Shape> check_shapes(ElementType type) {
  const bool triangle = corner_count(type) == 3;
  const int steps = is_quadratic(type) ? 8 : 1;
  std::vector<Shape> shapes;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= (triangle ? steps - i : steps); ++j) {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      shapes.emplace_back();
      if (triangle)
        evaluate_shape(type, u, v, shapes.back());
      else
        evaluate_shape(type, 2 * u - 1, 2 * v - 1, shapes.back());
    }
  return shapes;
}

struct Extent {
  double size = 0;       ///< longest distance of two nodes
  double magnitude = 0;  ///< largest coordinate
  std::size_t near_i = 0, near_j = 0;
  double nearest = std::numeric_limits<double>::infinity();
};

Extent measure(std::span<const Vec3> point) {
  Extent extent;
  for (std::size_t i = 0; i < point.size(); ++i) {
    for (double c : point[i]) extent.magnitude = std::max(extent.magnitude, std::abs(c));
    for (std::size_t j = 0; j < i; ++j) {
      const double d = std::hypot(point[i][0] - point[j][0], point[i][1] - point[j][1],
                                  point[i][2] - point[j][2]);
      extent.size = std::max(extent.size, d);
      if (d < extent.nearest) extent.nearest = d, extent.near_i = j, extent.near_j = i;
    }
  }
  return extent;
}

struct Sign {
  bool positive = false, negative = false, vanishing = false, steep = false;
};

/// Signs of the Jacobian over the check points, coordinates divided by the element's size.
Sign jacobian_signs(std::span<const Vec3> point, double size, std::span<const Shape> shapes,
                    double tolerance) {
  Sign sign;
  for (const Shape& s : shapes) {
    double u[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    for (std::size_t i = 0; i < point.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double c = (point[i][k] - point[0][k]) / size;
        u[k] += s.d_xi[i] * c;
        v[k] += s.d_eta[i] * c;
      }
    const double n = u[0] * v[1] - u[1] * v[0];
    const double whole = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], n);
    if (whole <= tolerance)
      sign.vanishing = true;
    else if (std::abs(n) < smallest_cosine * whole)
      sign.steep = true;
    else
      (n > 0 ? sign.positive : sign.negative) = true;
  }
  return sign;
}

}  // namespace

void check_connectivity(const SurfaceMesh& mesh) {
  if (mesh.elements() == 0) fail(Status::err_mesh, "the contact frame has no elements");
  check_connectivity(mesh, "frame");
}

void check_elements(const SurfaceMesh& mesh, std::span<const double> x, std::span<const double> y,
                    std::span<const double> z) {
  const int base = mesh.index_base;
  std::map<ElementType, std::vector<Shape>> shapes;
  Tally coincident, degenerate, flipped, folded, steep;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto nodes = mesh.element(e);
    const auto id = static_cast<long long>(e + base);
    std::array<Vec3, max_element_nodes> all;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto k = static_cast<std::size_t>(nodes[i]);
      all[i] = {x[k], y[k], z[k]};
    }
    const std::span<const Vec3> point(all.data(), nodes.size());
    const Extent extent = measure(point);
    // Coordinates carry the rounding of their magnitude: what is below it cannot be told from zero.
    const double rounding =
        16 * std::numeric_limits<double>::epsilon() * extent.magnitude / extent.size;
    const double tolerance = std::max(smallest_ratio, rounding);
    if (!(extent.nearest > tolerance * extent.size)) {
      coincident.add("element %lld (%s), nodes %lld and %lld", id, name(type),
                     static_cast<long long>(nodes[extent.near_i]) + base,
                     static_cast<long long>(nodes[extent.near_j]) + base);
      continue;
    }
    auto& at = shapes[type];
    if (at.empty()) at = check_shapes(type);
    const Sign sign = jacobian_signs(point, extent.size, at, tolerance);
    if (sign.vanishing)
      degenerate.add("element %lld (%s)", id, name(type));
    else if (sign.positive && sign.negative)
      folded.add("element %lld (%s)", id, name(type));
    else if (sign.steep)
      steep.add("element %lld (%s)", id, name(type));
    else if (sign.negative)
      flipped.add("element %lld (%s)", id, name(type));
  }
  coincident.fail_if_any("degenerate element: two of its nodes coincide", "frame", mesh.index_base);
  degenerate.fail_if_any("degenerate element: its Jacobian vanishes", "frame", mesh.index_base);
  folded.fail_if_any("degenerate element: its Jacobian changes sign", "frame", mesh.index_base);
  if (flipped.count == mesh.elements())
    flipped.fail_if_any(
        "all elements are flipped (clockwise seen from the tip of the normal n): reverse the order "
        "of their nodes, or n (rollcon_contact_set_axes)",
        "frame", mesh.index_base);
  flipped.fail_if_any("flipped element: clockwise seen from the tip of the normal n", "frame",
                      mesh.index_base);
  steep.fail_if_any(
      "element steeper than 60 degrees against the tangent plane of the axes "
      "(rollcon_contact_set_axes sets it)",
      "frame", mesh.index_base);
}

namespace {

/// Corner edges must carry the same midside node (or none) in both of their elements.
void check_midsides(const SurfaceMesh& mesh) {
  struct Edge {
    std::int32_t low, high, mid;
    std::int64_t element;
  };
  std::vector<Edge> edge;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto n = mesh.element(e);
    const auto corners = static_cast<std::size_t>(corner_count(type));
    for (std::size_t i = 0; i < corners; ++i) {
      const std::int32_t a = n[i], b = n[(i + 1) % corners];
      edge.push_back({std::min(a, b), std::max(a, b), is_quadratic(type) ? n[corners + i] : -1, e});
    }
  }
  std::sort(edge.begin(), edge.end(), [](const Edge& a, const Edge& b) {
    return std::tuple(a.low, a.high, a.element) < std::tuple(b.low, b.high, b.element);
  });
  Tally differ;
  const auto base = static_cast<long long>(mesh.index_base);
  for (std::size_t i = 1; i < edge.size(); ++i) {
    const Edge &a = edge[i - 1], &b = edge[i];
    if (a.low == b.low && a.high == b.high && a.mid != b.mid)
      differ.add("edge %lld-%lld of elements %lld and %lld", a.low + base, a.high + base,
                 static_cast<long long>(a.element) + base,
                 static_cast<long long>(b.element) + base);
  }
  differ.fail_if_any("two elements share an edge but not its midside node", "frame",
                     mesh.index_base);
}

}  // namespace

void check_cells(const SurfaceMesh& mesh, const LinearCells& cells, std::span<const Side> side,
                 std::span<const double> x, std::span<const double> y) {
  const auto base = static_cast<long long>(mesh.index_base);
  auto element_id = [&](std::int64_t cell) {
    return static_cast<long long>(cells.element[static_cast<std::size_t>(cell)]) + base;
  };
  Tally crowded, same_side, concave;
  for_each_edge(side, [&](const Side& s, std::size_t count) {
    const Side* all = &s;
    if (count > 2)
      crowded.add("edge %lld-%lld with %lld elements (%lld, %lld, %lld, ...)", s.low() + base,
                  s.high() + base, static_cast<long long>(count), element_id(all[0].cell),
                  element_id(all[1].cell), element_id(all[2].cell));
    else if (count == 2 && all[0].from == all[1].from)
      same_side.add("elements %lld and %lld on edge %lld-%lld", element_id(all[0].cell),
                    element_id(all[1].cell), s.low() + base, s.high() + base);
  });
  crowded.fail_if_any("more than two elements share an edge", "frame", mesh.index_base);
  same_side.fail_if_any("two elements lie on the same side of their common edge", "frame",
                        mesh.index_base);
  check_midsides(mesh);
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    for (std::size_t i = 0; i < n.size(); ++i) {
      const auto a = static_cast<std::size_t>(n[(i + n.size() - 1) % n.size()]);
      const auto b = static_cast<std::size_t>(n[i]);
      const auto d = static_cast<std::size_t>(n[(i + 1) % n.size()]);
      const double px = x[b] - x[a], py = y[b] - y[a], qx = x[d] - x[b], qy = y[d] - y[b];
      if (px * qy - py * qx <= 0) {
        concave.add("element %lld at node %lld", element_id(c), static_cast<long long>(b) + base);
        break;
      }
    }
  }
  concave.fail_if_any("element too curved: its parts between neighbouring nodes fold", "frame",
                      mesh.index_base);
  const Overlap overlap = find_overlap(cells, x, y, 1e-9);
  if (overlap.count > 0)
    fail(Status::err_mesh,
         "the frame folds over itself when projected on the tangent plane of the axes "
         "(rollcon_contact_set_axes sets it): elements %lld and %lld (counting from %d) overlap; "
         "%lld parts of elements concerned",
         element_id(overlap.first), element_id(overlap.second), mesh.index_base,
         static_cast<long long>(overlap.count));
}

}  // namespace rollcon
