#include "geometry/surface_coupling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/coupled_element.hpp"
#include "mesh/corner_elements.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"
#include "mesh/surface_quadrature.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

struct Entry {
  std::int32_t row, column;
  double value;
};

/// Sums entries with one row and column.
SurfaceCoupling compress(std::vector<Entry>& entry, std::int64_t nodes) {
  std::stable_sort(entry.begin(), entry.end(),
                   [](const Entry& p, const Entry& q) { return p.row != q.row ? p.row < q.row : p.column < q.column; });
  SurfaceCoupling m;
  m.begin(nodes);
  for (std::size_t i = 0; i < entry.size(); ++i) {
    const Entry& e = entry[i];
    if (m.node.empty() || m.node.back() != e.row) {
      if (i > 0) m.end_column();
      m.node.push_back(e.row);
    } else if (entry[i - 1].column == e.column) {
      m.value.back() += e.value;
      continue;
    }
    m.push(e.column, e.value);
  }
  if (!entry.empty()) m.end_column();
  return m;
}

/// Holds the values of int N_i N_j of one element.
using ElementMatrix = std::array<std::array<double, max_element_nodes>, max_element_nodes>;

ElementMatrix own_matrix(const SurfaceMesh& mesh, std::int64_t element) {
  ElementMatrix m{};
  const auto n = mesh.element(element).size();
  integrate_element(mesh, element, [&](const Shape& shape, const Vec3&, double area) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) m[i][j] += area * shape.value[i] * shape.value[j];
  });
  return m;
}

/// Integrates N_i L_j, with L_j the linear function of corner j.
ElementMatrix corner_matrix(const SurfaceMesh& mesh, std::int64_t element) {
  const ElementType type = mesh.type[at(element)];
  const auto corners = static_cast<std::size_t>(corner_count(type));
  // The corner functions themselves give the integrals, because they are linear in the quadratic ones.
  const auto points = reference_nodes(type);
  std::array<Shape, max_element_nodes> linear;
  for (std::size_t k = 0; k < points.size(); ++k)
    evaluate_shape(linear_type(type), points[k].xi, points[k].eta, linear[k]);
  const ElementMatrix own = own_matrix(mesh, element);
  ElementMatrix m{};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < corners; ++j)
      for (std::size_t k = 0; k < points.size(); ++k) m[i][j] += own[i][k] * linear[k].value[j];
  return m;
}

/// Returns the face that a layer element is, or whose corners a linear one has, with the face's local nodes in the
/// layer's order; -1: none.
std::int64_t same_face(const SurfaceMesh& body, std::span<const std::int64_t> candidates, const SurfaceMesh& layer,
                       std::int64_t element, std::array<std::size_t, max_element_nodes>& local) {
  const auto nodes = layer.element(element);
  const double reach = 1e-9 * element_diameter(layer, element);
  for (const std::int64_t f : candidates) {
    const ElementType type = layer.type[at(element)];
    if (body.type[at(f)] != type && linear_type(body.type[at(f)]) != type) continue;
    const auto own = body.element(f).first(nodes.size());
    std::size_t found = 0;
    for (; found < nodes.size(); ++found) {
      const Vec3& x = layer.node[at(nodes[found])];
      const auto k =
          std::find_if(own.begin(), own.end(), [&](std::int32_t i) { return length(body.node[at(i)] - x) <= reach; });
      if (k == own.end()) break;
      local[found] = at(k - own.begin());
    }
    if (found == nodes.size()) return f;
  }
  return -1;
}

/// Drops the slivers that rounding makes where a layer ends at a face's edge, which would count as loads on the next
/// face. What is dropped is less than the digits of the sums show.
void drop_slivers(std::vector<Entry>& entry, std::int64_t nodes) {
  constexpr double least = 1e-10;
  std::vector<double> size(at(nodes), 0.0);
  double mean = 0;
  for (const Entry& e : entry) size[at(e.row)] += std::abs(e.value);
  std::int64_t loaded = 0;
  for (const double s : size)
    if (s > 0) ++loaded, mean += s;
  if (loaded == 0) return;
  mean /= static_cast<double>(loaded);
  std::erase_if(entry, [&](const Entry& e) { return size[at(e.row)] <= least * mean; });
}

}  // namespace

SurfaceCoupling couple_faces(const SurfaceMesh& mesh, std::span<const std::int64_t> face) {
  std::vector<Entry> entry;
  for (const std::int64_t f : face) {
    const ElementMatrix m = own_matrix(mesh, f);
    const auto nodes = mesh.element(f);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < nodes.size(); ++j) entry.push_back({nodes[i], nodes[j], m[i][j]});
  }
  return compress(entry, mesh.nodes());
}

SurfaceCoupling couple_layer(const SurfaceMesh& body, std::span<const std::int64_t> face, const SurfaceMesh& layer) {
  std::vector<Entry> entry;
  if (face.empty()) return compress(entry, layer.nodes());
  const SurfaceSearch search(body, face);
  ElementCoupling coupling(body, search, layer);
  std::array<std::size_t, max_element_nodes> local{};
  bool in_faces = true;
  for (std::int64_t e = 0; e < layer.elements(); ++e) {
    const auto nodes = layer.element(e);
    const std::int64_t same = same_face(body, coupling.candidates(e), layer, e, local);
    if (same >= 0) {
      const bool whole = body.type[at(same)] == layer.type[at(e)];
      const ElementMatrix m = whole ? own_matrix(body, same) : corner_matrix(body, same);
      const auto own = body.element(same);
      for (std::size_t i = 0; i < own.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j) entry.push_back({own[i], nodes[j], m[i][local[j]]});
      continue;
    }
    in_faces = false;
    for (const CoupledNode& row : coupling.integrate(e))
      for (std::size_t j = 0; j < nodes.size(); ++j) entry.push_back({row.node, nodes[j], row.value[j]});
  }
  drop_slivers(entry, body.nodes());
  SurfaceCoupling result = compress(entry, layer.nodes());
  result.in_faces = in_faces;
  return result;
}

}  // namespace rollcon
