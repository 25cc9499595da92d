#pragma once
/// Makes profiles in closed form.

#include <span>
#include <string>

#include "geometry/profile_curve.hpp"

namespace rollcon {

/// Makes a profile by name and parameters (lengths and their inverses):
/// - "line" half_width, slope: z = slope y; a cylinder or a cone when turned;
/// - "arc" radius, half_width: circle through (0, 0) whose middle is at z = -radius; up to a half of it;
/// - "arcs" y, z, angle of the start, then length and curvature of each arc (0: a line), each going on in the direction
///   in which the one before ends; positive curvature turns from y to z;
/// - "s1002" unit: the wheel, in lengths of which `unit` is a millimetre; the tread's datum at (0, 0), z towards the
///   flange's tip, the flange at y < 0;
/// - "60e1" unit: the head of the rail, upright, its top at (0, 0), z downwards, to 35 mm below the top.
/// Throws err_argument.
ProfileCurve profile_of_shape(const std::string& name, std::span<const double> parameter);

}  // namespace rollcon
