#include "bodies/body.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "bodies/bem/system.hpp"
#include "bodies/supports.hpp"
#include "mesh/surface_check.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

BodyKind checked_kind(std::int32_t kind) {
  switch (static_cast<BodyKind>(kind)) {
    case BodyKind::bem:
    case BodyKind::halfspace:
    case BodyKind::rigid:
      return static_cast<BodyKind>(kind);
    case BodyKind::fem:
      fail(Status::err_unsupported,
           "kind is 1 (FEM); this build has 2 (BEM), 3 (half-space) and 4 (rigid)");
  }
  fail(Status::err_argument, "kind is %d; allowed: 1 (FEM), 2 (BEM), 3 (half-space), 4 (rigid)",
       kind);
}

}  // namespace

Body::Body(std::shared_ptr<Context> context, std::int32_t kind)
    : context_(std::move(context)), kind_(checked_kind(kind)) {}

void Body::set_elastic(std::int32_t /*tag*/, double young, double poisson) {
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
  young_ = young;
  poisson_ = poisson;
  elastic_set_ = true;
}

bool Body::meshed() const {
  if (prepared()) return mesh_.surface.nodes() > 0;
  const std::lock_guard lock(mutex_);
  return mesh_.surface.nodes() > 0;
}

SurfaceMesh Body::surface_copy() const {
  const std::lock_guard lock(mutex_);
  return mesh_.surface;
}

void Body::prepare() {
  std::unique_lock lock(mutex_);
  if (prepared()) return;
  if (!rigid() && !elastic_set_)
    fail(Status::err_state,
         "the body has no elastic constants: rollcon_body_set_elastic was not called");
  if (kind_ == BodyKind::bem && mesh_.surface.elements() == 0)
    fail(Status::err_state,
         "the body has no mesh: rollcon_body_set_nodes and rollcon_body_add_elements");
  if (mesh_.surface.elements() > 0) prepare_mesh();
  prepared_.store(true);
  lock.unlock();  // the log sink may ask the body
  if (!response_) return;
  const BodyStatistics s = response_->statistics();
  context_->log(LogLevel::info, "boundary-element body: %lld unknowns, condition %.1e, %.3f s",
                static_cast<long long>(s.unknowns), s.condition,
                s.seconds_assembly + s.seconds_factor);
}

void Body::prepare_mesh() {
  check_surface(mesh_.surface, rigid() ? SurfaceKind::open : SurfaceKind::closed);
  // Held faces and free ones with the same tag carry tractions of their own.
  SurfaceMesh parts = mesh_.surface;
  const std::vector<std::uint8_t> held = held_elements(mesh_);
  std::map<std::pair<std::int32_t, std::uint8_t>, std::int32_t> part_number;
  for (std::size_t e = 0; e < parts.tag.size(); ++e)
    parts.tag[e] =
        part_number
            .try_emplace({parts.tag[e], held[e]}, static_cast<std::int32_t>(part_number.size()))
            .first->second;
  traction_nodes_ = split_at_edges(parts, options_.edge_angle);
  std::fill(parts.tag.begin(), parts.tag.end(), 0);
  smooth_fans_ = split_at_edges(parts, options_.edge_angle);
  search_ = std::make_unique<SurfaceSearch>(mesh_.surface, contact_elements(mesh_));
  if (rigid()) return;
  require_supports(mesh_);
  refuse_incompressible_cavities(mesh_, poisson_);
  response_ = std::make_unique<bem::System>(mesh_, traction_nodes_, young_, poisson_, options_,
                                            context_->threads());
}

}  // namespace rollcon
