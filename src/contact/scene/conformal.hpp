#pragma once
/// Makes frames follow profiles across the rolling direction, for half-spaces whose normals turn within their contact.

#include "bodies/contact_surface.hpp"
#include "contact/scene/scene.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Says whether conformal frames are asked for, with profiles to follow and no mesh that does so by itself.
bool is_conformal(const Scene& scene, const PairOfBodies& pair);

/// Lifts the nodes onto the surface between both bodies, a section through the axes' origin moved along the rolling
/// direction, gives them its normals, and the frame its section. The surface lies nearer to the stiffer body, as the
/// interface of the deformed bodies does. Throws err_mesh where curve_frame() does.
void follow_section(Frame& frame, const PairOfBodies& pair);

}  // namespace rollcon
