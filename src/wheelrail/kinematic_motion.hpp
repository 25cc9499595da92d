#pragma once
/// Finds Klingel's motion of a free wheelset with any rolling-radius difference, and the equivalent conicity of EN
/// 15302: that of cones whose wheelset has the same wavelength at the same amplitude.
///
///   y'' = -d(y) / (e r),   cones: d = 2 tan(gamma) y,   wavelength L = 2 pi sqrt(e r / (2 tan(gamma)))
///
/// d: rolling radius on the right less that on the left; e: distance of the points of contact; r: rolling radius; the
/// derivatives by the distance travelled. e r is the same on both sides of the definition: conicity does not depend on
/// it.

#include <functional>

namespace rollcon {

struct KinematicMotion {
  double middle = 0;         ///< lateral position where the wheelset runs straight on
  double low = 0, high = 0;  ///< turning points: high - low is twice the amplitude
  double conicity = 0;
  /// Returns L over sqrt(e r).
  double wavelength() const;
};

/// Finds the motion to 1e-4 of the conicity; d may jump. err_argument: no motion of this amplitude comes back.
KinematicMotion kinematic_motion(const std::function<double(double)>& difference, double amplitude);

}  // namespace rollcon
