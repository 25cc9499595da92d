#pragma once
/// Tells which normals the frame's local axes follow, and where a point of the frame's plane is in space.

#include "bodies/body.hpp"
#include "geometry/pose.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

struct PairOfBodies {
  std::array<const Body*, 2> body{};  ///< prepared
  std::array<Pose, 2> pose{};
  double layer = 0;          ///< layer between them: tangential displacement per traction
  double speed = 0;          ///< rolling speed, of bodies that creep
  bool losses = false;       ///< compliances of sections are those of make_losses()
  bool meshed() const;       ///< true if at least one body has a mesh
  bool creeps() const;       ///< true if the material of at least one relaxes
  bool half_spaces() const;  ///< true if they respond as half-spaces; one may be rigid
};

/// Gives local normals (outward from body 1) over the plane of the axes: normals of body 1 if it has a mesh, else minus
/// those of body 2. They follow the profile across the rolling direction, but along it all have the inclination found
/// at the origin: the bodies flatten each other there, so that pressure acts along one direction and radial
/// displacements are no slip (docs/theory.md, section 11).
class NormalField {
 public:
  /// Requires a mesh of at least one body.
  NormalField(const Axes& axes, const PairOfBodies& pair);
  Vec3 at(double x, double y) const;
  /// Gives a normal, in space, the inclination along the rolling direction that all have.
  Vec3 level(const Vec3& normal) const;

 private:
  Vec3 surface_normal(double x, double y) const;

  Axes axes_;
  const Surface* surface_ = nullptr;
  Pose pose_;
  double sign_ = 1;
  double sine_ = 0, cosine_ = 1;  ///< sine and cosine of the inclination along the rolling direction
};

/// Returns the point of the axes' plane at (x, y), in space.
Vec3 plane_point(const Axes& axes, double x, double y);

}  // namespace rollcon
