#include "contact/prepare/between_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bodies/missed_nodes.hpp"
#include "contact/prepare/preparation.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

class BetweenSurfaces {
 public:
  explicit BetweenSurfaces(const Prepared& on) : axes_(on.frame.axes), pair_(on.pair) { divide(on); }

  /// Returns the way from a point of space along n, out of body 1, to where velocities are compared; size: that of the
  /// elements there. A body that is not met is looked for from the other point. 0: both are missed.
  double distance(const Vec3& from, const Vec3& other, const Vec3& n, double size) const {
    std::array<std::optional<double>, 2> to;
    for (std::size_t b = 0; b < 2; ++b) {
      if (share_[b] == 0) continue;
      to[b] = distance_to(b, from, n, size);
      if (!to[b]) to[b] = distance_to(b, other, n, size);
    }
    if (to[0] && to[1]) return share_[0] * *to[0] + share_[1] * *to[1];
    return to[0] ? *to[0] : to[1].value_or(0);
  }

 private:
  std::optional<double> distance_to(std::size_t b, const Vec3& from, const Vec3& n, double size) const {
    const Surface* const surface = pair_.body[b]->surface();
    if (!surface) return dot(axes_.origin - from, axes_.n) / dot(n, axes_.n);
    const Pose& pose = pair_.pose[b];
    const Vec3 direction = pose.turn_back(n), facing = (b == 0 ? 1.0 : -1.0) * direction;
    return look_aside(pose.to_body(from), direction, size,
                      [&](const Vec3& at) { return surface->distance_near(at, direction, facing, met_[b]); });
  }

  /// Returns the curvature of body b towards the other one, over an interval of t1; none: it does not reach so far.
  std::optional<double> curvature(std::size_t b, const Vec3& middle, double half) const {
    const auto at = distance_to(b, middle, axes_.n, half),
               before = distance_to(b, middle - half * axes_.t1, axes_.n, half),
               after = distance_to(b, middle + half * axes_.t1, axes_.n, half);
    if (!at || !before || !after) return std::nullopt;
    return (b == 0 ? 1 : -1) * (2 * *at - *before - *after) / (half * half);
  }

  // Finds each body's weight where the bodies are nearest to each other.
  void divide(const Prepared& on) {
    const Frame& frame = on.frame;
    const std::vector<double>& gap = on.problem.gap;
    std::size_t nearest = frame.x.size();
    double least = INFINITY, greatest = -INFINITY;
    for (std::size_t k = 0; k < frame.x.size(); ++k) {
      if (!frame.used[k]) continue;
      least = std::min(least, frame.x[k]);
      greatest = std::max(greatest, frame.x[k]);
      if (nearest == frame.x.size() || gap[k] < gap[nearest]) nearest = k;
    }
    // The interval is halved where a body ends in it.
    double half = 0.5 * (greatest - least);
    for (int trial = 0; trial < 4; ++trial, half *= 0.5) {
      const auto first = curvature(0, frame.mesh.node[nearest], half),
                 second = curvature(1, frame.mesh.node[nearest], half);
      if (!first || !second) continue;
      share_ = weights_between(*first, *second, half);
      return;
    }
  }

  const Axes& axes_;
  const PairOfBodies& pair_;
  std::array<double, 2> share_{0.5, 0.5};
  mutable std::array<SurfaceHint, 2> met_;  ///< hints from the point before
};

/// Says whether there is nothing between the frame and the plane of its axes.
bool flat_scene(const Prepared& on) {
  constexpr double rounding = 1e-9;
  if (on.frame.curved() || on.pair.body[0]->surface() || on.pair.body[1]->surface()) return false;
  const double size = rounding * on.problem.length;
  return std::all_of(on.frame.z.begin(), on.frame.z.end(), [size](double z) { return std::abs(z) <= size; });
}

}  // namespace

std::array<double, 2> weights_between(double first, double second, double half) {
  constexpr double conformal = 1e-3, straight = 1e-6, rounding = 1e-9;
  const double sum = first + second;
  if (!(sum > conformal * (std::abs(first) + std::abs(second)) && sum * half > rounding)) return {0.5, 0.5};
  double weight = first / sum;
  for (const double whole : {0.0, 1.0})
    if (std::abs(weight - whole) < straight) weight = whole;
  return {weight, 1 - weight};
}

void find_points_between(Preparation& preparation) {
  const Prepared& on = *preparation.made;
  const Frame& frame = on.frame;
  const Convection& convection = on.problem.convection;
  preparation.origin_between = {0, 0, 0};
  preparation.point_between.clear();
  if (flat_scene(on)) return;
  const BetweenSurfaces between(on);
  const Axes& axes = frame.axes;
  preparation.origin_between[2] = between.distance(axes.origin, axes.origin, axes.n, on.problem.length);
  preparation.point_between.resize(frame.x.size());
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    const Vec3 n = frame.triad(k).n, node{frame.x[k], frame.y[k], frame.z[k]};
    const Vec3 at{convection.slip_x[k], convection.slip_y[k], node[2]};
    const double size = element_size(frame, k);
    const auto in_space = [&](const Vec3& x) { return axes.origin + x[0] * axes.t1 + x[1] * axes.t2 + x[2] * axes.n; };
    // Slip is taken upstream of the node, where the bodies may have ended.
    const double away = between.distance(in_space(at), in_space(node), n, size);
    const Vec3 along{dot(n, axes.t1), dot(n, axes.t2), dot(n, axes.n)};
    preparation.point_between[k] = frame.curved() ? at + away * along : at + Vec3{0, 0, away};
  }
}

}  // namespace rollcon
