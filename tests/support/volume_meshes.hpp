#pragma once
/// Makes volume meshes of bodies for tests and benches: blocks, rings, blocks with a fine zone; every element type,
/// nodes 0-based, midside nodes on the true shape, all reproducible. Grids, tags and nodes on the surface are those of
/// surface_meshes.hpp.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mesh/volume_mesh.hpp"
#include "mesh/volume_type.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::volumes {

inline constexpr std::array<VolumeType, 6> all_types{VolumeType::tet4,    VolumeType::tet10, VolumeType::wedge6,
                                                     VolumeType::wedge15, VolumeType::hex8,  VolumeType::hex20};
std::string name_of(VolumeType type);

/// Holds in `surface` all nodes, and the boundary with its tags as surface elements; nodes inside the body belong to
/// none of them.
struct Mesh {
  SurfaceMesh surface;
  VolumeElements volume;
};

using surfaces::Block;
using surfaces::Map;

/// Adds an element on nodes of the mesh.
void add_element(VolumeElements& volume, VolumeType type, std::span<const std::int32_t> nodes, std::int32_t tag = 0);

/// Makes a block of hexahedra; wedges halve each in the plane of the first two coordinates, along diagonals that take
/// turns; six tetrahedra lie around the diagonal from the least to the most corner.
Mesh block(const Block& shape, VolumeType type);
/// Makes a block of hexahedra and wedges by turns in the first two coordinates: hex8 and wedge6, or hex20 and wedge15.
Mesh mixed_block(const Block& shape, bool quadratic);

Vec3 mean_corner(const Mesh& mesh, std::int64_t element);

/// Sets the material tag of every element from the mean of its corners.
Mesh with_materials(Mesh mesh, const std::function<std::int32_t(const Vec3&)>& tag);

/// Returns some elements on their own nodes, in the order of the whole; its surface has nodes only.
Mesh part_of(const Mesh& mesh, const std::function<bool(std::int64_t)>& wanted);

/// Moves nodes of a brick at random, those on its surface within the plane or line they lie in, by up to `fraction` of
/// their shortest edge: corner nodes first, midside nodes follow to the middle of their edge, then those too by a fifth
/// of it. Faces stay flat.
Mesh distort(Mesh mesh, double fraction, std::uint32_t seed);

/// Moves every node x to map(x); the map must keep handedness.
Mesh transform(Mesh mesh, const Map& map);

/// Makes a ring with nodes and tags of surfaces::ring; its quad8, quad4 or tri6 nodes coincide with those of hex20,
/// hex8 and, on the inner and outer surface, wedge15. {.around = 42, .across = 12, .deep = 4} has 2016 hexahedra.
Mesh ring(const surfaces::Ring& shape, VolumeType type);
/// Makes a block with the tags and surface nodes of surfaces::zone_block.
Mesh zone_block(const surfaces::ZoneBlock& shape, VolumeType type);

/// Integrates the Jacobian over all elements; `least` is the smallest one at a point of the rule, over its element's
/// mean.
struct Filling {
  double volume = 0, least = 0;
  Vec3 centroid{0, 0, 0};
};
Filling filling(const Mesh& mesh);

}  // namespace rollcon::volumes
