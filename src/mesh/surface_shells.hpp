#pragma once
/// Does the second half of check_surface: how elements are connected. Elements and nodes are sound already.

#include <span>
#include <vector>

#include "mesh/element_sides.hpp"

namespace rollcon {

/// Fails for edges of more than two elements, and for edges whose elements do not share the midside node.
void check_edges(const SurfaceMesh& mesh, std::span<const Side> sides);

/// Fails for edges of one element only.
void check_closed(const SurfaceMesh& mesh, std::span<const Side> sides);

/// Elements joined across edges: shell[e] (0, 1, ... by first element) and sign[e], +1 or -1, such that all elements of
/// a shell look to the same side once those of sign -1 are turned.
struct Shells {
  std::vector<std::int32_t> shell;
  std::vector<int> sign;
  std::vector<std::int64_t> first;  ///< first element of each shell

  std::size_t size() const { return first.size(); }
};
Shells find_shells(const SurfaceMesh& mesh, std::span<const Side> sides);

/// Fails for the smaller part of each shell that looks to the other side.
void check_neighbours(const SurfaceMesh& mesh, const Shells& shells);

/// Returns the volume that each shell encloses, with the sign of its first element's orientation. Fails for a shell
/// that encloses none.
std::vector<double> shell_volumes(const SurfaceMesh& mesh, const Shells& shells);

/// Checks that closed shells are one body, whose outer shell has outward normals and whose cavities have normals into
/// the cavity.
void check_outward(const SurfaceMesh& mesh, const Shells& shells);

}  // namespace rollcon
