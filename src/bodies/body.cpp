#include "bodies/body.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "bodies/bem/system.hpp"
#include "bodies/fem/element_stiffness.hpp"
#include "bodies/fem/system.hpp"
#include "bodies/supports.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

BodyKind checked_kind(std::int32_t kind) {
  switch (static_cast<BodyKind>(kind)) {
    case BodyKind::fem:
      fem::require_support();
      return BodyKind::fem;
    case BodyKind::bem:
    case BodyKind::halfspace:
    case BodyKind::rigid:
      return static_cast<BodyKind>(kind);
  }
  fail(Status::err_argument, "kind is %d; allowed: 1 (FEM), 2 (BEM), 3 (half-space), 4 (rigid)",
       kind);
}

}  // namespace

Body::Body(std::shared_ptr<Context> context, std::int32_t kind)
    : context_(std::move(context)), kind_(checked_kind(kind)) {}

void Body::set_elastic(std::int32_t tag, double young, double poisson) {
  if (rigid()) fail(Status::err_state, "a rigid body has no elastic constants");
  require_finite(young, "young");
  require_finite(poisson, "poisson");
  // Beyond these, squares of stiffnesses and compliances would leave the range of doubles.
  constexpr double least = 1e-60, most = 1e60;
  if (!(young >= least && young <= most))
    fail(Status::err_argument, "young is %g; allowed: > 0, from %g to %g", young, least, most);
  if (!(poisson > -1 && poisson <= 0.5))
    fail(Status::err_argument, "poisson is %g; allowed: -1 < poisson <= 0.5", poisson);
  const std::lock_guard lock(mutex_);
  require_unprepared("material is");
  material_[kind_ == BodyKind::fem ? tag : 0] = contact_material_ = {young, poisson};
}

bool Body::meshed() const {
  if (prepared()) return mesh_.surface.nodes() > 0;
  const std::lock_guard lock(mutex_);
  return mesh_.surface.nodes() > 0;
}

std::pair<std::int64_t, std::int64_t> Body::size() const {
  const std::lock_guard lock(mutex_);
  return {mesh_.surface.nodes(),
          kind_ == BodyKind::fem ? mesh_.volume.elements() : mesh_.surface.elements()};
}

SurfaceMesh Body::surface_copy() {
  const std::lock_guard lock(mutex_);
  update_boundary(mesh_);
  return mesh_.surface;
}

void Body::prepare() {
  std::unique_lock lock(mutex_);
  if (prepared()) return;
  require_complete();
  if (mesh_.surface.nodes() > 0) prepare_mesh();
  prepared_.store(true);
  lock.unlock();  // the log sink may ask the body
  if (!response_) return;
  const BodyStatistics s = response_->statistics();
  const char* model = kind_ == BodyKind::fem ? "finite-element" : "boundary-element";
  if (s.factorizations == 0) {
    context_->log(LogLevel::info, "%s body: %lld unknowns, to be factorised for its first frame",
                  model, static_cast<long long>(s.unknowns));
    return;
  }
  context_->log(LogLevel::info, "%s body: %lld unknowns, condition %.1e, %.3f s", model,
                static_cast<long long>(s.unknowns), s.condition,
                s.seconds_assembly + s.seconds_factor);
}

void Body::require_complete() const {
  if (!rigid() && material_.empty())
    fail(Status::err_state,
         "the body has no elastic constants: rollcon_body_set_elastic was not called");
  const char* remedy = "rollcon_body_set_nodes and rollcon_body_add_elements";
  if (kind_ == BodyKind::fem && mesh_.volume.elements() == 0)
    fail(Status::err_state, "the body has no volume elements: %s", remedy);
  if (kind_ == BodyKind::bem && mesh_.surface.elements() == 0)
    fail(Status::err_state, "the body has no mesh: %s", remedy);
  if (rigid() && mesh_.surface.nodes() > 0 && mesh_.surface.elements() == 0)
    fail(Status::err_state, "the rigid body has nodes but no elements: %s", remedy);
  if (kind_ == BodyKind::fem) require_materials();
}

void Body::require_materials() const {
  const VolumeElements& volume = mesh_.volume;
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const auto found = material_.find(volume.tag[i]);
    const std::int32_t base = mesh_.surface.index_base;
    if (found == material_.end()) {
      std::string tags;
      for (const auto& [tag, material] : material_)
        tags += (tags.empty() ? "" : ", ") + std::to_string(tag);
      fail(Status::err_state,
           "element %lld (counting from %d) has tag %d, for which rollcon_body_set_elastic gave no "
           "constants; it was called for tags: %s",
           static_cast<long long>(e) + base, base, volume.tag[i], tags.c_str());
    }
    const double most = fem::largest_poisson(volume.type[i]);
    if (found->second.poisson <= most) continue;
    const bool tetrahedron = volume.type[i] == VolumeType::tet4;
    if (tetrahedron || volume.type[i] == VolumeType::wedge6)
      fail(Status::err_unsupported,
           "element %lld (counting from %d) is a %s of poisson %g; allowed: up to %g, beyond which "
           "it is far too stiff; use %s or hexahedra",
           static_cast<long long>(e) + base, base, name(volume.type[i]), found->second.poisson,
           most, tetrahedron ? "tet10" : "wedge15");
    fail(Status::err_unsupported,
         "element %lld (counting from %d) has poisson %.9g; allowed for finite elements: up to "
         "%.9g; use a boundary-element body beyond",
         static_cast<long long>(e) + base, base, found->second.poisson, most);
  }
}

// Nodes given for a tag may have held no whole face, or later calls given its faces another one.
void Body::require_tagged_faces() const {
  const std::vector<std::int32_t>& tags = mesh_.surface.tag;
  const auto require = [&](std::int32_t tag, const char* what) {
    if (std::find(tags.begin(), tags.end(), tag) == tags.end())
      fail(Status::err_mesh,
           "tag %d, named by %s, is on no face of the body: of nodes a face counts when all of its "
           "own are given, midside nodes too, and later calls win over earlier ones",
           tag, what);
  };
  for (const FaceLoad& load : mesh_.load)
    require(load.tag, "rollcon_body_set_traction or rollcon_body_set_pressure");
  for (const std::int32_t tag : mesh_.contact_tag) require(tag, "rollcon_body_set_contact_faces");
}

// The half-space field between nodes, and first guesses, need one material.
void Body::choose_contact_material() {
  std::map<std::int32_t, double> area;
  for (const std::int64_t e : contact_elements(mesh_))
    area[mesh_.volume
             .tag[static_cast<std::size_t>(mesh_.origin[static_cast<std::size_t>(e)].element)]] +=
        element_area(mesh_.surface, e);
  double most = 0;
  for (const auto& [tag, a] : area) {
    if (a <= most) continue;
    most = a;
    contact_material_ = material_.at(tag);
  }
}

void Body::prepare_mesh() {
  if (kind_ == BodyKind::fem) {
    check_volume(mesh_.surface.node, mesh_.volume, mesh_.surface.index_base);
    update_boundary(mesh_);
    require_tagged_faces();
  }
  if (mesh_.surface.elements() == 0) return;
  const SurfaceKind surface_kind = kind_ == BodyKind::fem ? SurfaceKind::boundary
                                   : rigid()              ? SurfaceKind::open
                                                          : SurfaceKind::closed;
  check_surface(mesh_.surface, surface_kind);
  // Held faces and free ones with the same tag carry tractions of their own.
  SurfaceMesh parts = mesh_.surface;
  const std::vector<std::uint8_t> held = held_elements(mesh_);
  std::map<std::pair<std::int32_t, std::uint8_t>, std::int32_t> part_number;
  for (std::size_t e = 0; e < parts.tag.size(); ++e)
    parts.tag[e] =
        part_number
            .try_emplace({parts.tag[e], held[e]}, static_cast<std::int32_t>(part_number.size()))
            .first->second;
  if (kind_ == BodyKind::bem) traction_nodes_ = split_at_edges(parts, options_.edge_angle);
  std::fill(parts.tag.begin(), parts.tag.end(), 0);
  smooth_fans_ = split_at_edges(parts, options_.edge_angle);
  search_ = std::make_unique<SurfaceSearch>(mesh_.surface, contact_elements(mesh_));
  if (rigid()) return;
  require_supports(mesh_);
  if (kind_ == BodyKind::fem) {
    choose_contact_material();
    response_ = std::make_unique<fem::System>(mesh_, smooth_fans_, material_, options_,
                                              context_->threads());
    return;
  }
  refuse_incompressible_cavities(mesh_, poisson());
  response_ = std::make_unique<bem::System>(mesh_, traction_nodes_, young(), poisson(), options_,
                                            context_->threads());
}

}  // namespace rollcon
