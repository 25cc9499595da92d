/// Takes friction, layer and heat of a wheel on its rail, and hands them to its patches.

#include <algorithm>
#include <cstring>
#include <utility>

#include "contact/laws/field_law.hpp"
#include "support/input_checks.hpp"
#include "support/linear_between.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

constexpr double most_friction = 10;
constexpr std::int32_t most_angles = 1000;

void require_moderate(const FrictionGiven& friction) {
  if (friction.mu() > most_friction)
    fail(Status::err_argument, "mu, the greatest coefficient of the law, is %g; allowed: 0 to %g", friction.mu(),
         most_friction);
}

}  // namespace

// Changes a copy, because patches and saved states hold what was before.
template <class Set>
void WheelRail::change_friction(Set set) {
  auto next = std::make_shared<FrictionGiven>(*in_.friction);
  if (set(*next)) in_.friction = std::move(next);
}

void WheelRail::set_friction(const char* law, std::int32_t n, const double* parameters) {
  require_pointer(law, "law");
  const bool by_angle = std::strcmp(law, "by_angle") == 0;
  if (!by_angle && std::none_of(law_names().begin(), law_names().end(),
                                [law](const LawName& known) { return std::strcmp(law, known.name) == 0; }))
    fail(Status::err_argument, "law is '%.64s'; allowed: those of rollcon_contact_set_friction, or 'by_angle'", law);
  if (!by_angle) {
    change_friction([&](FrictionGiven& next) {
      const bool changed = next.set_law(law, n, parameters);
      require_moderate(next);
      return changed;
    });
    in_.by_angle.reset();
    in_.friction_given = true;
    return;
  }
  if (n < 2 || n % 2 != 0) fail(Status::err_argument, "n is %d; allowed for by_angle: 2, 4, 6, ...", n);
  set_law_by_angle("coulomb", n / 2, n, parameters);
}

void WheelRail::set_law_by_angle(const char* law, std::int32_t points, std::int32_t n, const double* parameters) {
  require_pointer(law, "law");
  if (points < 1 || points > most_angles)
    fail(Status::err_argument, "points is %d; allowed: 1 to %d", points, most_angles);
  if (n % points != 0 || n / points < 2)
    fail(Status::err_argument, "n is %d; allowed: for each of the %d points an angle and the law's parameters", n,
         points);
  require_pointer(parameters, "parameters");
  require_finite(n, 1, parameters, "parameters", 0);
  const std::int32_t each = n / points - 1;
  std::shared_ptr<FrictionGiven> first;
  auto made = std::make_shared<FrictionByAngle>();
  for (std::int32_t i = 0; i < points; ++i) {
    const double* row = parameters + i * (each + 1);
    if (i > 0 && !(row[0] > made->angle.back()))
      fail(Status::err_argument, "angle of point %d (counting from 0) is %g; allowed: above that before, %g", i, row[0],
           made->angle.back());
    auto own = std::make_shared<FrictionGiven>(*in_.friction);
    try {
      own->set_law(law, each, row + 1);
      require_moderate(*own);
    } catch (const Error& e) {
      fail(e.status(), "point %d (counting from 0): %s", i, e.what());
    }
    made->angle.push_back(row[0]);
    made->parameter.insert(made->parameter.end(), row + 1, row + 1 + each);
    made->mu.push_back(own->mu());
    if (i == 0) first = std::move(own);
  }
  made->law = law;
  made->coulomb = made->law == "coulomb";
  in_.friction = std::move(first);
  in_.by_angle = std::move(made);
  in_.friction_given = true;
}

void WheelRail::set_friction_memory(double length, double least_speed) {
  change_friction([&](FrictionGiven& next) { return next.set_memory(length, least_speed); });
}

void WheelRail::set_layer(double flexibility, double stress, double hardening) {
  change_friction([&](FrictionGiven& next) { return next.set_layer(flexibility, stress, hardening); });
}

void WheelRail::set_heat(std::int32_t which, double conductivity, double capacity, double temperature) {
  change_friction([&](FrictionGiven& next) { return next.set_heat(which, conductivity, capacity, temperature); });
}

void WheelRail::require_friction() const {
  if (!in_.friction_given) fail(Status::err_state, "something is missing: call rollcon_wheelrail_set_friction first");
  const FrictionGiven& friction = *in_.friction;
  friction.require_consistent("rollcon_wheelrail");
  const FieldLaw* field = friction.law() ? friction.law()->of_field() : nullptr;
  for (std::size_t b = 0; field && field->wants_temperature() && b < 2; ++b)
    if (!friction.heat()[b].given)
      fail(Status::err_state, "what the %s does with heat is not known: call rollcon_wheelrail_set_heat first",
           b == 0 ? "wheel" : "rail");
  if (in_.table && !in_.options.conformal && !friction.coulomb_alone())
    fail(Status::err_unsupported,
         "a creep-force table (rollcon_wheelrail_set_table) has forces under Coulomb's law between bare bodies; "
         "allowed: 'coulomb' without a layer, or no table");
}

// Takes friction at places across the overlap where inclinations are given.
PatchFriction WheelRail::friction_of(const OverlapPatch& patch) const {
  PatchFriction friction{.law = in_.friction,
                         .mu = in_.friction->mu(),
                         .table = in_.options.conformal ? nullptr : in_.table.get(),
                         .hertzian = in_.options.hertzian != 0};
  if (!in_.by_angle) return friction;
  const FrictionByAngle& by = *in_.by_angle;
  const double middle = search_->rail_angle(patch.reference[1]);
  friction.mu = linear_between(by.angle, by.mu, middle);
  if (!by.coulomb) friction.law = law_at(middle);
  friction.points = PatchFriction::most;
  for (std::size_t i = 0; i < friction.points; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(friction.points - 1);
    const double lateral = (1 - part) * patch.low + part * patch.high;
    friction.lateral[i] = lateral;
    friction.at[i] =
        linear_between(by.angle, by.mu, search_->rail_angle(patch.reference[1] + lateral * patch.lateral[1]));
  }
  return friction;
}

// Returns the law with the parameters of an inclination.
std::shared_ptr<const FrictionGiven> WheelRail::law_at(double angle) const {
  const FrictionByAngle& by = *in_.by_angle;
  const std::size_t n = by.parameter.size() / by.angle.size();
  std::vector<double> own(n), column(by.angle.size());
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = by.parameter[n * i + k];
    own[k] = linear_between(by.angle, column, angle);
  }
  auto law = std::make_shared<FrictionGiven>(*in_.friction);
  law->set_law(by.law.c_str(), static_cast<std::int32_t>(n), own.data());
  return law;
}

}  // namespace rollcon
