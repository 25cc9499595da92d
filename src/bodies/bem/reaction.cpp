/// The reactions of a boundary-element body's supports.

#include <algorithm>
#include <vector>

#include "bodies/bem/system.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon::bem {
namespace {

/// Tractions that supports exert, by node of element e: what is there beyond the given ones. (That
/// of a node held alone is spread over its neighbours, which are not held.)
std::vector<Vec3> support_tractions(const BodyMesh& mesh, const TractionNodes& split,
                                    std::int64_t e, std::span<const double> traction) {
  const auto element = static_cast<std::size_t>(e);
  const auto load = std::find_if(
      mesh.load.begin(), mesh.load.end(),
      [&](const FaceLoad& candidate) { return candidate.tag == mesh.surface.tag[element]; });
  const auto nodes = mesh.surface.element(e);
  const auto first = static_cast<std::size_t>(mesh.surface.offset[element]);
  std::vector<Vec3> result(nodes.size(), Vec3{0, 0, 0});
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto at = static_cast<std::size_t>(split.of[first + k]);
    Vec3 given{0, 0, 0};
    if (load != mesh.load.end()) given = load->traction - load->pressure * split.normal[at];
    for (std::size_t c = 0; c < 3; ++c) result[k][c] = traction[3 * at + c] - given[c];
  }
  return result;
}

}  // namespace

Resultant System::support_reaction() const {
  Resultant sum;
  if (own_traction_.empty()) return sum;
  // Exact for plane elements; on curved ones the Jacobian is not a polynomial.
  constexpr int degree = 9;
  const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  Shape shape;
  for (std::int64_t e = 0; e < surface_.elements(); ++e) {
    const ElementType type = surface_.type[static_cast<std::size_t>(e)];
    const std::vector<Vec3> traction = support_tractions(mesh_, fans_, e, own_traction_);
    const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
      const SurfaceFrame at = evaluate_surface(surface_, e, rule.xi[q], rule.eta[q]);
      Vec3 t{0, 0, 0};
      for (std::size_t k = 0; k < traction.size(); ++k) t = t + shape.value[k] * traction[k];
      const Vec3 part = rule.w[q] * length(at.normal) * t;
      sum.force = sum.force + part;
      sum.moment = sum.moment + cross(at.x, part);
    }
  }
  return sum;
}

}  // namespace rollcon::bem
