#pragma once
/// Tells whether enough nodes touch for a solution to mean anything (docs/theory.md, section 8).

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "support/line.hpp"

namespace rollcon {

struct Solution;

/// Counts nodes in contact without an open node in any of their elements: the contact's extent is known to one element,
/// so that all others are its edge.
std::int64_t nodes_inside(const Solution& state);
/// Counts nodes inside a mesh's contact, those whose normal traction is negative being in contact; `node` is workspace.
/// inner: 0 for nodes on an outline that is the contact's; null: the contact ends where nodes are open.
std::int64_t nodes_inside(const SurfaceMesh& mesh, const std::vector<double>& normal, std::vector<std::uint8_t>& node,
                          const std::uint8_t* inner = nullptr);

/// Says whether the contact has no inside, or with friction not enough of it.
bool too_few_nodes(const Solution& state);

/// Says how many touch, what that means and what to do about it.
Line describe_few_nodes(const Solution& state);

}  // namespace rollcon
