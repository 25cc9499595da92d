#include "contact/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/input_checks.hpp"

namespace rollcon {

namespace {

/// Takes n values over; returns false if they were there already. Allocates only for a new length.
bool replace(std::vector<double>& held, std::int64_t n, const double* value) {
  const auto size = static_cast<std::size_t>(n);
  if (held.size() == size && std::equal(value, value + n, held.begin())) return false;
  held.reserve(size);
  held.assign(value, value + n);
  return true;
}

bool replace(double& held, double value) {
  if (held == value) return false;
  held = value;
  return true;
}

bool replace(Load& held, Load value) {
  if (held.how == value.how && held.value == value.value) return false;
  held = value;
  return true;
}

}  // namespace

void Scene::require_frame_size(std::int64_t n, const char* what) const {
  require_count(n, "n");
  if (!frame_given_ || mesh_.nodes() == 0)
    fail(Status::err_state,
         "%s is given node by node, and the frame has no nodes yet: call rollcon_contact_frame_nodes, "
         "rollcon_contact_frame_ellipse, ... before",
         what);
  if (n != mesh_.nodes())
    fail(Status::err_argument, "n is %lld; the frame has %lld nodes", static_cast<long long>(n),
         static_cast<long long>(mesh_.nodes()));
}

void Scene::set_gap(std::int64_t n, const double* gap) {
  require_frame_size(n, "the gap");
  require_pointer(gap, "gap");
  require_finite(n, 1, gap, "gap", mesh_.index_base);
  if (!replace(gap_.node, n, gap) && gap_.kind == GapKind::nodes) return;
  gap_.kind = GapKind::nodes;
  ++revision.gap;
}

void Scene::set_gap_quadratic(double a, double b, double c) {
  require_finite(a, "a");
  require_finite(b, "b");
  require_finite(c, "c");
  const std::array<double, 3> form{a, b, c};
  if (gap_.kind == GapKind::quadratic && gap_.quadratic == form) return;
  gap_.quadratic = form;
  gap_.kind = GapKind::quadratic;
  ++revision.gap;
}

void Scene::set_gap_grid(const GridPlace& place, const double* gap) {
  require_ascending(place.x_least, "x_least", place.x_greatest, "x_greatest");
  require_ascending(place.y_least, "y_least", place.y_greatest, "y_greatest");
  require_pointer(gap, "gap");
  for (std::int64_t j = 0; j < place.ny; ++j)
    for (std::int64_t i = 0; i < place.nx; ++i)
      if (const double value = gap[j * place.nx + i]; !(value > -INFINITY))
        fail(Status::err_nonfinite,
             "gap of point %lld of line %lld (both counting from %d) is %g; allowed: finite, or "
             "+infinity where a body ends",
             static_cast<long long>(i) + mesh_.index_base, static_cast<long long>(j) + mesh_.index_base,
             mesh_.index_base, value);
  if (gap_.kind == GapKind::grid && gap_.grid->same_as(place, gap)) return;
  gap_.grid = std::make_shared<HeightGrid>(place, gap);
  gap_.kind = GapKind::grid;
  ++revision.gap;
}

std::optional<std::array<double, 3>> Scene::quadratic_gap() const {
  return gap_.kind == GapKind::quadratic ? std::optional(gap_.quadratic) : std::nullopt;
}

double Scene::gap(std::int64_t k, double x, double y) const {
  if (gap_.kind == GapKind::nodes) return gap_.node[static_cast<std::size_t>(k)];
  if (gap_.kind == GapKind::grid) {
    const double gap = (*gap_.grid)(x, y);
    if (std::isfinite(gap)) return gap;
    fail(Status::err_argument,
         "frame node %lld (counting from %d) at (%g, %g) lies where the grid of the gap ends "
         "or is infinite",
         static_cast<long long>(k) + mesh_.index_base, mesh_.index_base, x, y);
  }
  const auto [a, b, c] = gap_.quadratic;
  return a * x * x + b * y * y + c * x * y;
}

void Scene::set_speed(double speed) {
  require_finite(speed, "speed");
  if (!(speed > 0)) fail(Status::err_argument, "speed is %g; allowed: > 0", speed);
  rolling_.speed_given = true;
  const bool another = replace(rolling_.speed, speed), travelled = std::exchange(rolling_.travel_given, false);
  if (another || travelled) ++revision.kinematics;
}

void Scene::set_step(std::int32_t kind, double dt) {
  if (kind < 0 || kind > 2) fail(Status::err_argument, "kind is %d; allowed: 0 (steady), 1 (rolling), 2 (shift)", kind);
  require_finite(dt, "dt");
  const auto wanted = static_cast<StepKind>(kind);
  if (wanted != StepKind::steady && !(dt > 0)) fail(Status::err_argument, "dt is %g; allowed: > 0", dt);
  const bool another = std::exchange(rolling_.step, wanted) != wanted;
  if (replace(rolling_.dt, wanted == StepKind::steady ? 0 : dt) || another) ++revision.kinematics;
}

void Scene::set_creep(double longitudinal, double lateral, double spin) {
  require_finite(longitudinal, "longitudinal");
  require_finite(lateral, "lateral");
  require_finite(spin, "spin");
  bool changed = false;
  for (const auto& [direction, value] : {std::pair{Direction::longitudinal, longitudinal},
                                         std::pair{Direction::lateral, lateral}, std::pair{Direction::spin, spin}})
    changed |= replace(load_[motion_of(direction)], {How::by_motion, value});
  if (changed) ++revision.load;
  if (std::exchange(rolling_.velocities_given, false)) ++revision.kinematics;
  rolling_.travel_given = false;
  rolling_.velocity = {};
}

void Scene::set_creep_field(std::int64_t n, const double* slip) {
  if (n == 0) {
    if (!creep_field_.empty()) ++revision.kinematics;
    creep_field_.clear();
    return;
  }
  require_frame_size(n, "the creep field");
  require_pointer(slip, "slip");
  require_finite(n, 2, slip, "slip", mesh_.index_base);
  if (replace(creep_field_, 2 * n, slip)) ++revision.kinematics;
}

void Scene::prescribe(std::int32_t direction, std::int32_t how, double value) {
  if (direction < 1 || direction == 5 || direction > 7)
    fail(Status::err_argument,
         "direction is %d; allowed: 1 (longitudinal), 2 (lateral), 3 (normal), 4 (spin), 6 (tilt 1), 7 (tilt 2)",
         direction);
  if (how != static_cast<std::int32_t>(How::by_motion) && how != static_cast<std::int32_t>(How::by_force))
    fail(Status::err_argument, "how is %d; allowed: 1 (by motion), 2 (by force)", how);
  require_finite(value, "value");
  const Load load{static_cast<How>(how), value};
  if (direction == static_cast<std::int32_t>(Direction::normal) && load.how == How::by_force && value < 0)
    fail(Status::err_argument, "the normal load is %g; allowed: 0 or more (compression)", value);
  if (replace(load_[motion_of(static_cast<Direction>(direction))], load)) ++revision.load;
}

bool Scene::tilts() const {
  return std::any_of(load_.begin() + tilt1, load_.end(),
                     [](const Load& l) { return l.how == How::by_force || l.value != 0; });
}

void Scene::set_friction(const char* law, std::int32_t n, const double* parameters) {
  if (friction_.set_law(law, n, parameters, mesh_.index_base)) ++revision.friction;
}

void Scene::take_friction(const FrictionGiven& given, double mu) {
  if (mu == friction_.mu() && given.law() == friction_.law() && given.layer() == friction_.layer() &&
      given.heat() == friction_.heat() && friction_.given())
    return;
  friction_ = given;
  friction_.set_coefficient(mu);
  ++revision.friction;
}

void Scene::scale_friction(const Scene& of, double factor) {
  friction_.scale(of.friction_, factor);
  across_.mu = of.across_.mu;
  for (double& mu : across_.mu) mu *= factor;
  ++revision.friction;
}

void Scene::set_friction_memory(double length, double least_speed) {
  if (friction_.set_memory(length, least_speed)) ++revision.friction;
}

void Scene::set_layer(double flexibility, double stress, double hardening) {
  if (friction_.set_layer(flexibility, stress, hardening)) ++revision.friction;
}

void Scene::set_heat(std::int32_t which, double conductivity, double capacity, double temperature) {
  if (friction_.set_heat(which, conductivity, capacity, temperature)) ++revision.friction;
}

void Scene::set_friction_across(std::int64_t n, const double* points) {
  if (n == 0) {
    if (!across_.y.empty()) ++revision.friction;
    across_.y.clear();
    across_.mu.clear();
    return;
  }
  require_count(n, "n");
  require_pointer(points, "points");
  require_finite(n, 2, points, "points", mesh_.index_base);
  bool same = static_cast<std::size_t>(n) == across_.y.size();
  for (std::int64_t i = 0; i < n; ++i) {
    const double y = points[2 * i], mu = points[2 * i + 1];
    const long long entry = static_cast<long long>(i) + mesh_.index_base;
    if (mu < 0)
      fail(Status::err_argument, "mu of point %lld (counting from %d) is %g; allowed: 0 or more", entry,
           mesh_.index_base, mu);
    if (i > 0 && !(y > points[2 * i - 2]))
      fail(Status::err_argument, "y of point %lld (counting from %d) is %g; allowed: above that before, %g", entry,
           mesh_.index_base, y, points[2 * i - 2]);
    same = same && across_.y[static_cast<std::size_t>(i)] == y && across_.mu[static_cast<std::size_t>(i)] == mu;
  }
  if (same) return;
  across_.y.resize(static_cast<std::size_t>(n));
  across_.mu.resize(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < across_.y.size(); ++i) across_.y[i] = points[2 * i], across_.mu[i] = points[2 * i + 1];
  ++revision.friction;
}

void Scene::set_friction_field(std::int64_t n, const double* mu) {
  if (n == 0) {
    if (!friction_field_.empty()) ++revision.friction;
    friction_field_.clear();
    return;
  }
  require_frame_size(n, "the friction field");
  require_pointer(mu, "mu");
  require_finite(n, 1, mu, "mu", mesh_.index_base);
  for (std::int64_t i = 0; i < n; ++i) {
    if (mu[i] < 0)
      fail(Status::err_argument, "mu of node %lld (counting from %d) is %g; allowed: 0 or more",
           static_cast<long long>(i) + mesh_.index_base, mesh_.index_base, mu[i]);
  }
  if (replace(friction_field_, n, mu)) ++revision.friction;
}

void Scene::require_complete(bool has_surface) const {
  if (mesh_.nodes() == 0)
    fail(Status::err_state,
         "the frame has no nodes: rollcon_contact_frame_nodes or "
         "rollcon_contact_frame_from_body");
  if (mesh_.elements() == 0) fail(Status::err_state, "the frame has no elements: rollcon_contact_frame_add_elements");
  if (!has_gap() && !has_surface)
    fail(Status::err_state,
         "no gap was given and no body has a mesh or a profile to compute it from: rollcon_contact_set_gap, "
         "rollcon_contact_set_gap_quadratic or rollcon_contact_set_gap_grid");
  if (!friction_.given() && friction_field_.empty() && across_.y.empty())
    fail(Status::err_state, "no friction was given: rollcon_contact_set_friction");
  friction_.require_consistent("rollcon_contact");
  if (rolling_.step != StepKind::steady && law() && law()->of_field())
    fail(Status::err_unsupported,
         "friction of temperature, with a memory or of a layer that flows is that of steady rolling; allowed in a step "
         "in time: other laws");
  if (rolling_.velocities_given && !rolling_.travel_given && !rolling_.speed_given)
    fail(
        Status::err_state,
        "velocities of bodies were given, but neither that of the contact (rollcon_contact_set_velocity) nor the speed "
        "at which it travels over them (rollcon_contact_set_rolling)");
}

}  // namespace rollcon
