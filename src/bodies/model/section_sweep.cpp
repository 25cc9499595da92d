/// Sweeps the surface of a body that is given by its section.

#include <algorithm>
#include <utility>

#include "bodies/model/body_mesh.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::uint8_t all_components = 7;

void name_edges(const BodyMesh& mesh, SweptSection& section) {
  for (const FaceNaming& naming : mesh.naming) {
    std::vector<std::uint8_t> named(mesh.surface.node.size(), 0);
    for (const std::int32_t k : naming.nodes) named[at(k)] = 1;
    for (const BoundaryFace& face : naming.face) {
      const auto found = std::find_if(section.edges().begin(), section.edges().end(), [&](const SectionEdge& e) {
        return e.element == face.element && e.side == face.side;
      });
      const std::int32_t base = mesh.surface.index_base;
      if (found == section.edges().end())
        fail(
            Status::err_mesh,
            "side %d of element %lld (both counting from %d), which was given tag %d, is not on the section's boundary",
            face.side + base, static_cast<long long>(face.element) + base, base, naming.tag);
      found->tag = naming.tag;
    }
    for (SectionEdge& e : section.edges())
      if (std::all_of(e.node.begin(), e.node.end(), [&](std::int32_t k) { return k < 0 || named[at(k)] != 0; }))
        e.tag = naming.tag;
  }
}

void require_tagged_edges(const BodyMesh& mesh, const SweptSection& section) {
  const auto require = [&](std::int32_t tag, const char* what) {
    if (std::none_of(section.edges().begin(), section.edges().end(),
                     [&](const SectionEdge& e) { return e.tag == tag; }))
      fail(Status::err_mesh, "tag %d, named by %s, is on no edge of the section's boundary", tag, what);
  };
  for (const FaceLoad& load : mesh.load) require(load.tag, "rollcon_body_set_traction or rollcon_body_set_pressure");
  for (const Spring& spring : mesh.spring) require(spring.tag, "rollcon_body_set_springs");
  for (const std::int32_t tag : mesh.contact_tag) require(tag, "rollcon_body_set_contact_faces");
}

// Loads are harmonic n = 0: what is not the same all along the way is refused.
void require_steady_loads(const BodyMesh& mesh, const SweptSection& section) {
  constexpr double rounding = 1e-9;
  const Vec3& a = mesh.path.axis;
  const auto aside = [&](const Vec3& v) { return length(v - dot(v, a) * a) > rounding * length(v); };
  for (const BodyForce& load : mesh.body_force) {
    if (std::find(mesh.surface.tag.begin(), mesh.surface.tag.end(), load.tag) == mesh.surface.tag.end())
      fail(Status::err_state, "no element has the tag %d that rollcon_body_set_body_force or _set_rotation was given",
           load.tag);
    if ((section.revolved() && aside(load.force)) || (load.density > 0 && aside(load.rate)) ||
        (section.revolved() && load.density > 0 && aside(load.origin - mesh.path.origin)))
      fail(
          Status::err_unsupported,
          "the force inside elements with tag %d changes along the way that the section is carried: allowed are forces "
          "along the axis of a revolved one and rotations about its axis",
          load.tag);
  }
  for (const FaceLoad& load : mesh.load)
    if (!load.node.empty())
      fail(Status::err_unsupported, "tractions by node do not act on a section; tag %d was given some", load.tag);
}

}  // namespace

void sweep_section(BodyMesh& mesh, std::int64_t stations) {
  if (mesh.section.swept()) return;
  if (mesh.path.sweep == Sweep::none)
    fail(Status::err_state, "the section has no way: rollcon_body_revolve or rollcon_body_extrude was not called");
  SweptSection section(mesh.surface, mesh.path);
  name_edges(mesh, section);
  require_tagged_edges(mesh, section);
  require_steady_loads(mesh, section);
  std::vector<std::size_t> chosen, all;
  for (std::size_t i = 0; i < section.edges().size(); ++i) {
    const SectionEdge& e = section.edges()[i];
    if (section.meets_axis(e)) {
      if (std::count(mesh.contact_tag.begin(), mesh.contact_tag.end(), e.tag) == 0) continue;
      fail(Status::err_mesh, "an edge with tag %d, named by rollcon_body_set_contact_faces, ends on the axis", e.tag);
    }
    all.push_back(i);
    const auto has = [&](std::int32_t tag) { return tag == e.tag; };
    const bool held = std::all_of(e.node.begin(), e.node.end(),
                                  [&](std::int32_t k) { return k < 0 || mesh.held[at(k)] == all_components; });
    if (mesh.contact_tag.empty() ? !held && !mesh.taken(e.tag)
                                 : std::any_of(mesh.contact_tag.begin(), mesh.contact_tag.end(), has))
      chosen.push_back(i);
  }
  SurfaceMesh surface = section.sweep(chosen.empty() ? all : chosen, stations);
  std::vector<std::uint8_t> held;
  for (std::int64_t k = 0; k < section.surface_stations(); ++k)
    for (const std::int32_t node : section.profile())
      held.push_back(mesh.held[at(node)] == all_components ? all_components : 0);
  mesh.given_held = std::exchange(mesh.held, std::move(held));
  mesh.given_value = std::exchange(mesh.held_value, std::vector<Vec3>(surface.node.size(), Vec3{0, 0, 0}));
  mesh.surface = std::move(surface);
  mesh.section = std::move(section);
}

BodyMesh unswept(const BodyMesh& mesh) {
  BodyMesh given = mesh;
  if (!mesh.section.swept()) return given;
  given.surface = mesh.section.plane();
  given.held = std::exchange(given.given_held, {});
  given.held_value = std::exchange(given.given_value, {});
  given.section = {};
  return given;
}

}  // namespace rollcon
