#pragma once
/// Stands a rigid wheelset on rigid rails: for each lateral shift the roll at which both wheels touch, and where.

#include <array>
#include <cstdint>

#include "wheelrail/kinematic_motion.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

class WheelsetGeometry {
 public:
  struct Standing {
    double y = 0, z = 0, roll = 0;          ///< place of the wheelset's centre
    std::array<WheelRail::Touch, 2> touch;  ///< left, right; in the track

    /// Returns the rolling radius on the right less that on the left.
    double difference() const { return touch[1].rolling_radius - touch[0].rolling_radius; }
  };

  /// Takes a left and a right wheel, with track and wheelset set. Both outlive this object.
  WheelsetGeometry(WheelRail& left, WheelRail& right);

  /// Names the point in the wheelset's middle that a shift moves: on the axle, or at the height of the rails, where
  /// wheels that roll without slip move as they head.
  enum class Height { axle, rails };
  /// Finds how the wheelset stands without yaw. err_argument: no roll within a quarter brings both wheels on their
  /// rails.
  Standing at(double shift, Height height);
  /// Finds the motion at the height of the rails. err_argument: there is none. wavelength: with the rolling radius and
  /// the distance of the points of contact where the wheelset runs straight on.
  KinematicMotion motion(double amplitude, double& wavelength);

 private:
  double rise(double shift, Height height, double roll, Standing& standing);

  std::array<WheelRail*, 2> wheel_;
  double radius_, roll_ = 0;
};

}  // namespace rollcon
