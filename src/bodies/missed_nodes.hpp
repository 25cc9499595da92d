#pragma once
/// Follows lines from a frame's nodes to the contact faces of a body, and reports nodes whose line meets none.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bodies/body.hpp"
#include "geometry/pose.hpp"
#include "mesh/frame.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {

/// Distance over the size of an element at which nodes so far apart across the line are one, and a line that misses an
/// edge by so much meets it.
inline constexpr double coincidence = 1e-6;

/// Returns the size of the elements around a frame node; at a corner of a quadratic one its own cell is far smaller.
inline double element_size(const Frame& frame, std::size_t k) {
  return 4 * std::sqrt(frame.cell_area[k]);
}

/// Calls look(point) for a point in the body's axes and, if that gives nothing, for points a little aside of the line
/// with that direction: a frame that ends where the body does must not miss it by rounding of its coordinates.
template <class F>
auto look_aside(const Vec3& from, const Vec3& direction, double size, F look) {
  auto found = look(from);
  if (found) return found;
  const Vec3 u = normalized(cross(direction, std::abs(direction[0]) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(direction, u);
  for (int i = 0; i < 8 && !found; ++i) {
    const double angle = i * std::numbers::pi / 4, r = coincidence * size;
    found = look(from + r * std::cos(angle) * u + r * std::sin(angle) * v);
  }
  return found;
}

/// Finds where the line from frame node k along n, out of body 1, meets the contact faces of body `which` (0 or 1) that
/// look towards the other body. The point is in the body's axes.
std::optional<SurfacePoint> meet_contact_faces(const Frame& frame, std::size_t k, const Vec3& n, const Body& body,
                                               const Pose& pose, int which);

/// Collects frame nodes whose lines lead to no contact face of a body.
class MissedNodes {
 public:
  MissedNodes(const Frame& frame, const Body& body, const Pose& pose, int which)
      : frame_(frame), body_(body), pose_(pose), which_(which) {}
  void add(std::size_t k, const Vec3& n) { missed_.emplace_back(k, n); }
  /// Throws err_mesh with their number and the first of them, by what lies there: nothing (the frame is larger than the
  /// body), faces that may not come into contact, contact faces seen from behind.
  void fail_if_any() const;

 private:
  std::string off_profile() const;
  std::string off_faces() const;

  const Frame& frame_;
  const Body& body_;
  const Pose& pose_;
  int which_;
  std::vector<std::pair<std::size_t, Vec3>> missed_;
};

}  // namespace rollcon
