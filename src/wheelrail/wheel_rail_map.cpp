/// Maps how a table's ellipse follows from a patch, over the place on the wheel's profile and the depth of the overlap.

#include <algorithm>
#include <bit>
#include <cmath>

#include "bodies/pair.hpp"
#include "contact/results/equivalent_ellipse.hpp"
#include "support/checksum.hpp"
#include "wheelrail/false_position.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

// Distances of the map's nodes: along the profile and between shifts that are tried, over the wheel's radius, and of
// the depths' logarithms.
constexpr double spacing = 1.0 / 400, shift = 1.0 / 400, spacing_of_depths = 0.4;
constexpr int places_tried = 20;
constexpr double least_rise = 0.02;  // least rise of y by arc length of what is seen
// Depths over the radius between which there is a map: shallower patches are like the least one.
constexpr double least_depth = 2e-6, greatest_depth = 2e-3;
// Patches with two peaks fill less of the ellipse; they are solved in full.
constexpr double filled_by_two = 0.6, filled_by_one = 0.75;

}  // namespace

void WheelRail::place_profiles(Body& wheel, Body& rail) const {
  const Vec3 centre{0, 0, -radius_}, axis{0, 1, 0};
  wheel.revolve_profile(centre.data(), axis.data(), radius_);
  const Vec3& origin = rail_shape_.origin;
  if (!rail_shape_.roller)
    return rail.extrude_profile(origin.data(), rail_shape_.along.data(), rail_shape_.down.data());
  const Vec3 below{0, origin[1], *rail_shape_.roller};
  rail.revolve_profile(below.data(), axis.data(), *rail_shape_.roller - origin[2]);
}

// Everything that the map depends on goes into its key.
void WheelRail::prepare_map() {
  if (!in_.table || (map_ && map_table_ == in_.table && map_dimensions_ == dimensions_)) return;
  const CommonElasticity common = common_elasticity(*wheel_, *rail_);
  Checksum sum;
  const auto add = [&](auto... v) {
    const double all[] = {(v + 0.0)...};  // without signs of zeros
    sum.add(all, sizeof all);
  };
  add(1.0, spacing, spacing_of_depths, common.poisson, track_->gauge, track_->height, track_->cant, back_to_back_,
      flange_back_, radius_);
  for (const auto& curve : {wheel_curve_, rail_shape_.curve})
    for (const ProfilePiece& p : curve->pieces())
      add(p.length, p.start[0], p.start[1], p.along[0], p.along[1], p.square[0], p.square[1], p.cube[0], p.cube[1],
          p.curvature);
  map_ = in_.table->map(sum.value());
  map_table_ = in_.table;
  map_dimensions_ = dimensions_;
  const double young = 2 * common.shear * (1 + common.poisson);
  const auto wheel = wheel_->with_profile_alone(young, common.poisson),
             rail = rail_->with_profile_alone(young, common.poisson);
  place_profiles(*wheel, *rail);
  map_along_.clear();
  const double length = wheel_curve_->length();
  const int steps = 8 + 8 * static_cast<int>(length / (spacing * radius_));
  for (int k = 0; k <= steps; ++k) {
    const double s = length * k / steps;
    const ProfilePoint p = wheel_curve_->at(s);
    if (const double rise = p.tangent()[0]; std::abs(rise) > least_rise) map_along_.push_back({p.x[0], s, 1 / rise});
  }
  // Overhanging parts of a profile, which are not seen, count for nothing.
  std::stable_sort(map_along_.begin(), map_along_.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  map_contact_ = std::make_unique<PatchContact>(context_, wheel, rail);
}

// Interpolates the arc length of the wheel's profile by cubics.
double WheelRail::along_profile(double y) const {
  const auto above = std::clamp(
      std::upper_bound(map_along_.begin(), map_along_.end(), y, [](double v, const auto& p) { return v < p.y; }),
      map_along_.begin() + 1, map_along_.end() - 1);
  const AlongProfile &a = above[-1], &b = above[0];
  const double width = b.y - a.y, t = width > 0 ? std::clamp((y - a.y) / width, 0.0, 1.0) : 0, u = 1 - t;
  return u * u * ((1 + 2 * t) * a.s + t * width * a.by_y) + t * t * ((1 + 2 * u) * b.s - u * width * b.by_y);
}

// Sinks a wheel without roll and yaw until the patch nearest to the place is as deep; returns how far the patch is from
// it, nothing where the wheel is beside the rail.
std::optional<double> WheelRail::sink_for_map(double y, double wheel_y, double depth) {
  constexpr int most = 12;
  map_in_.position.y = y;
  const double touch = search_->first_touch(motion_at(0, map_in_).pose);
  if (!std::isfinite(touch)) return std::nullopt;
  double z = touch + depth;
  const auto far = [&](const OverlapPatch& p) { return std::abs(p.wheel_y - wheel_y); };
  for (int i = 0; i < most; ++i) {
    map_motion_ = motion_at(z, map_in_);
    search_->find(map_motion_.pose, map_found_);
    if (map_found_.empty()) return std::nullopt;
    map_patch_ = *std::min_element(map_found_.begin(), map_found_.end(),
                                   [&](const auto& a, const auto& b) { return far(a) < far(b); });
    const double missing = depth - map_patch_.overlap;
    if (std::abs(missing) < 1e-12 * radius_) break;
    z += missing / std::cos(map_patch_.angle);
  }
  return map_patch_.wheel_y - wheel_y;
}

CreepMap::Node WheelRail::map_node(const CreepMap::Place& place) {
  const double along = static_cast<double>(place.first) * spacing * radius_;
  if (!(along >= 0 && along <= wheel_curve_->length())) return {};
  const double wheel_y = wheel_curve_->at(along).x[0],
               depth = radius_ * std::exp(static_cast<double>(place.second) * spacing_of_depths);
  map_in_.velocity.x = radius_;
  map_in_.velocity.pitch = -1;
  const auto off = [&](double y) { return sink_for_map(y, wheel_y, depth); };
  const double near = 1e-9 * radius_;
  std::optional<double> before;
  for (int k = -places_tried; k <= places_tried; ++k) {
    const double y = k * shift * radius_;
    const std::optional<double> here = off(y);
    const std::optional<double> last = std::exchange(before, here);
    if (!here || !last || (*here < 0) == (*last < 0)) continue;
    double left = *here;
    false_position(
        y - shift * radius_, *last, y, *here, [&](double s) { return left = off(s).value_or(left); },
        [&](double f) { return std::abs(f) < near; });
    if (std::abs(left) > 1e3 * near) continue;
    if (const auto found = map_contact_->calibration(map_patch_, map_motion_, *in_.table))
      return {true, std::bit_cast<CreepMap::Numbers>(*found)};
    break;
  }
  return {};
}

// Finds the patch's calibration and how far it is trusted; what has none is solved in full.
void WheelRail::calibrate(const OverlapPatch& patch, double give_way, PatchFriction& friction) {
  const double depth = std::max(patch.overlap - give_way, least_depth * radius_);
  friction.trust = 0;
  if (!friction.table || patch.cut || depth > greatest_depth * radius_) return;
  prepare_map();
  if (map_along_.size() < 2) return;
  CreepMap::Numbers numbers;
  const auto find = [this](const CreepMap::Place& place) { return map_node(place); };
  const double within = map_->at(along_profile(patch.wheel_y) / (spacing * radius_),
                                 std::log(depth / radius_) / spacing_of_depths, find, numbers);
  if (within == 0) return;
  friction.calibration = std::bit_cast<PatchCalibration>(numbers);
  const double s =
      std::clamp((friction.calibration.filled - filled_by_two) / (filled_by_one - filled_by_two), 0.0, 1.0);
  friction.trust = within * s * s * (3 - 2 * s);
}

}  // namespace rollcon
