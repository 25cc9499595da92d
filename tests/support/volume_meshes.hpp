#pragma once
/// Volume meshes of bodies for tests and benches: bricks, rings, cylinders, blocks with a fine zone, balls; every
/// element type, nodes 0-based, midside nodes on the true shape. Reproducible. Grids, tags and nodes on the surface are
/// those of surface_meshes.hpp.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "mesh/volume_mesh.hpp"
#include "mesh/volume_type.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::volumes {

inline constexpr std::array<VolumeType, 6> all_types{VolumeType::tet4,    VolumeType::tet10, VolumeType::wedge6,
                                                     VolumeType::wedge15, VolumeType::hex8,  VolumeType::hex20};
std::string name_of(VolumeType type);

/// surface: all nodes, and the boundary with its tags as surface elements; nodes inside the body belong to none of
/// them.
struct Mesh {
  SurfaceMesh surface;
  VolumeElements volume;
};

using surfaces::Block;
using surfaces::Map;

/// Hexahedra; wedges halve each in the plane of the first two coordinates, along diagonals that take turns; six
/// tetrahedra around the diagonal from the least to the most corner.
Mesh block(const Block& shape, VolumeType type);
/// Hexahedra and wedges by turns in the first two coordinates: hex8 and wedge6, or hex20 and wedge15.
Mesh mixed_block(const Block& shape, bool quadratic);

Vec3 mean_corner(const Mesh& mesh, std::int64_t element);

/// Material tag of every element from the mean of its corners.
Mesh with_materials(Mesh mesh, const std::function<std::int32_t(const Vec3&)>& tag);

/// Some elements on their own nodes, in the order of the whole; its surface has nodes only.
Mesh part_of(const Mesh& mesh, const std::function<bool(std::int64_t)>& wanted);

/// Moves nodes of a brick at random, those on its surface within the plane or line they lie in, by up to `fraction` of
/// their shortest edge: corner nodes first, midside nodes follow to the middle of their edge, then those too by a fifth
/// of it. Faces stay flat.
Mesh distort(Mesh mesh, double fraction, std::uint32_t seed);

/// Every node x -> map(x); the map must keep handedness.
Mesh transform(Mesh mesh, const Map& map);

/// Nodes and tags of surfaces::ring; its quad8, quad4 or tri6 nodes coincide with those of hex20, hex8 and, on the
/// inner and outer surface, wedge15. {.around = 42, .across = 12, .deep = 4} has 2016 hexahedra.
Mesh ring(const surfaces::Ring& shape, VolumeType type);
/// Tags and surface nodes of surfaces::zone_block.
Mesh zone_block(const surfaces::ZoneBlock& shape, VolumeType type);

/// Thick cylinder around the z axis, from 0 to `height`; full, or the sector [0, angle] from the x axis. Tags: 1 outer,
/// 2 inner surface, 3 bottom, 4 top, 5 the cut at angle 0, 6 the other one.
struct Cylinder {
  double inner = 1, outer = 2, height = 1;
  double angle = 0;  ///< 0: full
  int around = 16, along = 2, deep = 4;
  double first = 0;  ///< radial size of the innermost elements; 0: all equal
};
Mesh cylinder(const Cylinder& shape, VolumeType type);

/// Ball around the origin: a cube of n^3 elements, then `layers` to the sphere on each of its sides; or with `hollow` >
/// 0 the shell from there to `radius`, without the cube. An octant has x, y, z >= 0 and n elements along each of its
/// edges (else n along each edge of the whole cube). Tags: 1 outer sphere, 2 inner sphere, octant: 3, 4, 5 the planes x
/// = 0, y = 0, z = 0. Hexahedra and tetrahedra only.
struct Ball {
  double radius = 1;
  double core = 0.5;  ///< half diagonal of the cube over the radius
  double hollow = 0;  ///< radius of the cavity
  int n = 4, layers = 2;
  bool octant = false;
};
Mesh ball(const Ball& shape, VolumeType type);

/// [0, length] x [-width/2, width/2] x [-height/2, height/2] in n elements; tags as a brick's:
/// 1 the end x = 0, 2 the end x = length.
struct Beam {
  double length = 10, width = 1, height = 1;
  std::array<int, 3> n{20, 2, 2};
};
Mesh beam(const Beam& shape, VolumeType type);

/// Integral of the Jacobian over all elements; `least`: the smallest one at a point of the rule, over its element's
/// mean.
struct Filling {
  double volume = 0, least = 0;
  Vec3 centroid{0, 0, 0};
};
Filling filling(const Mesh& mesh);

}  // namespace rollcon::volumes
