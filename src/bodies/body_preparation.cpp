/// What preparing makes of a body with a mesh: checks, fans, search, equations.

#include <algorithm>
#include <map>
#include <utility>

#include "bodies/body_model.hpp"
#include "bodies/model/mesh_models.hpp"
#include "bodies/model/supports.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

// Nodes given for a tag may have held no whole face, or later calls given its faces another one.
void require_tagged_faces(const BodyMesh& mesh) {
  const std::vector<std::int32_t>& tags = mesh.surface.tag;
  const auto require = [&](std::int32_t tag, const char* what) {
    if (std::find(tags.begin(), tags.end(), tag) == tags.end())
      fail(Status::err_mesh,
           "tag %d, named by %s, is on no face of the body: of nodes a face counts when all of its "
           "own are given, midside nodes too, and later calls win over earlier ones",
           tag, what);
  };
  for (const FaceLoad& load : mesh.load)
    require(load.tag, "rollcon_body_set_traction or rollcon_body_set_pressure");
  for (const std::int32_t tag : mesh.contact_tag) require(tag, "rollcon_body_set_contact_faces");
}

// The half-space field between nodes, and first guesses, need one material.
void choose_contact_material(BodyModel& model) {
  const BodyMesh& mesh = model.mesh;
  std::map<std::int32_t, double> area;
  for (const std::int64_t e : contact_elements(mesh))
    area[mesh.volume
             .tag[static_cast<std::size_t>(mesh.origin[static_cast<std::size_t>(e)].element)]] +=
        element_area(mesh.surface, e);
  double most = 0;
  for (const auto& [tag, a] : area) {
    if (a <= most) continue;
    most = a;
    model.contact_material = model.material.at(tag);
  }
}

}  // namespace

void prepare_model(BodyModel& model, int threads, SectionReader* saved) {
  BodyMesh& mesh = model.mesh;
  const bool rigid = model.kind == BodyKind::rigid, volume = model.kind == BodyKind::fem;
  if (volume) {
    check_volume(mesh.surface.node, mesh.volume, mesh.surface.index_base);
    update_boundary(mesh);
    require_tagged_faces(mesh);
  }
  if (mesh.surface.elements() == 0) return;
  const SurfaceKind surface_kind = volume  ? SurfaceKind::boundary
                                   : rigid ? SurfaceKind::open
                                           : SurfaceKind::closed;
  check_surface(mesh.surface, surface_kind);
  // Held faces and free ones with the same tag carry tractions of their own.
  SurfaceMesh parts = mesh.surface;
  const std::vector<std::uint8_t> held = held_elements(mesh);
  std::map<std::pair<std::int32_t, std::uint8_t>, std::int32_t> part_number;
  for (std::size_t e = 0; e < parts.tag.size(); ++e)
    parts.tag[e] =
        part_number
            .try_emplace({parts.tag[e], held[e]}, static_cast<std::int32_t>(part_number.size()))
            .first->second;
  if (model.kind == BodyKind::bem)
    model.traction_nodes = split_at_edges(parts, model.options.edge_angle);
  std::fill(parts.tag.begin(), parts.tag.end(), 0);
  model.smooth_fans = split_at_edges(parts, model.options.edge_angle);
  model.search = std::make_unique<SurfaceSearch>(mesh.surface, contact_elements(mesh));
  if (rigid) return;
  require_supports(mesh);
  // Clamped plates under pressure lost two thirds of their deflection at a length of the elements
  // of 8 thicknesses (quadratic boundary elements), 17 (hex8) and 80 (hex20); of linear boundary
  // elements at one of 1.7.
  model.thin = volume ? thinness(mesh, 10, 30) : thinness(mesh, 2, 6);
  if (volume) {
    choose_contact_material(model);
    model.response =
        fem::make_response(mesh, model.smooth_fans, model.material, model.options, threads, saved);
    return;
  }
  refuse_incompressible_cavities(mesh, model.contact_material.poisson);
  model.response =
      bem::make_response(mesh, model.traction_nodes, model.contact_material.young,
                         model.contact_material.poisson, model.options, threads, saved);
}

}  // namespace rollcon
