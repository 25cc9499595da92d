/// Takes, places and returns profiles that bodies carry.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "bodies/body.hpp"
#include "geometry/profile_shapes.hpp"
#include "io/profile_file.hpp"
#include "io/slice_file.hpp"
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

void Body::replace_profile(ProfileCurve curve, const FitReport& fit) {
  const std::lock_guard lock(mutex_);
  require_takes_profile();
  BodyProfile profile;
  profile.curve = std::make_shared<const ProfileCurve>(std::move(curve));
  profile.slice = std::move(model_->profile.slice);
  profile.wave = std::move(model_->profile.wave);
  profile.fit = fit;
  model_->profile = std::move(profile);
}

ProfileFit Body::profile_fit(double filter_length) const {
  require_finite(filter_length, "filter_length");
  const std::lock_guard lock(mutex_);
  return {filter_length,       options_.filter_order, options_.points_alike != 0,
          options_.kink_angle, options_.kink_beside,  options_.zigzag_angle};
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
  std::string told;
  FitReport report;
  const auto name = [](std::size_t i) { return "point " + std::to_string(i) + " (counting from 0)"; };
  ProfileCurve curve = profile_through(point, profile_fit(filter_length), name, &told, &report);
  replace_profile(std::move(curve), report);
  tell_of_profile(told);
}

void Body::set_profile_shape(const char* shape, std::int64_t n, const double* parameters) {
  require_pointer(shape, "shape");
  require_count(n, "n");
  if (n > 0) require_pointer(parameters, "parameters");
  replace_profile(profile_of_shape(shape, {parameters, static_cast<std::size_t>(n)}));
}

namespace {

/// Holds a curve through the points of a file, and what is told of it.
struct ReadProfile {
  ProfileCurve curve;
  std::string told;
  bool reversed;  ///< the file's last point is that of least y
  FitReport report;
};

constexpr std::int32_t mirror_y = 1, mirror_z = 2, mirror_z_by_shape = 4;

/// Says whether z of a wheel or rail counts upwards: what is farthest from most of its points, a flange or the sides of
/// a rail's head, is then at lesser z.
bool counts_upwards(const std::vector<Vec2>& point) {
  std::vector<double> z;
  for (const Vec2& x : point) z.push_back(x[1]);
  const auto [least, greatest] = std::minmax_element(z.begin(), z.end());
  const double low = *least, high = *greatest;
  const auto middle = z.begin() + static_cast<std::ptrdiff_t>(z.size() / 2);
  std::nth_element(z.begin(), middle, z.end());
  return *middle - low > high - *middle;
}

ReadProfile profile_in(const std::string& path, double unit, std::int32_t mirror, const ProfileFit& fit) {
  ProfileFile file = read_profile_file(path);
  const bool upwards = (mirror & mirror_z_by_shape) != 0 && counts_upwards(file.point);
  const std::array<double, 2> factor{mirror & mirror_y ? -unit : unit, upwards || (mirror & mirror_z) ? -unit : unit};
  const double span = std::abs(file.point.back()[0] - file.point.front()[0]);
  for (Vec2& x : file.point)
    for (std::size_t c = 0; c < 2; ++c) x[c] *= factor[c];
  std::string told = file.told.empty() ? "" : path + (": " + file.told) + "; ";
  if (upwards) told += path + ": z counts upwards there, and is turned over; ";
  if (unit == 1 && span < 1)
    told += path + (": the profile spans " + std::to_string(span)) +
            ", taken as it is: of a file in metres 1000 as unit makes millimetres; ";
  const auto name = [&](std::size_t i) { return "line " + std::to_string(file.line[i]) + " of " + path; };
  const bool reversed = file.point.front()[0] > file.point.back()[0];
  FitReport report;
  ProfileCurve curve = profile_through(file.point, fit, name, &told, &report);
  return {std::move(curve), std::move(told), reversed, report};
}

void require_file(const char* path, double unit, std::int32_t mirror, bool by_shape) {
  require_pointer(path, "path");
  require_unit(unit);
  const std::int32_t most = by_shape ? mirror_z_by_shape + mirror_y : mirror_y + mirror_z;
  if (mirror < 0 || mirror > most)
    fail(Status::err_argument, "mirror is %d; allowed: 0, 1 (y), 2 (z), 3 (both)%s", mirror,
         by_shape ? ", 4 (z where the shape says so), 5 (that and y)" : "");
}

}  // namespace

void Body::tell_of_profile(const std::string& told) const {
  if (!told.empty()) context_->log(LogLevel::warning, "%.*s", static_cast<int>(told.size() - 2), told.c_str());
}

void Body::read_profile(const char* path, double unit, std::int32_t mirror, double filter_length) {
  require_file(path, unit, mirror, true);
  ReadProfile read = profile_in(path, unit, mirror, profile_fit(filter_length));
  replace_profile(std::move(read.curve), read.report);
  tell_of_profile(read.told);
}

void Body::read_slices(const char* path, double millimetre, double unit, std::int32_t mirror, double filter_length) {
  require_file(path, unit, mirror, false);
  const ProfileFit fit = profile_fit(filter_length);
  require_finite(millimetre, "millimetre");
  if (!(millimetre > 0)) fail(Status::err_argument, "millimetre is %g; allowed: > 0", millimetre);
  const SliceFile file = read_slice_file(path);
  const double along = file.round ? 1 : millimetre;
  BodyProfile fresh;
  std::string told;
  for (const SliceFile::Slice& given : file.slice) {
    ReadProfile read = profile_in(given.path, unit, mirror, fit);
    fresh.fit.add(read.report);
    ProfileSlice slice{along * given.u, std::make_shared<const ProfileCurve>(std::move(read.curve)), given.feature};
    for (double& s : slice.feature)
      if (s >= 0) s = std::min(millimetre * s, slice.curve->length());
    if (read.reversed) {
      std::reverse(slice.feature.begin(), slice.feature.end());
      for (double& s : slice.feature)
        if (s >= 0) s = slice.curve->length() - s;
    }
    fresh.slice.push_back(std::move(slice));
    told += read.told;
  }
  for (const auto& [amplitude, length, phase] : file.wave)
    fresh.wave.push_back({millimetre * amplitude, along * length, phase});
  fresh.curve = fresh.nominal();
  for (std::size_t i = 1; i < fresh.slice.size(); ++i) {
    const ProfileSlice &before = fresh.slice[i - 1], &slice = fresh.slice[i];
    constexpr double most = 1.2;
    const double ratio = slice.curve->length() / before.curve->length();
    if (slice.feature.empty() && (ratio > most || ratio < 1 / most))
      told += path + (": the slices at " + std::to_string(before.u) + " and " + std::to_string(slice.u)) +
              " differ in length by more than a fifth and have no features: points at equal fractions are joined; ";
  }
  // What no surface can be made of is refused here.
  const ProfileSlices tried(fresh.slice, fresh.wave, file.smooth, file.round ? 2 * std::numbers::pi : 0);
  {
    const std::lock_guard lock(mutex_);
    require_takes_profile();
    model_->profile = std::move(fresh);
    options_.smooth_slices = file.smooth ? 1 : 0;
  }
  tell_of_profile(told);
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

void Body::turn_profile_over() {
  const std::lock_guard lock(mutex_);
  require_profile();
  BodyProfile turned;
  turned.curve = std::make_shared<const ProfileCurve>(turned_over(*model_->profile.nominal()));
  model_->profile = std::move(turned);
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

FitReport Body::fit_report() const {
  const std::lock_guard lock(mutex_);
  return model_->profile.fit;
}

std::shared_ptr<const ProfileCurve> Body::profile() const {
  if (traits_.section && prepared()) {
    const auto boundary = section_profile();
    return {boundary, &boundary->curve};
  }
  const std::lock_guard lock(mutex_);
  require_profile();
  return model_->profile.curve;
}

std::shared_ptr<const ProfileCurve> Body::nominal_profile() const {
  if (traits_.section) return profile();
  const std::lock_guard lock(mutex_);
  require_profile();
  return model_->profile.nominal();
}

void Body::add_slice(double u, std::int64_t n, const double* feature) {
  require_finite(u, "u");
  require_count(n, "n");
  constexpr std::int64_t most = 1000;
  if (n == 1 || n > most)
    fail(Status::err_argument, "n is %lld; allowed: 0, or 2 to %lld", static_cast<long long>(n),
         static_cast<long long>(most));
  if (n > 0) require_pointer(feature, "features");
  ProfileSlice slice{u, nullptr, {feature, feature + n}};
  double before = -1;
  for (std::int64_t i = 0; i < n; ++i) {
    const double s = feature[i];
    if (!std::isfinite(s)) fail(Status::err_nonfinite, "entry %lld of features is %g", static_cast<long long>(i), s);
    if (s >= 0 && !(s >= before))
      fail(Status::err_argument, "entry %lld of features is %g, after %g; allowed: ascending arc lengths, < 0: missing",
           static_cast<long long>(i), s, before);
    if (s >= 0) before = s;
  }
  const std::lock_guard lock(mutex_);
  require_takes_profile();
  require_profile();
  std::vector<ProfileSlice>& all = model_->profile.slice;
  for (const ProfileSlice& s : all) {
    if (s.u == u) fail(Status::err_argument, "u is %g, where a slice is already; allowed: another place", u);
    if (s.feature.size() != slice.feature.size())
      fail(Status::err_argument, "n is %lld; allowed: %lld, as for the slices before", static_cast<long long>(n),
           static_cast<long long>(s.feature.size()));
  }
  slice.curve = model_->profile.curve;
  all.push_back(std::move(slice));
}

void Body::add_wave(double amplitude, double wavelength, double phase) {
  require_finite(amplitude, "amplitude");
  require_finite(wavelength, "wavelength");
  require_finite(phase, "phase");
  if (!(wavelength > 0)) fail(Status::err_argument, "wavelength is %g; allowed: > 0", wavelength);
  const std::lock_guard lock(mutex_);
  require_takes_profile();
  require_profile();
  model_->profile.wave.push_back({amplitude, wavelength, phase});
}

std::shared_ptr<const ProfileSlices> Body::slices() const {
  const std::lock_guard lock(mutex_);
  return slices_of(model_->profile, options_.smooth_slices != 0);
}

std::size_t Body::variations() const {
  const std::lock_guard lock(mutex_);
  const BodyProfile& p = model_->profile;
  return 2 * (p.slice.size() + p.wave.size()) + (options_.smooth_slices != 0 ? 1 : 0);
}

std::shared_ptr<const SectionProfile> Body::section_profile() const {
  const std::lock_guard lock(mutex_);
  if (!boundary_) boundary_ = std::make_shared<const SectionProfile>(profile_of(given().section));
  return boundary_;
}

std::shared_ptr<Body> Body::with_profile_alone() const {
  if (traits_.section) return with_profile_alone(young(), poisson());
  auto body = std::make_shared<Body>(context_, static_cast<std::int32_t>(traits_.kind));
  const std::lock_guard lock(mutex_);
  require_profile();
  body->model_->material = model_->material;
  body->model_->relaxation = model_->relaxation;
  body->model_->contact_material = model_->contact_material;
  BodyProfile& to = body->model_->profile;
  to.curve = model_->profile.nominal();
  to.slice = model_->profile.slice;
  to.wave = model_->profile.wave;
  body->options_.smooth_slices = options_.smooth_slices;
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
