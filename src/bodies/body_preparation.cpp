/// Prepares a body with a mesh: checks, fans, search, equations.

#include <algorithm>
#include <map>
#include <new>
#include <utility>

#include "bodies/body_model.hpp"
#include "bodies/model/supports.hpp"
#include "mesh/shape.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/error.hpp"
#include "support/memory_limit.hpp"

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
  for (const FaceLoad& load : mesh.load) require(load.tag, "rollcon_body_set_traction or rollcon_body_set_pressure");
  for (const Spring& spring : mesh.spring) require(spring.tag, "rollcon_body_set_springs");
  for (const BodyForce& load : mesh.body_force)
    if (std::find(mesh.volume.tag.begin(), mesh.volume.tag.end(), load.tag) == mesh.volume.tag.end())
      fail(Status::err_state, "no element has the tag %d that rollcon_body_set_body_force or _set_rotation was given",
           load.tag);
  for (const std::int32_t tag : mesh.contact_tag) require(tag, "rollcon_body_set_contact_faces");
}

// Tractions by node act on faces of their tag, and the direction that they are told along has a part in each.
void require_node_tractions(const BodyMesh& mesh) {
  constexpr double least = 1e-6;
  const SurfaceMesh& surface = mesh.surface;
  for (const FaceLoad& load : mesh.load) {
    if (load.node.empty()) continue;
    std::vector<std::uint8_t> there(surface.node.size(), 0);
    for (std::int64_t e = 0; e < surface.elements(); ++e) {
      if (surface.tag[static_cast<std::size_t>(e)] != load.tag) continue;
      const auto at_nodes = reference_nodes(surface.type[static_cast<std::size_t>(e)]);
      for (std::size_t k = 0; k < surface.element(e).size(); ++k) {
        there[static_cast<std::size_t>(surface.element(e)[k])] = 1;
        if (load.along != Vec3{0, 0, 0} &&
            length(cross(load.along, unit_normal(surface, e, at_nodes[k].xi, at_nodes[k].eta))) < least)
          fail(Status::err_mesh,
               "tractions by node on faces with tag %d are told along a direction that is normal to %s: give its faces "
               "a tag of their own and another direction",
               load.tag, face_name(mesh, e).c_str());
      }
    }
    for (const std::int32_t node : load.node)
      if (there[static_cast<std::size_t>(node)] == 0)
        fail(Status::err_mesh, "node %d (counting from %d) has a traction for tag %d, but is on no face with that tag",
             node + surface.index_base, surface.index_base, load.tag);
  }
}

// The half-space field between nodes, and first guesses, need one material.
void choose_contact_material(BodyModel& model) {
  const BodyMesh& mesh = model.mesh;
  std::map<std::int32_t, double> area;
  const auto tag = [&](std::int64_t e) {
    if (mesh.section.swept()) return mesh.section.plane().tag[static_cast<std::size_t>(mesh.section.element_under(e))];
    return mesh.volume.tag[static_cast<std::size_t>(mesh.origin[static_cast<std::size_t>(e)].element)];
  };
  for (const std::int64_t e : contact_elements(mesh)) area[tag(e)] += element_area(mesh.surface, e);
  double most = 0;
  for (const auto& [tag, a] : area) {
    if (a <= most) continue;
    most = a;
    model.contact_material = model.material.at(tag);
    model.contact_tag = tag;
  }
}

}  // namespace

void prepare_model(BodyModel& model, int threads, const EquationSource& from) {
  BodyMesh& mesh = model.mesh;
  const BodyTraits& traits = model.traits();
  if (traits.volume) {
    check_volume(mesh.surface.node, mesh.volume, mesh.surface.index_base);
    update_boundary(mesh);
    require_tagged_faces(mesh);
  }
  if (traits.section) sweep_section(mesh, model.options.stations);
  if (mesh.surface.elements() == 0) return;
  check_surface(mesh.surface, traits.surface);
  require_node_tractions(mesh);

  // Held faces and free ones with the same tag carry tractions of their own.
  SurfaceMesh parts = mesh.surface;
  const std::vector<std::uint8_t> held = held_elements(mesh);
  std::map<std::pair<std::int32_t, std::uint8_t>, std::int32_t> part_number;
  for (std::size_t e = 0; e < parts.tag.size(); ++e)
    parts.tag[e] =
        part_number.try_emplace({parts.tag[e], held[e]}, static_cast<std::int32_t>(part_number.size())).first->second;
  if (traits.surface == SurfaceKind::closed) model.traction_nodes = split_at_edges(parts, model.options.edge_angle);
  std::fill(parts.tag.begin(), parts.tag.end(), 0);
  model.smooth_fans = split_at_edges(parts, model.options.edge_angle);
  model.search = std::make_unique<SurfaceSearch>(mesh.surface, contact_elements(mesh));
  model.surface = std::make_unique<MeshSurface>(mesh.surface, model.smooth_fans, *model.search);
  if (!traits.make_response) return;

  if (traits.filled()) choose_contact_material(model);
  if (!traits.section && !traits.given) {
    require_supports(mesh);
    model.thin = thinness(mesh, traits.thin_linear, traits.thin_quadratic);
  }
  try {
    if (const std::shared_ptr<BodyModel>& base = from.unlike_loads) {
      model.own = base->response->solve_loads(mesh, threads);
      model.response = {base, base->response.get()};  // it refers to the mesh of the other
    } else {
      model.response = traits.make_response(model, threads, from.saved);
      model.own = model.response->own();
    }
  } catch (const std::bad_alloc&) {
    refuse_more_memory(0, "take a coarser mesh", "the body of %lld nodes needs",
                       static_cast<long long>(mesh.surface.nodes()));
  }
}

}  // namespace rollcon
