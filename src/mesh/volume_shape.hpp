#pragma once
/// Gives shape functions, faces and quadrature of volume elements. The reference tetrahedron has the corners 000, 100,
/// 010, 001; the wedge is the triangle (0,0), (1,0), (0,1) times [-1, 1]; the hexahedron is [-1, 1]^3, with its first
/// corner at (-1, -1, -1).

#include <array>
#include <span>
#include <vector>

#include "mesh/element_type.hpp"
#include "mesh/vec3.hpp"
#include "mesh/volume_type.hpp"

namespace rollcon {

struct VolumeShape {
  std::array<double, max_volume_nodes> value;  ///< N_i
  std::array<Vec3, max_volume_nodes> d;        ///< derivatives to xi, eta, zeta
};

/// Evaluates the shape functions; entries past node_count(type) are not written.
void evaluate_shape(VolumeType type, const Vec3& at, VolumeShape& shape);

/// Returns the reference coordinates of the element's nodes, in their order.
std::span<const Vec3> reference_nodes(VolumeType type);

/// Is a face as a surface element that looks out of the element, by its local nodes.
struct VolumeFace {
  ElementType type;
  std::array<int, 8> node;  ///< node_count(type) of them
};
/// Returns the faces in the order of docs/api.md. Tetrahedron: 012, 013, 123, 023. Wedge: bottom, top, then the sides
/// 01, 12, 20. Hexahedron: bottom, top, then the sides 01, 12, 23, 30. (The lists name corners; the node order within a
/// face is outward.)
std::span<const VolumeFace> faces_of(VolumeType type);

/// Returns the corners of the edges, in the order of their midside nodes.
std::span<const std::array<int, 2>> edges_of(VolumeType type);

struct VolumeRule {
  std::vector<Vec3> point;
  std::vector<double> w;
  std::size_t size() const { return w.size(); }
};
/// Exact for polynomials of total degree `degree` (hexahedra: in each variable; wedges: total in the triangle, and
/// along zeta). All points inside, all weights positive; as few points as known rules allow: tetrahedra 1, 4, 8, 14 up
/// to degree 1, 2, 3, 5, triangles of wedges 1, 3, 6 up to degree 1, 2, 4, symmetric in the corners;
/// collapsed product rules beyond. degree >= 0.
VolumeRule volume_rule(VolumeType type, int degree);

}  // namespace rollcon
