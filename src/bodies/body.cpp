#include "bodies/body.hpp"

#include <utility>

#include "support/input_checks.hpp"

namespace rollcon {

namespace {

BodyKind checked_kind(std::int32_t kind) {
  switch (static_cast<BodyKind>(kind)) {
    case BodyKind::halfspace:
    case BodyKind::rigid:
      return static_cast<BodyKind>(kind);
    case BodyKind::fem:
    case BodyKind::bem:
      fail(Status::err_unsupported, "kind is %d (%s); this build has 3 (half-space) and 4 (rigid)",
           kind, kind == static_cast<std::int32_t>(BodyKind::fem) ? "FEM" : "BEM");
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
  if (prepared()) fail(Status::err_state, "the body is prepared: its material is fixed");
  young_ = young;
  poisson_ = poisson;
  elastic_set_ = true;
}

void Body::prepare() {
  const std::lock_guard lock(mutex_);
  if (!rigid() && !elastic_set_)
    fail(Status::err_state,
         "the half-space has no elastic constants: rollcon_body_set_elastic was not called");
  prepared_.store(true);
}

}  // namespace rollcon
