// Answers questions about a surface mesh; the meshes themselves are made in surface_meshes.cpp.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_quadrature.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::surfaces {

std::vector<std::int32_t> nodes_with_tag(const SurfaceMesh& mesh, std::span<const std::int32_t> tags) {
  std::vector<std::int32_t> nodes;
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    if (std::find(tags.begin(), tags.end(), mesh.tag[at(e)]) != tags.end())
      nodes.insert(nodes.end(), mesh.element(e).begin(), mesh.element(e).end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::vector<std::int32_t> nodes_where(const SurfaceMesh& mesh, const std::function<bool(const Vec3&)>& wanted) {
  std::vector<std::int32_t> nodes;
  for (std::int64_t k = 0; k < mesh.nodes(); ++k)
    if (wanted(mesh.node[at(k)])) nodes.push_back(static_cast<std::int32_t>(k));
  return nodes;
}

std::int32_t node_at(const SurfaceMesh& mesh, const Vec3& x) {
  const auto nearest = std::min_element(mesh.node.begin(), mesh.node.end(),
                                        [&](const Vec3& a, const Vec3& b) { return length(a - x) < length(b - x); });
  return static_cast<std::int32_t>(nearest - mesh.node.begin());
}

std::vector<std::int64_t> elements_with_tag(const SurfaceMesh& mesh, std::int32_t tag) {
  std::vector<std::int64_t> elements;
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    if (mesh.tag[at(e)] == tag) elements.push_back(e);
  return elements;
}

SurfaceMesh part_of(const SurfaceMesh& mesh, std::span<const std::int64_t> elements, std::vector<std::int32_t>& node) {
  SurfaceMesh part;
  part.offset.push_back(0);
  node.clear();
  std::map<std::int32_t, std::int32_t> number;
  for (const std::int64_t e : elements) {
    std::vector<std::int32_t> own;
    for (const std::int32_t k : mesh.element(e)) {
      const auto [place, fresh] = number.try_emplace(k, static_cast<std::int32_t>(node.size()));
      if (fresh) {
        node.push_back(k);
        part.node.push_back(mesh.node[at(k)]);
      }
      own.push_back(place->second);
    }
    add_element(part, mesh.type[at(e)], own, mesh.tag[at(e)]);
  }
  return part;
}

SurfaceMesh part_with_tag(const SurfaceMesh& mesh, std::int32_t tag) {
  std::vector<std::int32_t> node;
  return part_of(mesh, elements_with_tag(mesh, tag), node);
}

SurfaceMesh only(const SurfaceMesh& mesh, const std::function<bool(std::int64_t)>& wanted) {
  SurfaceMesh part;
  part.node = mesh.node;
  part.index_base = mesh.index_base;
  part.offset.push_back(0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    if (wanted(e)) add_element(part, mesh.type[at(e)], mesh.element(e), mesh.tag[at(e)]);
  return part;
}

std::vector<double> nodal_areas(const SurfaceMesh& mesh) {
  std::vector<double> area(mesh.node.size(), 0.0);
  integrate_surface(mesh, [&](std::int64_t e, const Shape& s, const Vec3&, double a) {
    const auto n = mesh.element(e);
    for (std::size_t i = 0; i < n.size(); ++i) area[at(n[i])] += a * s.value[i];
  });
  return area;
}

Facts facts(const SurfaceMesh& mesh) {
  Facts f;
  std::map<std::pair<std::int32_t, std::int32_t>, int> run;  // directed edges
  std::vector<std::uint8_t> used(mesh.node.size(), 0), corner(mesh.node.size(), 0);
  const PlaneRule triangle = triangle_rule(10), square = square_rule(10);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[at(e)];
    const auto n = mesh.element(e);
    const auto corners = at(corner_count(type));
    ++(corners == 3 ? f.triangles : f.quadrilaterals);
    for (const std::int32_t k : n) used[at(k)] = 1;
    for (std::size_t i = 0; i < corners; ++i) {
      corner[at(n[i])] = 1;
      ++run[{n[i], n[(i + 1) % corners]}];
    }
    const PlaneRule& rule = corners == 3 ? triangle : square;
    Shape s;
    for (std::size_t p = 0; p < rule.size(); ++p) {
      evaluate_shape(type, rule.xi[p], rule.eta[p], s);
      Vec3 x{0, 0, 0}, u{0, 0, 0}, v{0, 0, 0};
      for (std::size_t a = 0; a < n.size(); ++a) {
        x = x + s.value[a] * mesh.node[at(n[a])];
        u = u + s.d_xi[a] * mesh.node[at(n[a])];
        v = v + s.d_eta[a] * mesh.node[at(n[a])];
      }
      const Vec3 normal = cross(u, v);
      f.area += rule.w[p] * length(normal);
      f.volume += rule.w[p] * dot(x, normal) / 3;
      for (std::size_t c = 0; c < 3; ++c) f.centroid[c] += rule.w[p] * x[c] * x[c] * normal[c] / 2;
    }
  }
  f.centroid = (1 / f.volume) * f.centroid;
  std::int64_t edges = 0;
  for (const auto& [edge, times] : run) {
    if (times > 1) ++f.clashing_edges;
    const bool back = run.contains({edge.second, edge.first});
    if (!back) ++f.open_edges;
    if (!back || edge.first < edge.second) ++edges;
  }
  f.euler = std::count(corner.begin(), corner.end(), 1) - edges + mesh.elements();
  f.unused_nodes = std::count(used.begin(), used.end(), 0);
  return f;
}

}  // namespace rollcon::surfaces
