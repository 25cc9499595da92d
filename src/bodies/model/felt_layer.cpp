#include "bodies/model/felt_layer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/surface_search.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Lists reference coordinates of a point inside every element.
constexpr double middle = 1.0 / 3;

/// The half-space that takes what is smoothed away is deep: less is left to it where the body is thinner than its faces
/// are wide, nothing below a third of that.
void limit_by_thickness(const SurfaceMesh& surface, const std::vector<std::int64_t>& face, std::vector<double>& share) {
  constexpr double none = 1.0 / 3;
  if (std::all_of(share.begin(), share.end(), [](double s) { return s == 0; })) return;
  const SurfaceSearch all(surface, {});
  for (std::size_t f = 0; f < face.size(); ++f) {
    if (share[f] == 0) continue;
    const SurfaceFrame there = evaluate_surface(surface, face[f], middle, middle);
    const Vec3 inward = -1.0 * normalized(there.normal);
    const auto opposite = all.along(there.x, inward, inward);
    if (!opposite) continue;
    const double thickness = std::abs(opposite->distance) / std::sqrt(element_area(surface, face[f]));
    share[f] *= std::clamp((thickness - none) / (1 - none), 0.0, 1.0);
  }
}

// The half-space under a layer has the material of most of the faces that feel it.
void choose_material(const FeelingBody& body, SurfaceOutline& rows) {
  std::map<std::pair<double, double>, double> area;
  double most = 0;
  for (const std::int64_t e : rows.seen_face) {
    const Elastic m = body.material(e);
    double& sum = area[{m.young, m.poisson}];
    sum += element_area(body.mesh.surface, e);
    if (sum <= most) continue;
    most = sum;
    rows.young = m.young;
    rows.poisson = m.poisson;
  }
}

// Finds faces that feel a layer, as all of their nodes do (or a node that does in no other one), and the faces around
// them on the same smooth surface whose displacements are known.
std::vector<std::int64_t> feeling_faces(const FeelingBody& body, const SurfaceCoupling& coupling,
                                        const SurfaceOutline& rows, const std::vector<std::int64_t>& candidates) {
  const SurfaceMesh& surface = body.mesh.surface;
  std::vector<std::uint8_t> known(at(surface.nodes()), 0), fan(at(body.fans.size()), 0);
  const auto all_marked = [&](std::int64_t e) {
    const auto nodes = surface.element(e);
    return std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t k) { return known[at(k)] != 0; });
  };
  const auto fans_of = [&](std::int64_t e) {
    return std::span(body.fans.of).subspan(at(surface.offset[at(e)]), surface.element(e).size());
  };
  std::vector<std::int64_t> face;
  for (const std::int32_t k : coupling.node) known[at(k)] = 1;
  const auto feels = [&](std::int64_t e) {
    face.push_back(e);
    for (const std::int32_t f : fans_of(e)) fan[at(f)] = 1;
  };
  for (const std::int64_t e : candidates)
    if (all_marked(e)) feels(e);
  std::vector<std::uint8_t> alone = known;
  for (const std::int64_t e : face)
    for (const std::int32_t k : surface.element(e)) alone[at(k)] = 0;
  for (const std::int32_t k : rows.row) known[at(k)] = 1;
  // A layer in the corner of a face is felt by that corner's nodes alone.
  std::vector<std::uint8_t> missed = alone;
  for (const std::int64_t e : candidates) {
    const auto nodes = surface.element(e);
    if (!all_marked(e) || std::none_of(nodes.begin(), nodes.end(), [&](std::int32_t k) { return alone[at(k)] != 0; }))
      continue;
    feels(e);
    for (const std::int32_t k : nodes) missed[at(k)] = 0;
  }
  if (const auto k = std::find(missed.begin(), missed.end(), 1); k != missed.end())
    fail(Status::err_mesh, "node %lld (counting from %d) of the body feels the frame, but no face around it does",
         static_cast<long long>(k - missed.begin()) + surface.index_base, surface.index_base);
  std::sort(face.begin(), face.end());
  const std::size_t under = face.size();
  for (const std::int64_t e : candidates) {
    if (!all_marked(e) || std::binary_search(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(under), e))
      continue;
    const auto own = fans_of(e);
    const bool around = std::any_of(own.begin(), own.end(), [&](std::int32_t f) { return fan[at(f)] != 0; });
    if (around) face.push_back(e);
  }
  std::sort(face.begin(), face.end());
  return face;
}

}  // namespace

FeltTractions feel(const FeelingBody& body, const SurfaceMesh& layer, SurfaceOutline& outline, bool as_tractions) {
  const SurfaceMesh& surface = body.mesh.surface;
  Vec3 normal{0, 0, 0};
  for (std::int64_t e = 0; e < layer.elements(); ++e)
    normal = normal + element_area(layer, e) * unit_normal(layer, e, middle, middle);
  const std::vector<std::int64_t> candidates = contact_elements_facing(body.mesh, normalized(normal));
  const SurfaceCoupling coupling = couple_layer(surface, candidates, layer);
  // Nothing of such tractions is left to a half-space.
  if (coupling.in_faces && !as_tractions) return {coupling.node, {}, columns_of(coupling, outline.column)};
  outline.seen_face = feeling_faces(body, coupling, outline, candidates);
  choose_material(body, outline);
  std::vector<double> share(outline.seen_face.size(), 0.0);
  if (!coupling.in_faces) {
    share = smoothing_shares(surface, body.fans, outline.seen_face, coupling);
    limit_by_thickness(surface, outline.seen_face, share);
  }
  return felt_tractions(surface, outline.seen_face, share, coupling, outline.column);
}

}  // namespace rollcon
