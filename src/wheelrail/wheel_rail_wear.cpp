/// Finds wear of wheel and rail under a solution, along their profiles.

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/profile_wear.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {
namespace {

/// Tells where a patch lies in the plane of a profile.
struct PatchOnProfile {
  Vec2 reference{}, lateral{};  ///< lateral: of length 1
  double low = 0, high = 0;     ///< ends of the overlap along it
};

/// Lists points of the profile under the patch by their place along `lateral`, ascending, from the first-th point on
/// (or, where the profile runs the other way, backwards from there).
struct PointsUnderPatch {
  std::vector<double> along;
  std::vector<std::size_t> number;
};

PointsUnderPatch points_under(const PatchOnProfile& patch, const std::vector<Vec2>& point) {
  const auto place = [&](std::size_t j) { return dot(point[j] - patch.reference, patch.lateral); };
  std::size_t nearest = 0;
  for (std::size_t j = 1; j < point.size(); ++j)
    if (length(point[j] - patch.reference) < length(point[nearest] - patch.reference)) nearest = j;
  PointsUnderPatch found;
  const bool forward =
      dot(point[std::min(nearest + 1, point.size() - 1)] - point[nearest > 0 ? nearest - 1 : 0], patch.lateral) > 0;
  // One point beyond the overlap is taken on each side, as long as the profile goes on along the patch.
  std::vector<std::size_t> before, after;
  const auto walk = [&](bool up, std::vector<std::size_t>& to) {
    const double sign = up == forward ? 1 : -1;
    double last = place(nearest);
    std::size_t j = nearest;
    while (up ? j + 1 < point.size() : j > 0) {
      if (last > patch.high || last < patch.low) break;
      j = up ? j + 1 : j - 1;
      if (!(sign * (place(j) - last) > 0)) break;
      last = place(j);
      to.push_back(j);
    }
  };
  walk(true, after);
  walk(false, before);
  if (!forward) std::swap(before, after);
  std::reverse(before.begin(), before.end());
  before.push_back(nearest);
  before.insert(before.end(), after.begin(), after.end());
  for (const std::size_t j : before) found.number.push_back(j), found.along.push_back(place(j));
  return found;
}

}  // namespace

std::vector<Vec2> WheelRail::profile_points(std::int32_t body, std::int64_t n) const {
  const auto curve = body == 1 ? wheel_curve_ : rail_shape_.curve;
  std::vector<Vec2> point;
  for (std::int64_t j = 0; j < n; ++j)
    point.push_back(curve->at(curve->length() * (static_cast<double>(j) / static_cast<double>(n - 1))).x);
  return point;
}

double WheelRail::add_wear(const WearLaw& law, std::int32_t body, const std::vector<Vec2>& point, double weight,
                           double* volume) const {
  require_solved();
  double total = 0;
  for (const Slot* slot : active_) {
    const OverlapPatch& patch = slot->contact.overlap();
    PatchOnProfile on;
    Vec3 lateral = patch.lateral;
    if (body == 1) {
      lateral = slot->contact.pose().turn_back(lateral);
      on.reference = {patch.wheel_y, patch.rolling_radius - radius_};
      on.lateral = {lateral[1], lateral[2]};
    } else {
      const Vec3 across = cross(rail_shape_.down, rail_shape_.along), from = patch.reference - rail_shape_.origin;
      on.reference = {dot(from, across), dot(from, rail_shape_.down)};
      on.lateral = {dot(lateral, across), dot(lateral, rail_shape_.down)};
    }
    on.lateral = (1 / length(on.lateral)) * on.lateral;
    on.low = patch.low;
    on.high = patch.high;
    const PointsUnderPatch under = points_under(on, point);
    // The lateral axis becomes the contact's t2, whose origin is in the middle of the overlap.
    const double sign = dot(slot->contact.axes().t2, patch.lateral) > 0 ? 1 : -1;
    std::vector<double> y, part(under.along.size(), 0.0);
    for (const double t : under.along) y.push_back(sign * (t - 0.5 * (patch.low + patch.high)));
    if (sign < 0) std::reverse(y.begin(), y.end());
    if (y.size() == 1) {
      // All of it belongs to the one point.
      const double whole = slot->contact.contact()->wear(law, {}, 0, nullptr);
      part[0] = weight * patch.share * whole;
      total += patch.share * whole;
    } else {
      total += patch.share * slot->contact.contact()->wear(law, y, weight * patch.share, part.data());
    }
    if (sign < 0) std::reverse(part.begin(), part.end());
    for (std::size_t k = 0; k < part.size(); ++k) volume[under.number[k]] += part[k];
  }
  return total;
}

}  // namespace rollcon
