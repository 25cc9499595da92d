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

void PatchContact::stand_nearby(const Nearby& nearby) {
  now_.patch = nearby.patch;
  stand(nearby.motion);
  prescribe(now_.give_way, nearby.friction);
}

// Changes loads in the axes by Newton's system, and the axes themselves as the overlap moves.
PatchContact::Rate PatchContact::rate(const Nearby& before, const Nearby& behind, double distance) {
  if (now_.by_table) fail(Status::err_state, "forces of the patch come from a table: they have no solution");
  const auto [force, moment] = found_loads();
  if (!here_) here_ = std::make_unique<Kept>();
  keep(*here_);
  const bool on_strips = now_.on_strips;
  if (on_strips && !nearby_) nearby_ = std::make_unique<std::array<StripGivens, 2>>();
  NodeGivens at_nodes[2];
  Axes axes[2];
  for (std::size_t s = 0; s < 2; ++s) {
    stand_nearby(s == 0 ? before : behind);
    axes[s] = now_.axes;
    on_strips ? (*nearby_)[s].read(*contact_->solver, box()) : contact_->solver->read_givens(at_nodes[s]);
  }
  now_.solves = ++solves_;
  return_to(*here_);
  const auto rates_at_nodes = [&]() {
    NodeGivens& rate = at_nodes[1];
    const auto per_distance = [&](std::vector<double>& value, const std::vector<double>& from) {
      for (std::size_t k = 0; k < value.size(); ++k) value[k] = (value[k] - from[k]) / distance;
    };
    per_distance(rate.gap, at_nodes[0].gap);
    for (std::size_t c = 0; c < 2; ++c) per_distance(rate.slip[c], at_nodes[0].slip[c]);
    per_distance(rate.mu, at_nodes[0].mu);
    return contact_->solver->rates(rate);
  };
  Rates found;
  if (!on_strips)
    found = rates_at_nodes();
  else if (now_.status != Status::no_contact)
    found = strips_->rates((*nearby_)[0], (*nearby_)[1], distance);
  const Rate turned[2] = {loads(axes[0], before.patch.reference, force, moment),
                          loads(axes[1], behind.patch.reference, force, moment)};
  const Rate own = loads(now_.axes, now_.patch.reference, found.force, found.moment);
  const double inverse = 1 / distance;
  return {own.force + inverse * (turned[1].force - turned[0].force),
          own.moment + inverse * (turned[1].moment - turned[0].moment)};
}

PatchContact::Rate PatchContact::rate_of_giving_way() {
  Rates found;
  if (!now_.on_strips)
    found = contact_->solver->rates(static_cast<Parameter>(Direction::normal));
  else if (now_.status != Status::no_contact)
    strips_->rates(Parameter::normal, found);
  const Rate r = loads(now_.axes, now_.patch.reference, found.force, found.moment);
  return {-1.0 * r.force, -1.0 * r.moment};
}

}  // namespace rollcon
