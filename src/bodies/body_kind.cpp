#include "bodies/body_kind.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "bodies/body_model.hpp"
#include "bodies/contact_surface.hpp"
#include "bodies/halfspace/halfspace.hpp"
#include "bodies/meshed_compliance.hpp"
#include "bodies/model/mesh_models.hpp"
#include "bodies/model/supports.hpp"
#include "bodies/pair.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

std::unique_ptr<Compliance> on_halfspace(const Frame& frame, const PairOfBodies& pair, int which, double accuracy,
                                         int threads) {
  const Body& body = *pair.body[at(which)];
  return make_lagging_compliance(frame, halfspace_constants(body.young(), body.poisson(), which == 0 ? 1 : -1),
                                 lags_of(pair, which), accuracy, threads);
}

std::unique_ptr<Condensed> by_finite_elements(BodyModel& model, int threads, SectionReader* saved) {
  return fem::make_response(model.mesh, model.smooth_fans, model.material, model.options, threads, saved);
}

std::unique_ptr<Condensed> by_section(BodyModel& model, int threads, SectionReader* saved) {
  return section::make_response(model.mesh, model.smooth_fans, {model.material, model.relaxation}, model.options,
                                threads, saved);
}

std::unique_ptr<Condensed> by_matrix(BodyModel& model, int threads, SectionReader* saved) {
  return condensed::make_response(model.mesh, model.smooth_fans, model.contact_material, model.options, threads, saved);
}

std::unique_ptr<Condensed> by_boundary_elements(BodyModel& model, int threads, SectionReader* saved) {
  const auto [young, poisson] = model.contact_material;
  refuse_incompressible_cavities(model.mesh, poisson);
  return bem::make_response(model.mesh, model.traction_nodes, young, poisson, model.options, threads, saved);
}

// Clamped plates under pressure lose two thirds of their deflection when elements are longer than 1.7 thicknesses
// (linear boundary elements), 8 (quadratic boundary elements), 17 (hex8) or 80 (hex20). Beyond the worst conditions
// rounding (or the tolerance of boundary integrals) shows in the fourth digit.
constexpr BodyTraits kinds[] = {
    {.kind = BodyKind::fem,
     .name = "finite-element",
     .parts = "finite elements",
     .volume = true,
     .surface = SurfaceKind::boundary,
     .require_support = fem::require_support,
     .make_compliance = make_meshed_compliance,
     .make_response = by_finite_elements,
     .worst_condition = 1e12,
     .thin_linear = 10,
     .thin_quadratic = 30},
    {.kind = BodyKind::bem,
     .name = "boundary-element",
     .parts = "boundary elements",
     .surface = SurfaceKind::closed,
     .require_support = bem::require_support,
     .make_compliance = make_meshed_compliance,
     .make_response = by_boundary_elements,
     .worst_condition = 1e10,
     .dense = true,
     .smooth_difference = true,
     .thin_linear = 2,
     .thin_quadratic = 6},
    {.kind = BodyKind::halfspace,
     .name = "half-space",
     .parts = "half-space",
     .meshed = false,
     .half_space = true,
     .make_compliance = on_halfspace},
    {.kind = BodyKind::section,
     .name = "section",
     .parts = "section of finite elements",
     .section = true,
     .require_support = section::require_support,
     .make_compliance = make_meshed_compliance,
     .make_response = by_section,
     .worst_condition = 1e12},
    {.kind = BodyKind::condensed,
     .name = "condensed",
     .parts = "given matrix",
     .given = true,
     .require_support = condensed::require_support,
     .make_compliance = make_meshed_compliance,
     .make_response = by_matrix,
     .worst_condition = 1e12},
    {.kind = BodyKind::rigid, .name = "rigid", .parts = "rigid", .elastic = false},
};

}  // namespace

std::span<const BodyTraits> all_kinds() {
  return kinds;
}

std::string elastic_kinds() {
  std::vector<std::string> names;
  for (const BodyTraits& row : kinds)
    if (row.elastic) names.emplace_back(row.name);
  std::string text = names.front();
  for (std::size_t k = 1; k < names.size(); ++k) text += (k + 1 < names.size() ? ", " : " or ") + names[k];
  return text;
}

const BodyTraits* find_traits(BodyKind kind) {
  const auto* found =
      std::find_if(std::begin(kinds), std::end(kinds), [&](const BodyTraits& row) { return row.kind == kind; });
  return found == std::end(kinds) ? nullptr : found;
}

const BodyTraits& traits_of(BodyKind kind) {
  if (const BodyTraits* found = find_traits(kind)) return *found;
  std::string allowed;
  for (const BodyTraits& row : kinds)
    allowed += (allowed.empty() ? "" : ", ") + std::to_string(static_cast<int>(row.kind)) + " (" + row.name + ")";
  fail(Status::err_argument, "kind is %d; allowed: %s", static_cast<int>(kind), allowed.c_str());
}

}  // namespace rollcon
