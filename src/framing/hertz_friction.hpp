#pragma once
/// Finds which tangential loads friction can carry under the pressures of Hertz: exactly, where frames carry a few per
/// cent less.

#include "contact/newton/friction_limit.hpp"
#include "contact/scene/scene.hpp"

namespace rollcon {

class HertzFriction {
 public:
  HertzFriction();
  /// Returns the utilisation by the tangential loads of the scene, in a contact of this place under this load.
  FrictionShare share(const Scene& scene, const FramePlace& place, double load);

 private:
  std::vector<double> x_, y_, weight_;  ///< points of the unit disc; fractions of the load, sum 1
  Problem problem_;
  std::vector<double> lambda_[3];
};

}  // namespace rollcon
