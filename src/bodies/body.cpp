#include "bodies/body.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "bodies/equal_bodies.hpp"
#include "bodies/model/archive.hpp"
#include "bodies/model/mesh_models.hpp"
#include "linalg/blas_kernels.hpp"
#include "mesh/mesh_errors.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

/// A body that is in memory serves instead of one in a file that is equal to it, unless more would have to be
/// factorised again.
bool serves_for(const BodyModel& known, SectionReader& file) {
  if (!known.response || !known.response->saved()) return true;
  std::int64_t solvable = 0;
  file.begin("response");
  InArchive ar(file);
  ar(solvable);
  return known.response->saved()->solvable() >= solvable;
}

}  // namespace

Body::Body(std::shared_ptr<Context> context, std::int32_t kind)
    : context_(std::move(context)),
      traits_(traits_of(static_cast<BodyKind>(kind))),
      model_(std::make_shared<BodyModel>()) {
  if (traits_.require_support) traits_.require_support();
  model_->kind = traits_.kind;
}

std::shared_ptr<Body> Body::copy() const {
  auto body = std::make_shared<Body>(context_, static_cast<std::int32_t>(traits_.kind));
  const std::lock_guard lock(mutex_);
  BodyModel& to = *body->model_;
  to.material = model_->material;
  to.relaxation = model_->relaxation;
  to.mesh = unswept(model_->mesh);
  to.profile = model_->profile;
  to.contact_material = model_->contact_material;
  body->options_ = options_;
  body->group_ = group_;
  body->number_ = number_;
  return body;
}

void Body::set_elastic(std::int32_t tag, double young, double poisson) {
  if (rigid()) fail(Status::err_state, "a rigid body has no elastic constants");
  require_elastic_constants(young, poisson);
  const std::lock_guard lock(mutex_);
  require_unprepared("material is");
  model_->material[traits_.filled() ? tag : 0] = model_->contact_material = {young, poisson};
}

void Body::set_viscoelastic(std::int32_t tag, std::int64_t n, const double* ratios, const double* times) {
  set_relaxation(tag, {checked_relaxation(n, ratios, times), {}});
}

void Body::set_moduli(std::int32_t tag, std::int64_t n, const double* frequencies, const double* storage,
                      const double* loss) {
  constexpr double most = 0.1, told = 0.02;
  double young = 0;
  Relaxation checked = checked_moduli(n, frequencies, storage, loss, young);
  const double misfit = checked.misfit;
  if (traits_.half_space && misfit > most)
    fail(Status::err_argument,
         "the nearest Prony series is off the moduli by up to %.2g %%; allowed for half-spaces: up to %g %%",
         100 * misfit, 100 * most);
  set_relaxation(tag, std::move(checked));
  if (n == 0) return;
  {
    const std::lock_guard lock(mutex_);
    model_->material[traits_.filled() ? tag : 0].young = model_->contact_material.young = young;
  }
  if (traits_.half_space)
    context_->log(misfit > told ? LogLevel::warning : LogLevel::info,
                  "half-space body: its Prony series is off the moduli given by up to %.2g %%", 100 * misfit);
}

void Body::set_relaxation(std::int32_t tag, Relaxation checked) {
  if (!traits_.half_space && !traits_.section)
    fail(Status::err_state, "a %s body takes no relaxation; half-spaces and sections do", traits_.name);
  const std::lock_guard lock(mutex_);
  require_unprepared("material is");
  const std::int32_t own = traits_.filled() ? tag : 0;
  if (!checked.point.empty() && !model_->material.contains(own))
    fail(Status::err_state, "tag %d has no Poisson's ratio: call rollcon_body_set_elastic before its moduli", tag);
  model_->relaxation.erase(own);
  if (!checked.term.empty()) model_->relaxation[own] = std::move(checked);
}

const Relaxation& Body::relaxation() const {
  static const Relaxation none;
  const auto found = model_->relaxation.find(model_->contact_tag);
  return found == model_->relaxation.end() ? none : found->second;
}

bool Body::meshed() const {
  if (prepared()) return given().surface.nodes() > 0;
  const std::lock_guard lock(mutex_);
  return given().surface.nodes() > 0;
}

std::pair<std::int64_t, std::int64_t> Body::size() const {
  const std::lock_guard lock(mutex_);
  return {given().surface.nodes(), traits_.volume ? given().volume.elements() : given().surface.elements()};
}

SurfaceMesh Body::surface_copy() {
  const std::lock_guard lock(mutex_);
  update_boundary(given());
  if (!traits_.section || given().surface.elements() == 0) return given().surface;
  BodyMesh swept = given();
  sweep_section(swept, options_.stations);
  return swept.surface;
}

void Body::prepare(SectionReader* saved) {
  std::unique_lock lock(mutex_);
  if (prepared()) return;
  require_complete();
  model_->options = options_;
  if (given().surface.nodes() > 0) {
    const int threads = context_->threads();
    EqualBodies& bodies = context_->bodies([] { return std::make_shared<EqualBodies>(); });
    const auto make = [&](BodyModel& model) {
      if (saved || !traits_.make_response) return prepare_model(model, threads, {saved, nullptr});
      bodies.share_equations(model_, [&](BodyModel& own, std::shared_ptr<BodyModel> known) {
        shared_equations_ = known != nullptr;
        prepare_model(own, threads, {nullptr, std::move(known)});
      });
    };
    const auto serves = [&](const BodyModel& known) { return !saved || serves_for(known, *saved); };
    std::shared_ptr<BodyModel> model = bodies.share(model_, make, serves);
    shared_ = model != model_;
    shared_equations_ = shared_equations_ && !shared_;
    model_ = std::move(model);
    if (shared_ && saved && response() && response()->saved()) response()->saved()->add_kept(*saved);
  } else if (model_->profile.curve) {
    model_->surface = surface_of(model_->profile, model_->options.smooth_slices != 0);
  }
  prepared_.store(true);
  lock.unlock();  // the log sink may ask the body
  if (response()) log_preparation();
}

void Body::log_preparation() const {
  const BodyStatistics s = response()->statistics();
  const char* model = traits_.name;
  const auto unknowns = static_cast<long long>(s.unknowns);
  if (shared_)
    context_->log(LogLevel::info, "%s body: %lld unknowns, equal to a body of this context: nothing assembled", model,
                  unknowns);
  else if (shared_equations_)
    context_->log(LogLevel::info, "%s body: %lld unknowns, those of a body of this context under other loads", model,
                  unknowns);
  else if (loaded())
    context_->log(LogLevel::info, "%s body: %lld unknowns, from a file: nothing assembled", model, unknowns);
  else if (s.factorizations == 0)
    context_->log(LogLevel::info, "%s body: %lld unknowns, to be factorised for its first frame", model, unknowns);
  else
    context_->log(LogLevel::info, "%s body: %lld unknowns, condition %.1e, %.3f s", model, unknowns, s.condition,
                  s.seconds_assembly + s.seconds_factor);
  const double worst = traits_.worst_condition;
  if (s.condition > worst)
    context_->log(LogLevel::warning,
                  "%s body: its equations have condition %.1e, beyond %.0e: few digits of its "
                  "displacements are left; slender or tiny elements, long thin bodies and very "
                  "unequal moduli do that",
                  model, s.condition, worst);
  if (traits_.dense && !shared_ && !loaded())
    if (const std::string slow = slow_factorization(blas_kernels(), s.unknowns); !slow.empty())
      context_->log(LogLevel::warning, "%s body: %s", model, slow.c_str());
  constexpr double most = 0.5;
  if (!shared_ && model_->thin.part > most)
    context_->log(LogLevel::warning,
                  "%s body: on %.0f %% of its free surface its elements are long beside its "
                  "thickness (%.3g times on average): if it bends, it comes out too stiff; refine "
                  "it there",
                  model, 100 * model_->thin.part, model_->thin.ratio);
}

void Body::require_complete() const {
  if (!rigid() && model_->material.empty())
    fail(Status::err_state, "the body has no elastic constants: rollcon_body_set_elastic was not called");
  const char* remedy = "rollcon_body_set_nodes and rollcon_body_add_elements";
  if (traits_.volume && given().volume.elements() == 0)
    fail(Status::err_state, "the body has no volume elements: %s", remedy);
  if (traits_.surface == SurfaceKind::closed && given().surface.elements() == 0)
    fail(Status::err_state, "the body has no mesh: %s", remedy);
  if (rigid() && given().surface.nodes() > 0 && given().surface.elements() == 0)
    fail(Status::err_state, "the rigid body has nodes but no elements: %s", remedy);
  if (model_->profile.curve && model_->profile.place == ProfilePlace::none)
    fail(Status::err_state, "the profile has no place: rollcon_body_extrude_profile or rollcon_body_revolve_profile");
  if (traits_.section && given().surface.elements() == 0)
    fail(Status::err_state, "the section has no elements: %s", remedy);
  if (traits_.given && !given().matrix)
    fail(Status::err_state,
         "the body has no stiffness or flexibility: rollcon_body_set_condensed or rollcon_body_read_condensed");
  if (traits_.given && given().surface.elements() == 0)
    fail(Status::err_state, "the body has no surface elements: rollcon_body_add_elements");
  if (traits_.filled()) require_materials();
}

void Body::require_materials() const {
  const VolumeElements& volume = given().volume;
  const std::vector<std::int32_t>& tag = traits_.volume ? volume.tag : given().surface.tag;
  for (std::int64_t e = 0; e < std::ssize(tag); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const auto found = model_->material.find(tag[i]);
    const std::int32_t base = given().surface.index_base;
    if (found == model_->material.end()) {
      std::string tags;
      for (const auto& [tag, material] : model_->material) tags += (tags.empty() ? "" : ", ") + std::to_string(tag);
      fail(Status::err_state,
           "element %lld (counting from %d) has tag %d, for which rollcon_body_set_elastic gave no "
           "constants; it was called for tags: %s",
           static_cast<long long>(e) + base, base, tag[i], tags.c_str());
    }
    if (traits_.section) {
      constexpr double most_of_plane = 0.4999999;
      if (found->second.poisson > most_of_plane)
        fail(Status::err_unsupported,
             "element %lld of the section (counting from %d) has poisson %.9g; allowed: up to %.9g",
             static_cast<long long>(e) + base, base, found->second.poisson, most_of_plane);
      continue;
    }
    const double most = fem::largest_poisson(volume.type[i]);
    if (found->second.poisson <= most) continue;
    const bool tetrahedron = volume.type[i] == VolumeType::tet4;
    if (tetrahedron || volume.type[i] == VolumeType::wedge6)
      fail(Status::err_unsupported,
           "element %lld (counting from %d) is a %s of poisson %.9g; allowed: up to %g, beyond "
           "which "
           "it is far too stiff; use %s or hexahedra",
           static_cast<long long>(e) + base, base, name(volume.type[i]), found->second.poisson, most,
           tetrahedron ? "tet10" : "wedge15");
    fail(Status::err_unsupported,
         "element %lld (counting from %d) has poisson %.9g; allowed for finite elements: up to "
         "%.9g; use a boundary-element body beyond",
         static_cast<long long>(e) + base, base, found->second.poisson, most);
  }
}

}  // namespace rollcon
