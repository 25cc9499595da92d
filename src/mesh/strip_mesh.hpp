#pragma once
/// Makes meshes of strips: what users see of them, and frames' nodes.

#include "mesh/frame.hpp"

namespace rollcon::strips {

/// Makes quadrilaterals between rows, and triangles beside the ends of the widths; all nodes lie at the origin. Fills
/// in strips.node.
SurfaceMesh strip_mesh(StripFrame& strips);
/// Puts the nodes of strip_mesh() in place, in the plane of the axes.
void put_nodes(const StripFrame& strips, const Axes& axes, std::vector<Vec3>& node);
/// Puts a frame with strips, whose nodes in space are known, where these are: coordinates, weights and areas.
void put_frame(Frame& frame);

}  // namespace rollcon::strips
