#pragma once
/// The surface that carries the contact: whose normals the frame's local axes follow, and where a
/// point of the frame's plane lies on a body.

#include <optional>

#include "bodies/body.hpp"
#include "mesh/frame.hpp"
#include "mesh/pose.hpp"

namespace rollcon {

struct PairOfBodies {
  std::array<const Body*, 2> body{};  ///< prepared
  std::array<Pose, 2> pose{};
};

/// Smooth outward unit normal of a body at a point found on it: mean normals of the fans at the
/// element's nodes, interpolated. In the body's axes.
Vec3 smooth_normal(const Body& body, const SurfacePoint& point);

/// Smooth normals of a body over the plane of the axes, turned to the outward side of body 1. Each
/// body's displacements are taken in its own local directions: those turn with its particles as
/// they roll through, so that its radial displacement is no slip.
class NormalField {
 public:
  /// The body must have a mesh. which: 0 or 1.
  NormalField(const Axes& axes, const Body& body, const Pose& pose, int which);
  Vec3 at(double x, double y) const;

 private:
  Axes axes_;
  const Body& body_;
  Pose pose_;
  double sign_;
};

/// Point of the axes' plane at (x, y), in space.
Vec3 plane_point(const Axes& axes, double x, double y);

}  // namespace rollcon
