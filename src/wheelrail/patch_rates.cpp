/// Finds derivatives of a patch's forces.

#include "contact/solver.hpp"
#include "support/error.hpp"
#include "wheelrail/patch_snapshot.hpp"

namespace rollcon {
namespace {

Vec3 from_axes(const Axes& axes, const Vec3& v) {
  return v[0] * axes.t1 + v[1] * axes.t2 + v[2] * axes.n;
}

/// Returns the force and its moment about the patch's reference.
PatchContact::Rate loads(const Axes& axes, const Vec3& reference, const Vec3& force, const Vec3& moment) {
  const Vec3 f = from_axes(axes, force);
  return {f, from_axes(axes, moment) + cross(axes.origin - reference, f)};
}

}  // namespace

void PatchContact::read_nearby(const Nearby& nearby, NodeGivens& givens) {
  now_.patch = nearby.patch;
  stand(nearby.motion);
  prescribe(now_.give_way, nearby.friction);
  contact_->solver->read_givens(givens);
}

// Changes loads in the axes by Newton's system, and the axes themselves as the overlap moves.
PatchContact::Rate PatchContact::rate(const Nearby& before, const Nearby& behind, double distance) {
  if (now_.by_table) fail(Status::err_state, "forces of the patch come from a table: they have no solution");
  const auto [force, moment] = contact_->solver->loads();
  if (!here_) here_ = std::make_unique<Kept>();
  keep(*here_);
  NodeGivens rate, low;
  read_nearby(before, low);
  const Axes axes_before = now_.axes;
  read_nearby(behind, rate);
  const Axes axes_behind = now_.axes;
  now_.solves = ++solves_;
  return_to(*here_);
  const auto per_distance = [&](std::vector<double>& value, const std::vector<double>& from) {
    for (std::size_t k = 0; k < value.size(); ++k) value[k] = (value[k] - from[k]) / distance;
  };
  per_distance(rate.gap, low.gap);
  for (std::size_t c = 0; c < 2; ++c) per_distance(rate.slip[c], low.slip[c]);
  per_distance(rate.mu, low.mu);
  const Rates found = contact_->solver->rates(rate);
  const Rate turned[2] = {loads(axes_before, before.patch.reference, force, moment),
                          loads(axes_behind, behind.patch.reference, force, moment)};
  const Rate own = loads(now_.axes, now_.patch.reference, found.force, found.moment);
  const double inverse = 1 / distance;
  return {own.force + inverse * (turned[1].force - turned[0].force),
          own.moment + inverse * (turned[1].moment - turned[0].moment)};
}

PatchContact::Rate PatchContact::rate_of_giving_way() const {
  const Rates found = contact_->solver->rates(static_cast<Parameter>(Direction::normal));
  const Rate r = loads(now_.axes, now_.patch.reference, found.force, found.moment);
  return {-1.0 * r.force, -1.0 * r.moment};
}

}  // namespace rollcon
