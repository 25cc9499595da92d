#pragma once
/// What the caller gave for a body with a mesh; ids and numbers checked, shapes not yet.

#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

struct FaceLoad {
  std::int32_t tag = 0;
  Vec3 traction{0, 0, 0};  ///< in the body's axes
  double pressure = 0;     ///< against the outward normal, added to the traction
};

struct BodyMesh {
  SurfaceMesh surface;  ///< outward normals by the right-hand rule
  std::vector<std::uint8_t>
      held;                      ///< per node: bit c is set when displacement component c is given
  std::vector<Vec3> held_value;  ///< per node, in the body's axes
  std::vector<FaceLoad> load;    ///< one per tag at most
  /// Tags of faces that may come into contact; empty: all faces that are neither held nor loaded.
  std::vector<std::int32_t> contact_tag;
};

struct BodyOptions {
  double accuracy = 1e-6;  ///< "accuracy": of the boundary integrals
  double edge_angle = 40;  ///< "edge_angle", degrees: beyond it an edge separates faces
  std::int64_t keep_factors =
      1;  ///< "keep_factors": 0 frees the factors once a frame has its compliance
};

/// Held components common to all nodes of each element: bit c.
std::vector<std::uint8_t> held_elements(const BodyMesh& mesh);

/// Elements that may come into contact, ascending.
std::vector<std::int64_t> contact_elements(const BodyMesh& mesh);

}  // namespace rollcon
