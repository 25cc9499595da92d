#pragma once
/// Tells which faces of a body with elements feel tractions on a layer, and as what.

#include <functional>

#include "bodies/model/body_mesh.hpp"
#include "bodies/model/felt_tractions.hpp"

namespace rollcon {

struct FeelingBody {
  const BodyMesh& mesh;
  const TractionNodes& fans;                      ///< fans of the smooth surface
  std::function<Elastic(std::int64_t)> material;  ///< constants behind a face of the surface
};

/// Returns what the body's faces feel, and notes the faces in the outline. as_tractions: always with tractions, also
/// where the faces' own shape functions can give those of the layer.
FeltTractions feel(const FeelingBody& body, const SurfaceMesh& layer, SurfaceOutline& outline, bool as_tractions);

}  // namespace rollcon
