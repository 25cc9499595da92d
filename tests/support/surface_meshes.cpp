#include "support/surface_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "mesh/shape.hpp"
#include "support/frames.hpp"

// The examples offer more meshes than are needed here.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "../../examples/ring_mesh.h"
#include "../../examples/wheel_mesh.h"
#pragma GCC diagnostic pop

namespace rollcon::surfaces {
namespace {

constexpr double pi = std::numbers::pi;

/// Drops nodes of no element.
SurfaceMesh compact(SurfaceMesh mesh) {
  std::vector<std::int32_t> number(mesh.node.size(), -1);
  std::vector<Vec3> node;
  for (const std::int32_t k : mesh.connectivity) number[at(k)] = 0;
  for (std::size_t k = 0; k < number.size(); ++k)
    if (number[k] == 0) {
      number[k] = static_cast<std::int32_t>(node.size());
      node.push_back(mesh.node[k]);
    }
  for (std::int32_t& k : mesh.connectivity) k = number[at(k)];
  mesh.node = std::move(node);
  return mesh;
}

/// Turns quad9 into elements of the type wanted for each, on some of its nodes.
SurfaceMesh convert(const SurfaceMesh& fine, const std::function<ElementType(std::int64_t)>& want) {
  SurfaceMesh mesh;
  mesh.node = fine.node;
  for (std::int64_t e = 0; e < fine.elements(); ++e) {
    const auto n = fine.element(e);
    const std::int32_t tag = fine.tag[at(e)];
    const ElementType type = want(e);
    const bool other_diagonal = e % 2 == 1;
    switch (type) {
      case ElementType::quad4:
        add_element(mesh, type, {n[0], n[1], n[2], n[3]}, tag);
        break;
      case ElementType::quad8:
        add_element(mesh, type, {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]}, tag);
        break;
      case ElementType::quad9:
        add_element(mesh, type, {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8]}, tag);
        break;
      case ElementType::tri3:
        if (other_diagonal) {
          add_element(mesh, type, {n[0], n[1], n[3]}, tag);
          add_element(mesh, type, {n[1], n[2], n[3]}, tag);
        } else {
          add_element(mesh, type, {n[0], n[1], n[2]}, tag);
          add_element(mesh, type, {n[0], n[2], n[3]}, tag);
        }
        break;
      case ElementType::tri6:
        if (other_diagonal) {
          add_element(mesh, type, {n[0], n[1], n[3], n[4], n[8], n[7]}, tag);
          add_element(mesh, type, {n[1], n[2], n[3], n[5], n[6], n[8]}, tag);
        } else {
          add_element(mesh, type, {n[0], n[1], n[2], n[4], n[5], n[8]}, tag);
          add_element(mesh, type, {n[0], n[2], n[3], n[8], n[6], n[7]}, tag);
        }
        break;
    }
  }
  return compact(std::move(mesh));
}

SurfaceMesh as_type(const SurfaceMesh& fine, ElementType type) {
  return convert(fine, [type](std::int64_t) { return type; });
}

/// Takes over and frees the C mesh of quad9.
SurfaceMesh taken_over(body_mesh& m) {
  SurfaceMesh mesh;
  for (int k = 0; k < m.nodes; ++k) mesh.node.push_back({m.x[k][0], m.x[k][1], m.x[k][2]});
  for (std::int32_t tag = 0; tag < MOST_TAGS; ++tag)
    for (int e = m.first[tag]; e < m.first[tag + 1]; ++e)
      add_element(mesh, static_cast<ElementType>(m.type), {m.id + e * m.per_element, at(m.per_element)}, tag);
  free_body_mesh(&m);
  return mesh;
}

void require_made(int made) {
  if (!made) throw std::bad_alloc();
}

SurfaceMesh fine_block(const Block& shape) {
  body_grid g{};
  for (std::size_t c = 0; c < 3; ++c) {
    g.n[c] = static_cast<int>(shape.line[c].size()) - 1;
    g.line[c] = shape.line[c].data();
  }
  g.ring = shape.ring ? 1 : 0;
  for (std::size_t f = 0; f < 6; ++f) g.face_tag[f] = shape.tag[f];
  for (std::size_t c = 0; c < 2; ++c) {
    g.zone_from[c] = shape.zone_from[c];
    g.zone_to[c] = shape.zone_to[c];
  }
  g.zone_tag = shape.zone_tag;
  g.shape = &shape.map;
  g.position = [](const double* q, const void* map, double* x) {
    const auto& f = *static_cast<const Map*>(map);
    const Vec3 y = f ? f({q[0], q[1], q[2]}) : Vec3{q[0], q[1], q[2]};
    std::copy(y.begin(), y.end(), x);
  };
  body_mesh m;
  require_made(make_grid_mesh(&m, &g, ROLLCON_QUAD9));
  return taken_over(m);
}

void append(SurfaceMesh& mesh, const SurfaceMesh& other) {
  const auto first = static_cast<std::int32_t>(mesh.nodes());
  mesh.node.insert(mesh.node.end(), other.node.begin(), other.node.end());
  for (std::int64_t e = 0; e < other.elements(); ++e) {
    std::vector<std::int32_t> nodes(other.element(e).begin(), other.element(e).end());
    for (std::int32_t& k : nodes) k += first;
    add_element(mesh, other.type[at(e)], nodes, other.tag[at(e)]);
  }
}

/// Moves midside nodes and centres to the middle of their corners.
void recentre(SurfaceMesh& mesh) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[at(e)];
    if (!is_quadratic(type)) continue;
    const auto n = mesh.element(e);
    const auto corners = at(corner_count(type));
    Vec3 sum{0, 0, 0};
    for (std::size_t i = 0; i < corners; ++i) {
      const Vec3 &a = mesh.node[at(n[i])], &b = mesh.node[at(n[(i + 1) % corners])];
      mesh.node[at(n[corners + i])] = 0.5 * (a + b);
      sum = sum + a;
    }
    if (type == ElementType::quad9) mesh.node[at(n[8])] = 0.25 * sum;
  }
}

}  // namespace

void add_element(SurfaceMesh& mesh, ElementType type, std::span<const std::int32_t> nodes, std::int32_t tag) {
  if (mesh.offset.empty()) mesh.offset.push_back(0);
  mesh.type.push_back(type);
  mesh.tag.push_back(tag);
  mesh.connectivity.insert(mesh.connectivity.end(), nodes.begin(), nodes.end());
  mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
}

SurfaceMesh one_element(ElementType type, std::vector<Vec3> nodes) {
  SurfaceMesh mesh;
  std::vector<std::int32_t> all(nodes.size());
  std::iota(all.begin(), all.end(), 0);
  mesh.node = std::move(nodes);
  add_element(mesh, type, all);
  return mesh;
}

SurfaceMesh one_element(ElementType type, const Map& map) {
  std::vector<Vec3> nodes;
  for (const ReferencePoint& r : reference_nodes(type)) nodes.push_back(map({r.xi, r.eta, 0}));
  return one_element(type, std::move(nodes));
}

std::string name_of(ElementType type) {
  return (corner_count(type) == 3 ? "tri" : "quad") + std::to_string(node_count(type));
}

std::vector<double> graded(int n, double a, double b, double first, double largest) {
  std::vector<double> line(at(n) + 1);
  graded_lines(line.data(), n, a, b, first, largest);
  return line;
}

std::vector<double> graded_to(int n, double a, double b, double last, double largest) {
  std::vector<double> line = graded(n, b, a, last, largest);
  std::reverse(line.begin(), line.end());
  return line;
}

SurfaceMesh block(const Block& shape, ElementType type) {
  return as_type(fine_block(shape), type);
}

SurfaceMesh mixed_block(const Block& shape, bool quadratic) {
  return convert(fine_block(shape), [quadratic](std::int64_t e) {
    if (!quadratic) return e % 3 == 0 ? ElementType::tri3 : ElementType::quad4;
    return e % 3 == 0 ? ElementType::tri6 : e % 3 == 1 ? ElementType::quad8 : ElementType::quad9;
  });
}

Block brick(const std::array<int, 3>& n, const Vec3& size) {
  Block b;
  for (std::size_t c = 0; c < 3; ++c) b.line[c] = frames::uniform_lines(0, size[c], n[c]);
  return b;
}

SurfaceMesh distort(SurfaceMesh mesh, double fraction, std::uint32_t seed) {
  std::vector<double> shortest(mesh.node.size(), std::numeric_limits<double>::max());
  std::vector<std::uint8_t> corner(mesh.node.size(), 0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto n = mesh.element(e);
    const auto corners = at(corner_count(mesh.type[at(e)]));
    double edge = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < corners; ++i) {
      corner[at(n[i])] = 1;
      edge = std::min(edge, length(mesh.node[at(n[i])] - mesh.node[at(n[(i + 1) % corners])]));
    }
    for (const std::int32_t k : n) shortest[at(k)] = std::min(shortest[at(k)], edge);
  }
  shake(mesh.node, shortest, corner, fraction, seed, [&mesh] { recentre(mesh); });
  return mesh;
}

void shake(std::vector<Vec3>& node, std::span<const double> edge, std::span<const std::uint8_t> corner, double fraction,
           std::uint32_t seed, const std::function<void()>& follow) {
  const std::vector<Vec3> start = node;
  Vec3 low = start.front(), high = low;
  for (const Vec3& x : start)
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], x[c]);
      high[c] = std::max(high[c], x[c]);
    }
  frames::Random random(seed);
  const auto move = [&](bool corners, double part) {
    for (std::size_t k = 0; k < node.size(); ++k)
      for (std::size_t c = 0; c < 3 && (corner[k] != 0) == corners; ++c) {
        const bool bound = start[k][c] == low[c] || start[k][c] == high[c];
        if (!bound) node[k][c] += part * edge[k] * random();
      }
  };
  move(true, fraction);
  follow();
  move(false, 0.2 * fraction);
}

SurfaceMesh cube_sphere(ElementType type, int n, double radius, std::int32_t tag) {
  Block b;
  for (auto& line : b.line) line = frames::uniform_lines(-1, 1, n);
  b.tag.fill(tag);
  b.map = [radius](const Vec3& q) {
    // Equal angles make the elements nearly equal.
    const Vec3 d{std::tan(pi / 4 * q[0]), std::tan(pi / 4 * q[1]), std::tan(pi / 4 * q[2])};
    return radius / length(d) * d;
  };
  return block(b, type);
}

SurfaceMesh icosphere(ElementType type, int n, double radius, std::int32_t tag) {
  if (corner_count(type) != 3) throw std::invalid_argument("icosphere: triangles only");
  const double g = (1 + std::sqrt(5.0)) / 2;
  const Vec3 corner[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                           {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr int face[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  const int cuts = is_quadratic(type) ? 2 * n : n;  // steps between nodes along an edge
  SurfaceMesh mesh;
  std::map<std::array<std::int64_t, 3>, std::int32_t> known;
  const auto node = [&](const int* f, int i, int j) {
    const Vec3 x =
        (1.0 / cuts) * (double(cuts - i - j) * corner[f[0]] + double(i) * corner[f[1]] + double(j) * corner[f[2]]);
    const std::array<std::int64_t, 3> key{std::llround(1e6 * x[0]), std::llround(1e6 * x[1]), std::llround(1e6 * x[2])};
    const auto [place, fresh] = known.try_emplace(key, static_cast<std::int32_t>(mesh.nodes()));
    if (fresh) mesh.node.push_back(radius / length(x) * x);
    return place->second;
  };
  const int s = is_quadratic(type) ? 2 : 1;
  for (const auto& f : face)
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
        for (const int up : {1, -1}) {
          if (up < 0 && i + j + 1 >= n) continue;
          // The triangle is upright (i, j), (i + 1, j), (i, j + 1), or its neighbour turned by half a turn.
          const int a = s * (up > 0 ? i : i + 1), b = s * (up > 0 ? j : j + 1), d = s * up;
          if (s == 1)
            add_element(mesh, type, {node(f, a, b), node(f, a + d, b), node(f, a, b + d)}, tag);
          else
            add_element(mesh, type,
                        {node(f, a, b), node(f, a + d, b), node(f, a, b + d), node(f, a + d / 2, b),
                         node(f, a + d / 2, b + d / 2), node(f, a, b + d / 2)},
                        tag);
        }
  return mesh;
}

SurfaceMesh with_cavity(SurfaceMesh outer, SurfaceMesh inner) {
  append(outer, turn_inside_out(std::move(inner)));
  return outer;
}

SurfaceMesh ring(const Ring& shape, ElementType type) {
  const ring_shape r{shape.inner,       shape.outer,  shape.width, shape.sector,  shape.zone,      shape.around,
                     shape.zone_around, shape.across, shape.deep,  shape.largest, shape.top_layer, shape.side_grading};
  body_mesh m;
  require_made(make_ring_mesh(&m, &r, ROLLCON_QUAD9));
  return as_type(taken_over(m), type);
}

SurfaceMesh wheel(double crown, ElementType type) {
  wheel_shape w = paper_wheel(crown);
  body_mesh m;
  require_made(make_wheel_mesh(&m, &w, ROLLCON_QUAD9));
  return as_type(taken_over(m), type);
}

Block ring_block(const Ring& shape) {
  Block b;
  std::vector<double> angle(at(shape.around) + 1), y(at(shape.across) + 1);
  lines_with_zone(angle.data(), shape.around, shape.sector > 0 ? shape.sector / 2 : pi, shape.zone_around,
                  shape.zone / 2 / shape.outer, shape.largest / shape.outer);
  for (int k = 0; k <= shape.across; ++k) {
    const double t = 2.0 * k / shape.across - 1;
    y[at(k)] = shape.width / 2 * (t + shape.side_grading * (std::sin(pi / 2 * t) - t));
  }
  const double layer = shape.top_layer > 0 ? shape.top_layer : (shape.outer - shape.inner) / shape.deep;
  b.line = {angle, y, graded_to(shape.deep, shape.inner, shape.outer, layer)};
  b.ring = shape.sector <= 0;
  b.tag = {6, 7, 4, 5, 3, 1};
  b.zone_from = {(shape.around - shape.zone_around) / 2, 0};
  b.zone_to = {b.zone_from[0] + shape.zone_around, shape.across};
  b.zone_tag = 2;
  b.map = [](const Vec3& q) { return Vec3{q[2] * std::sin(q[0]), q[1], q[2] * std::cos(q[0])}; };
  return b;
}

Block with_zone(const ZoneBlock& shape) {
  Block b;
  const int across = shape.n + 2 * shape.grade;
  std::vector<double> line(at(across) + 1);
  lines_with_zone(line.data(), across, shape.side / 2, shape.n, shape.zone / 2, 0);
  b.line[0] = b.line[1] = line;
  b.line[2] = graded_to(shape.deep, -shape.depth, 0, shape.zone / shape.n);
  b.tag = {4, 5, 6, 7, 3, 1};
  b.zone_from = {shape.grade, shape.grade};
  b.zone_to = {shape.grade + shape.n, shape.grade + shape.n};
  b.zone_tag = 2;
  return b;
}

SurfaceMesh zone_block(const ZoneBlock& shape, ElementType type) {
  return block(with_zone(shape), type);
}

SurfaceMesh transform(SurfaceMesh mesh, const Map& map) {
  for (Vec3& x : mesh.node) x = map(x);
  return mesh;
}

SurfaceMesh turn_inside_out(SurfaceMesh mesh) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto first = mesh.connectivity.begin() + mesh.offset[at(e)];
    const int corners = corner_count(mesh.type[at(e)]);
    std::reverse(first + 1, first + corners);
    if (is_quadratic(mesh.type[at(e)])) std::reverse(first + corners, first + 2 * corners);
  }
  return mesh;
}

}  // namespace rollcon::surfaces
