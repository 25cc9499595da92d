#include "sections.hpp"

#include <algorithm>
#include <cmath>

#include "inp_reader.hpp"

namespace cntc {
namespace {

constexpr double radius = 500, lifted = -1000, flange_back = 1360;  // mm
constexpr int parts = 800;                                          // of a section
constexpr double between_lines = .5;

}  // namespace

Section::Section(const Profile& profile) : profile_(&profile), length_(profile.length()) {}

Section::Section(std::vector<Vec3> points) : points_(std::move(points)) {
  for (size_t k = 0; k < points_.size(); ++k) {
    if (k > 0) length_ += norm(points_[k] - points_[k - 1]);
    arc_.push_back(length_);
  }
}

SectionPoint Section::at(double s) const {
  SectionPoint p;
  if (profile_) {
    profile_->at(s, p.place[1], p.place[2], p.slope);
    return p;
  }
  const size_t last = points_.size() - 1;
  const size_t k = std::clamp(size_t(std::upper_bound(arc_.begin(), arc_.end(), s) - arc_.begin()), size_t(1), last);
  const double part = arc_[k] - arc_[k - 1], t = part > 0 ? std::clamp((s - arc_[k - 1]) / part, 0., 1.) : 0;
  const Vec3 off = points_[k] - points_[k - 1];
  p.place = points_[k - 1] + t * off;
  p.slope = std::atan2(off[2], off[1]);
  return p;
}

double Section::middle() const {
  const double s = least(5 * parts, [](const Vec3& place) { return std::abs(place[1]); });
  const SectionPoint p = at(s);
  return s - p.place[1] * std::cos(p.slope);
}

double Section::z_at(double y, double none) const {
  for (int k = parts; k > 0; --k) {
    double low = length_ * (k - 1) / parts, high = length_ * k / parts;
    const double before = at(low).place[1] - y, after = at(high).place[1] - y;
    if (before * after > 0 || before == after) continue;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      ((at(middle).place[1] - y) * after <= 0 ? low : high) = middle;
    }
    return at(low).place[2];
  }
  return none;
}

Sections::Sections(rollcon_context* context, const Profile& profile, bool wheel) : wheel_(wheel) {
  lines_ = 2 + std::floor(profile.length() / between_lines);
  create(partner_, rollcon_body_create, context, ROLLCON_BODY_HALFSPACE);
  rollcon_body* body = partner_.get();
  const double unit = 1, zero[3] = {0, 0, 0}, x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
  check(rollcon_body_set_elastic(body, 0, 2e5, .3));
  check(rollcon_body_set_profile_shape(body, wheel ? "60e1" : "s1002", 1, &unit));
  rollcon_body *turning = wheel ? profile.body() : body, *rail = wheel ? body : profile.body();
  check(rollcon_body_extrude_profile(rail, zero, x, z));
  check(rollcon_body_revolve_profile(turning, zero, y, radius));
  create(pair_, rollcon_wheelrail_create, context, turning, rail, ROLLCON_RIGHT);
  rollcon_wheelrail* pair = pair_.get();
  check(rollcon_wheelrail_set_friction(pair, "coulomb", 1, &zero[0]));
  check(rollcon_wheelrail_place_rail(pair, 0, 0, 0));
  check(rollcon_wheelrail_set_wheelset(pair, flange_back, 0, radius));
}

Vec3 Sections::point(double u, double share) {
  if (!stands_ || u != u_) {
    const double position[6] = {wheel_ ? 0 : u, 0, lifted, 0, 0, wheel_ ? -u : 0},
                 velocity[6] = {1, 0, 0, 0, 0, -1 / radius};
    check(rollcon_wheelrail_set_position(pair_.get(), position));
    check(rollcon_wheelrail_set_velocity(pair_.get(), velocity));
    check(rollcon_wheelrail_solve(pair_.get()));
    u_ = u;
    stands_ = true;
  }
  double at[2];
  check(rollcon_wheelrail_get_profile_point(pair_.get(), wheel_ ? ROLLCON_WHEEL : ROLLCON_RAIL, share, at));
  return wheel_ ? Vec3{0, at[0] - flange_back / 2, at[1] - lifted} : Vec3{0, at[0], at[1]};
}

Section Sections::at(double u) {
  std::vector<Vec3> points;
  for (int k = 0; k <= parts; ++k) points.push_back(point(u, double(k) / parts));
  return Section(std::move(points));
}

std::array<double, 2> slice_range(const std::string& path) {
  InpReader list(path);
  const auto scale = list.reals(2, "U_OFFSET, U_SCALE");
  const int n = list.integer("NSLC");
  list.reals(1, "NFEAT");
  list.reals(1, "U_INTPOL");
  double first = 0, last = 0;
  for (int k = 0; k < n; ++k) {
    last = scale[1] * (scale[0] + list.reals(1, "U")[0]);
    if (k == 0) first = last;
  }
  return {first, last};
}

}  // namespace cntc
