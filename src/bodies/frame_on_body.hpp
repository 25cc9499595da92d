#pragma once
/// How a contact frame lies on the surface of a body: its elements are faces of the body, or a mesh
/// of their own.

#include <cstdint>
#include <vector>

#include "bodies/contact_surface.hpp"

namespace rollcon {

struct FrameOnBody {
  /// The frame's elements are these faces of the body (ascending); empty: it is a mesh of its own.
  std::vector<std::int64_t> face;
  std::vector<std::int32_t> node;  ///< the body's node at each frame node; -1: none
  /// Otherwise: the frame on the body's surface, in the body's coordinates, and the body's nodes
  /// whose displacements are needed (those of the elements under the frame and their neighbours).
  SurfaceMesh layer;
  std::vector<std::int32_t> row;

  bool matches() const { return !face.empty(); }
};

/// Projects the frame along its axes' normal. Throws err_mesh naming the frame nodes that have no
/// contact face of the body above or below them, and err_state when the frame lies on held faces.
FrameOnBody lay_on_body(const Frame& frame, const Body& body, const Pose& pose, int which);

}  // namespace rollcon
