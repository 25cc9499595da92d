#pragma once
/// Provides bodies of the Manchester benchmark, S1002 on a canted 60E1 at a gauge of 1435, and where its wheelset
/// stands; mm.

#include "geometry/profile_shapes.hpp"
#include "support/testing.hpp"
#include "wheelrail/contact_search.hpp"

namespace rollcon::manchester {

constexpr double radius = 460, back_to_back = 1360, flange_back = -70, gauge = 1435, gauge_below = 14;

inline std::shared_ptr<const ProfileCurve> curve(const char* name, double unit = 1) {
  return std::make_shared<const ProfileCurve>(profile_of_shape(name, std::array{unit}));
}

inline WheelShape wheel(double unit = 1) {
  return {curve("s1002", unit), {0, 0, -radius * unit}, {0, 1, 0}, radius * unit};
}

inline RailShape rail(double unit = 1) {
  const double cant = std::atan(1.0 / 40), c = std::cos(cant), s = std::sin(cant), top = 300 * (c - 1) * unit;
  RailShape r{curve("60e1", unit), {}, {1, 0, 0}, {0, s, c}};
  double low = 0, high = r.curve->length() / 2, side = 0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    const Vec2 x = r.curve->at(middle).x;
    side = x[0] * c + x[1] * s;
    (x[1] * c - x[0] * s - top > gauge_below * unit ? low : high) = middle;
  }
  r.origin = {0, gauge * unit / 2 - side, -top};
  return r;
}

/// Returns the pose of a wheelset, with the roll about x within the yaw about z.
inline Pose turned(double roll, double yaw) {
  const double cr = std::cos(roll), sr = std::sin(roll), cy = std::cos(yaw), sy = std::sin(yaw);
  Pose p;
  p.rotation = {{{cy, -sy * cr, sy * sr}, {sy, cy * cr, -cy * sr}, {0, sr, cr}}};
  return p;
}

/// Returns the pose of its right wheel, in the wheel's own axes at the tread's datum; z is that of the wheelset, 0 with
/// the datum at the rail's height.
inline Pose placed(double y, double roll, double yaw, double z, double unit = 1) {
  Pose p = turned(roll, yaw);
  p.translation = Vec3{0, y, z} + unit * (Vec3{0, 0, -radius} + p.turn({0, back_to_back / 2 - flange_back, radius}));
  return p;
}

/// Holds what the benchmark prescribes, for a yaw of 2.4e-3 y, and where CONTACT has the patch on elements of 0.2 mm.
struct Position {
  const char* wheel;
  double side;        ///< -1 for the left wheel
  double y, roll, z;  ///< position of the wheelset
  Vec3 reference;     ///< place in the track
  double angle;
};
constexpr Position positions[] = {{"right, y 0", 1, 0, 0, 0.1981, {0, 751.8726, 0.1252}, -0.0290},
                                  {"right, y 0.5", 1, 0.5, -2.304e-5, 0.1938, {-0.861, 744.5026, 0.4289}, -0.0568},
                                  {"right, y 2", 1, 2, -1.128e-4, 0.1529, {-3.368, 740.9147, 0.6548}, -0.0806},
                                  {"right, y 5", 1, 5, -3.554e-4, 0.0015, {-7.000, 727.0855, 3.0041}, -0.2905},
                                  {"right, y 6.5", 1, 6.5, -4.376e-3, -3.0468, {5.801, 718.4931, 10.365}, -1.1591},
                                  {"left, y 0", -1, 0, 0, 0.1981, {0, -751.8726, 0.1252}, 0.0290},
                                  {"left, y 1", -1, 1, -5.049e-5, 0.1840, {1.796, -755.2440, 0.0467}, 0.0176}};

}  // namespace rollcon::manchester
