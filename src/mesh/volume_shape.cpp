#include "mesh/volume_shape.hpp"

#include <initializer_list>

namespace rollcon {
namespace {

using Edge = std::array<int, 2>;

constexpr Edge tet_edges[6] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
constexpr Edge wedge_edges[9] = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
constexpr Edge hex_edges[12] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

/// Returns the corners, then the middles of the edges.
template <std::size_t corners, std::size_t edges>
constexpr std::array<Vec3, corners + edges> with_middles(const Vec3 (&corner)[corners], const Edge (&edge)[edges]) {
  std::array<Vec3, corners + edges> node{};
  for (std::size_t i = 0; i < corners; ++i) node[i] = corner[i];
  for (std::size_t i = 0; i < edges; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      node[corners + i][c] =
          0.5 * (corner[static_cast<std::size_t>(edge[i][0])][c] + corner[static_cast<std::size_t>(edge[i][1])][c]);
  return node;
}

constexpr auto tet_nodes = with_middles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, tet_edges);
constexpr auto wedge_nodes =
    with_middles({{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, wedge_edges);
constexpr auto hex_nodes = with_middles(
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}, hex_edges);

/// Makes a face from its corners; the midside nodes follow from the element's edges.
template <std::size_t edges>
constexpr VolumeFace face(std::initializer_list<int> corner, int corners, bool quadratic, const Edge (&edge)[edges]) {
  const int* c = corner.begin();
  const bool triangle = corner.size() == 3;
  VolumeFace f{};
  f.type = quadratic ? (triangle ? ElementType::tri6 : ElementType::quad8)
                     : (triangle ? ElementType::tri3 : ElementType::quad4);
  for (std::size_t i = 0; i < corner.size(); ++i) {
    const int a = c[i], b = c[(i + 1) % corner.size()];
    f.node[i] = a;
    for (std::size_t k = 0; quadratic && k < edges; ++k)
      if ((edge[k][0] == a && edge[k][1] == b) || (edge[k][0] == b && edge[k][1] == a))
        f.node[corner.size() + i] = corners + static_cast<int>(k);
  }
  return f;
}

constexpr std::array<VolumeFace, 4> tet_faces(bool q) {
  return {face({0, 2, 1}, 4, q, tet_edges), face({0, 1, 3}, 4, q, tet_edges), face({1, 2, 3}, 4, q, tet_edges),
          face({0, 3, 2}, 4, q, tet_edges)};
}
constexpr std::array<VolumeFace, 5> wedge_faces(bool q) {
  return {face({0, 2, 1}, 6, q, wedge_edges), face({3, 4, 5}, 6, q, wedge_edges), face({0, 1, 4, 3}, 6, q, wedge_edges),
          face({1, 2, 5, 4}, 6, q, wedge_edges), face({2, 0, 3, 5}, 6, q, wedge_edges)};
}
constexpr std::array<VolumeFace, 6> hex_faces(bool q) {
  return {face({0, 3, 2, 1}, 8, q, hex_edges), face({4, 5, 6, 7}, 8, q, hex_edges),
          face({0, 1, 5, 4}, 8, q, hex_edges), face({1, 2, 6, 5}, 8, q, hex_edges),
          face({2, 3, 7, 6}, 8, q, hex_edges), face({3, 0, 4, 7}, 8, q, hex_edges)};
}
constexpr auto tet4_faces = tet_faces(false), tet10_faces = tet_faces(true);
constexpr auto wedge6_faces = wedge_faces(false), wedge15_faces = wedge_faces(true);
constexpr auto hex8_faces = hex_faces(false), hex20_faces = hex_faces(true);

/// Holds a barycentric coordinate L_i of tetrahedra with its constant gradient.
struct Bary {
  double l;
  Vec3 d;
};
std::array<Bary, 4> bary(const Vec3& at) {
  return {{{1 - at[0] - at[1] - at[2], {-1, -1, -1}}, {at[0], {1, 0, 0}}, {at[1], {0, 1, 0}}, {at[2], {0, 0, 1}}}};
}

void tet4(const Vec3& at, VolumeShape& s) {
  const auto b = bary(at);
  for (std::size_t i = 0; i < 4; ++i) s.value[i] = b[i].l, s.d[i] = b[i].d;
}

void tet10(const Vec3& at, VolumeShape& s) {
  const auto b = bary(at);
  for (std::size_t i = 0; i < 4; ++i) {
    s.value[i] = b[i].l * (2 * b[i].l - 1);
    s.d[i] = (4 * b[i].l - 1) * b[i].d;
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const Bary& p = b[static_cast<std::size_t>(tet_edges[k][0])];
    const Bary& q = b[static_cast<std::size_t>(tet_edges[k][1])];
    s.value[4 + k] = 4 * p.l * q.l;
    s.d[4 + k] = (4 * p.l) * q.d + (4 * q.l) * p.d;
  }
}

/// Barycentric coordinates of the wedge's triangle have constant derivatives to xi and eta.
constexpr double bary_xi[3] = {-1, 1, 0}, bary_eta[3] = {-1, 0, 1};

void wedge6(const Vec3& at, VolumeShape& s) {
  const double l[3] = {1 - at[0] - at[1], at[0], at[1]};
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t k = i % 3;
    const double c = i < 3 ? -1 : 1, u = 0.5 * (1 + c * at[2]);
    s.value[i] = l[k] * u;
    s.d[i] = {bary_xi[k] * u, bary_eta[k] * u, 0.5 * c * l[k]};
  }
}

void wedge15(const Vec3& at, VolumeShape& s) {
  const double l[3] = {1 - at[0] - at[1], at[0], at[1]}, z = at[2];
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t k = i % 3;
    const double c = i < 3 ? -1 : 1;
    // The slope is that of L (1 + cz) (2L - 2 + cz) / 2 by L.
    const double slope = 0.5 * (1 + c * z) * (4 * l[k] - 2 + c * z);
    s.value[i] = 0.5 * l[k] * (1 + c * z) * (2 * l[k] - 2 + c * z);
    s.d[i] = {slope * bary_xi[k], slope * bary_eta[k], 0.5 * c * l[k] * (2 * l[k] - 1 + 2 * c * z)};
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t p = i % 3, q = (p + 1) % 3;
    const double c = i < 3 ? -1 : 1, u = 2 * (1 + c * z);
    s.value[6 + i] = u * l[p] * l[q];
    s.d[6 + i] = {u * (bary_xi[p] * l[q] + l[p] * bary_xi[q]), u * (bary_eta[p] * l[q] + l[p] * bary_eta[q]),
                  2 * c * l[p] * l[q]};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double u = 1 - z * z;
    s.value[12 + k] = l[k] * u;
    s.d[12 + k] = {bary_xi[k] * u, bary_eta[k] * u, -2 * z * l[k]};
  }
}

void hex8(const Vec3& at, VolumeShape& s) {
  for (std::size_t i = 0; i < 8; ++i) {
    const auto [a, b, c] = hex_nodes[i];
    const double u = 1 + a * at[0], v = 1 + b * at[1], w = 1 + c * at[2];
    s.value[i] = 0.125 * u * v * w;
    s.d[i] = {0.125 * a * v * w, 0.125 * b * u * w, 0.125 * c * u * v};
  }
}

void hex20(const Vec3& at, VolumeShape& s) {
  for (std::size_t i = 0; i < 8; ++i) {
    const auto [a, b, c] = hex_nodes[i];
    const double x = a * at[0], y = b * at[1], z = c * at[2];
    const double u = 1 + x, v = 1 + y, w = 1 + z;
    s.value[i] = 0.125 * u * v * w * (x + y + z - 2);
    s.d[i] = {0.125 * a * v * w * (2 * x + y + z - 1), 0.125 * b * u * w * (x + 2 * y + z - 1),
              0.125 * c * u * v * (x + y + 2 * z - 1)};
  }
  for (std::size_t i = 8; i < 20; ++i) {
    // Each function is 1 - t^2 along its edge and linear across it.
    std::array<double, 3> f{}, d{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double n = hex_nodes[i][c];
      f[c] = n == 0 ? 1 - at[c] * at[c] : 1 + n * at[c];
      d[c] = n == 0 ? -2 * at[c] : n;
    }
    s.value[i] = 0.25 * f[0] * f[1] * f[2];
    s.d[i] = {0.25 * d[0] * f[1] * f[2], 0.25 * f[0] * d[1] * f[2], 0.25 * f[0] * f[1] * d[2]};
  }
}

}  // namespace

void evaluate_shape(VolumeType type, const Vec3& at, VolumeShape& shape) {
  switch (type) {
    case VolumeType::tet4:
      return tet4(at, shape);
    case VolumeType::tet10:
      return tet10(at, shape);
    case VolumeType::wedge6:
      return wedge6(at, shape);
    case VolumeType::wedge15:
      return wedge15(at, shape);
    case VolumeType::hex8:
      return hex8(at, shape);
    case VolumeType::hex20:
      return hex20(at, shape);
  }
}

std::span<const Vec3> reference_nodes(VolumeType type) {
  const auto n = static_cast<std::size_t>(node_count(type));
  switch (corner_count(type)) {
    case 4:
      return {tet_nodes.data(), n};
    case 6:
      return {wedge_nodes.data(), n};
    default:
      return {hex_nodes.data(), n};
  }
}

std::span<const VolumeFace> faces_of(VolumeType type) {
  switch (type) {
    case VolumeType::tet4:
      return tet4_faces;
    case VolumeType::tet10:
      return tet10_faces;
    case VolumeType::wedge6:
      return wedge6_faces;
    case VolumeType::wedge15:
      return wedge15_faces;
    case VolumeType::hex8:
      return hex8_faces;
    case VolumeType::hex20:
      return hex20_faces;
  }
  return {};
}

std::span<const std::array<int, 2>> edges_of(VolumeType type) {
  switch (corner_count(type)) {
    case 4:
      return tet_edges;
    case 6:
      return wedge_edges;
    default:
      return hex_edges;
  }
}

}  // namespace rollcon
