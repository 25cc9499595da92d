#pragma once
/// Lays a contact frame on the surface of a body: its elements are faces of the body, or a mesh of their own.

#include <cstdint>
#include <vector>

#include "bodies/contact_surface.hpp"

namespace rollcon {

struct FrameOnBody : LoadedSurface {
  std::vector<std::int32_t> node;  ///< the body's node at each frame node; -1: none
};

/// Projects the frame along its axes' normal. Throws err_mesh naming the frame nodes that have no contact face of the
/// body above or below them, and err_state when the frame lies on held faces.
FrameOnBody lay_on_body(const Frame& frame, const Body& body, const Pose& pose, int which);

}  // namespace rollcon
