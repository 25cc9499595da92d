#pragma once
/// Makes frames and bodies of any element size for work-precision studies.

#include <string>
#include <vector>

#include "support/frames.hpp"
#include "support/scene.hpp"
#include "support/surface_meshes.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon::bench {

/// Describes frames over an elliptic contact: grids of one element type, or triangles in rings graded to the contact's
/// edge.
struct FrameKind {
  const char* name;
  ElementType type;
  bool rings;
};
inline constexpr FrameKind frame_kinds[] = {
    {"quad4", ElementType::quad4, false},    {"tri3", ElementType::tri3, false},
    {"quad8", ElementType::quad8, false},    {"tri6", ElementType::tri6, false},
    {"tri3 rings", ElementType::tri3, true}, {"tri6 rings", ElementType::tri6, true}};

/// Makes a frame with `across` nodes from edge to edge of the contact with semi-axes a, b (nearly so in graded rings);
/// a grid reaches `reach` times as far. The number `across` is even, for quadratic rings a multiple of 4.
SurfaceMesh frame_over(const FrameKind& kind, int across, double a, double b, double reach);

/// Describes a kind of element of a body, by boundary or by finite elements.
struct BodyKind {
  std::string name;
  bool volume, quadratic;
  ElementType surface_type;
  VolumeType volume_type;
};
std::vector<BodyKind> boundary_elements();
std::vector<BodyKind> finite_elements();

/// Makes the surface or volume of a block.
scenes::MeshedBody meshed_block(const surfaces::Block& shape, const BodyKind& kind, const scenes::Elastic& material);
scenes::MeshedBody meshed_ring(const surfaces::Ring& shape, const BodyKind& kind, const scenes::Elastic& material);
/// Makes the paper's ring with parts x parts elements in a zone of this length; the rest refines with it, for finite
/// elements below the zone as well. The number of parts is odd or even.
surfaces::Ring ring_shape(double zone, int parts, bool volume);
scenes::MeshedBody meshed_zone_block(const surfaces::ZoneBlock& shape, const BodyKind& kind,
                                     const scenes::Elastic& material);

/// Makes a frame of quad4 graded to the edges of a contact of half-width a along x and from side to side: `lines`
/// elements along, half as many across, around the origin.
SurfaceMesh graded_strip(double a, double width, int lines);

/// Returns `parts` equal elements in [-half, half], `beyond` more on either side to `end`, growing.
std::vector<double> lines_with_zone(double half, int parts, int beyond, double end);

}  // namespace rollcon::bench
