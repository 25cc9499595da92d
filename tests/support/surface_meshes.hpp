#pragma once
/// Makes closed surface meshes of bodies for tests and benches: bricks, spheres, rings, wheels, blocks with a fine
/// zone; every element type, nodes 0-based, normals outwards, all reproducible.

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon::surfaces {

inline constexpr std::array<ElementType, 5> all_types{ElementType::tri3, ElementType::tri6, ElementType::quad4,
                                                      ElementType::quad8, ElementType::quad9};
std::string name_of(ElementType type);

using Map = std::function<Vec3(const Vec3&)>;

inline std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// Adds an element on nodes of the mesh.
void add_element(SurfaceMesh& mesh, ElementType type, std::span<const std::int32_t> nodes, std::int32_t tag = 0);
inline void add_element(SurfaceMesh& mesh, ElementType type, std::initializer_list<std::int32_t> nodes,
                        std::int32_t tag = 0) {
  add_element(mesh, type, std::span(nodes.begin(), nodes.size()), tag);
}
/// Makes a mesh of one element on its own nodes.
SurfaceMesh one_element(ElementType type, std::vector<Vec3> nodes);
/// Makes the reference element under a map.
SurfaceMesh one_element(ElementType type, const Map& map);

/// Returns n + 1 lines from a to b, the first step of size `first`, the others growing by one factor but not beyond
/// `largest` (0: no bound).
std::vector<double> graded(int n, double a, double b, double first, double largest = 0);
/// Returns graded lines from a to b that are fine at b, in ascending order.
std::vector<double> graded_to(int n, double a, double b, double last, double largest = 0);

/// Describes the surface of a block divided by lines along its three coordinates, bent by a right-handed map.
struct Block {
  std::array<std::vector<double>, 3> line;
  bool ring = false;                                  ///< the first coordinate runs full circle
  std::array<std::int32_t, 6> tag{1, 2, 3, 4, 5, 6};  ///< tags of first least, first most, second least...
  std::array<int, 2> zone_from{0, 0}, zone_to{0, 0};  ///< elements of the last face that have zone_tag
  std::int32_t zone_tag = 0;                          ///< tag of those elements
  Map map;                                            ///< map; none: unbent
};

/// Makes the block; triangles halve the quadrilaterals. All nodes lie on the mapped surface.
SurfaceMesh block(const Block& shape, ElementType type);
/// Makes a block of triangles and quadrilaterals by turns: tri3 with quad4, or tri6 with quad8 and quad9.
SurfaceMesh mixed_block(const Block& shape, bool quadratic);

/// Makes a brick [0, size] in n elements; tags 1 to 6 are x = 0, x = size, y = 0, ...
Block brick(const std::array<int, 3>& n, const Vec3& size);
/// Moves every node of a brick at random within the plane or line that it lies in, by up to `fraction` of its shortest
/// edge: corner nodes first, other nodes follow, then those too by a fifth of it. Faces stay flat.
SurfaceMesh distort(SurfaceMesh mesh, double fraction, std::uint32_t seed);

/// Does what distort does to nodes: `edge` is the shortest edge of each; `follow` puts the others between the corners.
void shake(std::vector<Vec3>& node, std::span<const double> edge, std::span<const std::uint8_t> corner, double fraction,
           std::uint32_t seed, const std::function<void()>& follow);

/// Bends cubes to a sphere around the origin, of 6 n^2 quadrilaterals or twice as many triangles.
SurfaceMesh cube_sphere(ElementType type, int n, double radius, std::int32_t tag = 1);
/// Makes a sphere of tri3 or tri6 from an icosahedron, every edge cut into n.
SurfaceMesh icosphere(ElementType type, int n, double radius, std::int32_t tag = 1);
/// Makes the body between two closed surfaces: the inner one is turned inside out.
SurfaceMesh with_cavity(SurfaceMesh outer, SurfaceMesh inner);

/// Describes the ring of examples/ring_mesh.h, whose shape this repeats, tags included, with any element type.
struct Ring {
  double inner = 25, outer = 50, width = 8;
  double sector = 0, zone = 2.4;
  int around = 46, zone_around = 12, across = 12, deep = 4;
  double largest = 16, top_layer = 1.2, side_grading = 0;
};
SurfaceMesh ring(const Ring& shape, ElementType type);
/// Returns the ring as a block.
Block ring_block(const Ring& shape);
/// Makes the wheel of examples/wheel_mesh.h with its standard shape and counts.
SurfaceMesh wheel(double crown, ElementType type);

/// Describes a block [-side/2, side/2]^2 x [-depth, 0] with a fine zone of n x n elements, [-zone/2, zone/2]^2, in the
/// middle of its top; `grade` elements from there to each side, `deep` downwards. Tags: 1 top outside the zone, 2 zone,
/// 3 bottom, 4 to 7 the sides at least x, most x, least y, most y.
struct ZoneBlock {
  double side = 1, depth = 1, zone = 0.1;
  int n = 8, grade = 4, deep = 4;
};
SurfaceMesh zone_block(const ZoneBlock& shape, ElementType type);
Block with_zone(const ZoneBlock& shape);

/// Moves every node x to map(x); the map must keep handedness.
SurfaceMesh transform(SurfaceMesh mesh, const Map& map);
/// Returns the surface seen from the other side.
SurfaceMesh turn_inside_out(SurfaceMesh mesh);

/// Returns the nodes of the elements with one of these tags, ascending.
std::vector<std::int32_t> nodes_with_tag(const SurfaceMesh& mesh, std::span<const std::int32_t> tags);
std::vector<std::int32_t> nodes_where(const SurfaceMesh& mesh, const std::function<bool(const Vec3&)>& wanted);
/// Returns the node nearest to a point.
std::int32_t node_at(const SurfaceMesh& mesh, const Vec3& x);
std::vector<std::int64_t> elements_with_tag(const SurfaceMesh& mesh, std::int32_t tag);

/// Returns some elements as a mesh of their own; `node` holds their nodes' numbers in the whole.
SurfaceMesh part_of(const SurfaceMesh& mesh, std::span<const std::int64_t> elements, std::vector<std::int32_t>& node);
SurfaceMesh part_with_tag(const SurfaceMesh& mesh, std::int32_t tag);
/// Returns some elements on the nodes of all.
SurfaceMesh only(const SurfaceMesh& mesh, const std::function<bool(std::int64_t)>& wanted);

/// Integrates the shape functions over the surface, by node.
std::vector<double> nodal_areas(const SurfaceMesh& mesh);

/// Measures what a mesh encloses, by quadrature on its own elements.
struct Facts {
  double area = 0, volume = 0;
  Vec3 centroid{0, 0, 0};           ///< centroid of the volume
  std::int64_t euler = 0;           ///< corners - edges + elements: 2 sphere, 0 torus, 4 shell
  std::int64_t open_edges = 0;      ///< edges of one element
  std::int64_t clashing_edges = 0;  ///< edges run through twice in the same direction
  std::int64_t unused_nodes = 0, triangles = 0, quadrilaterals = 0;
};
Facts facts(const SurfaceMesh& mesh);

}  // namespace rollcon::surfaces
