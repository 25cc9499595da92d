/// Takes, places and returns profiles that bodies carry.

#include <cmath>
#include <string>
#include <utility>

#include "bodies/body.hpp"
#include "geometry/profile_shapes.hpp"
#include "io/profile_file.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/input_checks.hpp"

namespace rollcon {
namespace {

Vec3 vector_of(const double* v) {
  return {v[0], v[1], v[2]};
}

/// Makes the length of a vector one.
Vec3 unit_vector(const double* v, const char* name) {
  require_finite_vector(v, name);
  // Divides by its largest component first: squares of any length stay in range.
  const double most = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (!(most > 0)) fail(Status::err_argument, "%s is (0, 0, 0); allowed: any other vector", name);
  return normalized((1 / most) * vector_of(v));
}

void require_unit(double unit) {
  constexpr double least = 1e-30, most = 1e30;
  require_finite(unit, "unit");
  if (!(unit >= least && unit <= most))
    fail(Status::err_argument, "unit is %g; allowed: > 0, from %g to %g", unit, least, most);
}

}  // namespace

void Body::require_takes_profile() const {
  if (traits_.meshed && traits_.elastic)
    fail(Status::err_state, "a %s body takes no profile: its mesh is its surface", traits_.name);
  require_unprepared("profile is");
  if (given().surface.nodes() > 0) fail(Status::err_state, "the body has a mesh: it takes no profile as well");
}

void Body::replace_profile(ProfileCurve curve) {
  const std::lock_guard lock(mutex_);
  require_takes_profile();
  BodyProfile profile;
  profile.curve = std::make_shared<const ProfileCurve>(std::move(curve));
  model_->profile = std::move(profile);
}

void Body::fit_profile(const std::vector<Vec2>& point, double filter_length, const PointName& name, std::string told) {
  replace_profile(profile_through(point, filter_length, name, &told));
  if (!told.empty()) context_->log(LogLevel::warning, "%.*s", static_cast<int>(told.size() - 2), told.c_str());
}

void Body::set_profile(std::int64_t n, const double* points, double filter_length) {
  require_count(n, "n");
  if (n > 0) require_pointer(points, "points");
  constexpr long long most = 10'000'000;
  if (n > most) fail(Status::err_argument, "n is %lld; allowed: 2 to %lld", static_cast<long long>(n), most);
  std::vector<Vec2> point;
  for (std::int64_t i = 0; i < n; ++i) {
    point.push_back({points[2 * i], points[2 * i + 1]});
    for (std::size_t c = 0; c < 2; ++c)
      if (!std::isfinite(point.back()[c]))
        fail(Status::err_nonfinite, "%c of point %lld (counting from 0) is %g", "yz"[c], static_cast<long long>(i),
             point.back()[c]);
  }
  require_finite(filter_length, "filter_length");
  fit_profile(point, filter_length, [](std::size_t i) { return "point " + std::to_string(i) + " (counting from 0)"; });
}

void Body::set_profile_shape(const char* shape, std::int64_t n, const double* parameters) {
  require_pointer(shape, "shape");
  require_count(n, "n");
  if (n > 0) require_pointer(parameters, "parameters");
  replace_profile(profile_of_shape(shape, {parameters, static_cast<std::size_t>(n)}));
}

void Body::read_profile(const char* path, double unit, std::int32_t mirror, double filter_length) {
  require_pointer(path, "path");
  require_unit(unit);
  if (mirror < 0 || mirror > 3) fail(Status::err_argument, "mirror is %d; allowed: 0, 1 (y), 2 (z), 3 (both)", mirror);
  require_finite(filter_length, "filter_length");
  ProfileFile file = read_profile_file(path);
  const std::array<double, 2> factor{mirror & 1 ? -unit : unit, mirror & 2 ? -unit : unit};
  const double span = std::abs(file.point.back()[0] - file.point.front()[0]);
  for (Vec2& x : file.point)
    for (std::size_t c = 0; c < 2; ++c) x[c] *= factor[c];
  std::string told = file.told.empty() ? "" : path + (": " + file.told) + "; ";
  if (unit == 1 && span < 1)
    told += path + (": the profile spans " + std::to_string(span)) +
            ", taken as it is: of a file in metres 1000 as unit makes millimetres; ";
  fit_profile(
      file.point, filter_length, [&](std::size_t i) { return "line " + std::to_string(file.line[i]) + " of " + path; },
      std::move(told));
}

void Body::write_profile(const char* path, double unit) const {
  require_pointer(path, "path");
  require_unit(unit);
  std::vector<Vec2> point;
  {
    const std::lock_guard lock(mutex_);
    require_profile();
    point = model_->profile.curve->points();
  }
  for (Vec2& x : point) x = {x[0] / unit, x[1] / unit};
  write_profile_file(path, point);
}

void Body::extrude_profile(const double* origin, const double* along, const double* z_axis) {
  constexpr double least_angle = 1e-6;
  require_finite_vector(origin, "origin");
  const Vec3 axis = unit_vector(along, "along"), up = unit_vector(z_axis, "z_axis");
  const Vec3 z = up - dot(up, axis) * axis;
  if (length(z) < least_angle)
    fail(Status::err_argument, "along and z_axis are parallel; allowed: any angle above 1e-6");
  const std::lock_guard lock(mutex_);
  require_takes_profile();
  require_profile();
  BodyProfile& p = model_->profile;
  p.place = ProfilePlace::extruded;
  p.origin = vector_of(origin);
  p.axis = axis;
  p.z = normalized(z);
}

void Body::revolve_profile(const double* origin, const double* axis, double radius) {
  require_finite_vector(origin, "origin");
  const Vec3 unit = unit_vector(axis, "axis");
  require_finite(radius, "radius");
  const std::lock_guard lock(mutex_);
  require_takes_profile();
  require_profile();
  BodyProfile& p = model_->profile;
  require_one_side(*p.curve, radius);
  p.place = ProfilePlace::revolved;
  p.origin = vector_of(origin);
  p.axis = unit;
  p.radius = radius;
}

void Body::require_profile() const {
  if (!model_->profile.curve)
    fail(Status::err_state, "the body has no profile: rollcon_body_set_profile, _set_profile_shape or _read_profile");
}

std::shared_ptr<const ProfileCurve> Body::profile() const {
  const std::lock_guard lock(mutex_);
  require_profile();
  return model_->profile.curve;
}

std::shared_ptr<Body> Body::with_profile_alone() const {
  auto body = std::make_shared<Body>(context_, static_cast<std::int32_t>(traits_.kind));
  const std::lock_guard lock(mutex_);
  require_profile();
  body->model_->material = model_->material;
  body->model_->relaxation = model_->relaxation;
  body->model_->contact_material = model_->contact_material;
  body->model_->profile.curve = model_->profile.curve;
  return body;
}

std::shared_ptr<Body> Body::with_profile_alone(double young, double poisson) const {
  auto body = std::make_shared<Body>(context_, static_cast<std::int32_t>(BodyKind::halfspace));
  body->set_elastic(0, young, poisson);
  body->model_->profile.curve = profile();
  return body;
}

bool Body::same_elastic(const Body& other) const {
  if (this == &other) return true;
  const std::scoped_lock lock(mutex_, other.mutex_);
  return model_->contact_material == other.model_->contact_material && model_->relaxation == other.model_->relaxation;
}

double Body::profile_length() const {
  const std::lock_guard lock(mutex_);
  require_profile();
  return model_->profile.curve->length();
}

ProfilePoint Body::profile_point(double s) const {
  require_finite(s, "s");
  const std::lock_guard lock(mutex_);
  require_profile();
  const ProfileCurve& curve = *model_->profile.curve;
  if (!(s >= 0 && s <= curve.length()))
    fail(Status::err_argument, "s is %g; allowed: 0 to %.17g, the length of the profile", s, curve.length());
  return curve.at(s);
}

bool Body::has_surface() const {
  const auto any = [&] { return given().surface.nodes() > 0 || model_->profile.curve; };
  if (prepared()) return any();
  const std::lock_guard lock(mutex_);
  return any();
}

}  // namespace rollcon
