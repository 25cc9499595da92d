#pragma once
/// Describes what overlaps of a wheel's outline and a rail are to a contact: where, how deep and how large; and which
/// of them are one patch.

#include <algorithm>
#include <array>
#include <vector>

#include "wheelrail/profile_gap.hpp"

namespace rollcon {

/// Integrates over an overlap across the rail, weighted with depth^2.5: 1, and y and z of the wheel's points from a
/// pole and their products yy, yz, zz.
struct DepthMoments {
  double weight = 0;
  std::array<double, 2> first{};
  std::array<double, 3> second{};

  void add(double w, double y, double z);
  /// Adds moments of another overlap, taken about a pole that is at (y, z) here.
  void add(const DepthMoments& other, double y, double z);
};

struct OverlapPatch {
  Vec3 reference{};            ///< centre of the overlap on the rail, weighted by depth^2.5
  Vec3 normal{}, lateral{};    ///< directions of the contact: upwards out of the rail, and across it to the right
  Vec3 along{1, 0, 0};         ///< direction forwards, at right angles to both
  double angle = 0;            ///< mean of the rail's in that weight: atan dz/dy, negative on a gauge face to the right
  double overlap = 0;          ///< greatest overlap along the normal
  double low = 0, high = 0;    ///< ends of the overlap along the lateral axis from the reference
  double back = 0, front = 0;  ///< ends along x
  /// Weight with which this patch counts: patches apart and the same patches as one have weights that add up to 1. It
  /// counts at levels from `apart` to apart + share. At level 0 all overlaps that may merge are one patch; towards
  /// level 1 they are single.
  double share = 1;
  double apart = 0;            ///< first of its levels
  bool cut = false;            ///< the overlap ends where a profile does, or where it is too steep to be seen
  bool parted = false;         ///< along x the overlap has two parts somewhere
  double wheel_y = 0;          ///< y of the wheel's profile at the reference, its own
  double rolling_radius = 0;   ///< rolling radius there
  LocusCurvature curvature{};  ///< of both surfaces together there
  Vec3 wheel{};                ///< the wheel's point there
  /// Members that a Hertzian contact in place of the patch is made of. A paraboloid has fullness 1 and the spread of
  /// its half-width squared over 8.
  double fullness = 0;  ///< mean depth, as depth^2.5 weighs it, over that of a paraboloid of this overlap and spread
  double spread = 0;    ///< mean square of the lateral distance from the centre of depth^2.5
  /// Returns the part of the other one's levels at which this patch counts, too.
  double beside(const OverlapPatch& other) const {
    const double both = std::min(apart + share, other.apart + other.share) - std::max(apart, other.apart);
    return other.share > 0 ? std::max(0.0, both) / other.share : 0;
  }
};

/// Holds an interval of s in which the gap is negative and has one least value.
struct Overlap {
  GapPoint from, to;
  GapPoint deepest;
  bool cut = false, grown = false;  ///< grown: together with the one before
  bool parted = false;              ///< a circle of the wheel overlaps in two parts
  // Integrals over the interval, filled in by measure():
  double weight = 0, y = 0, x = 0, angle = 0;  ///< integrals of depth^2.5, and of y, x and the angle with it
  double ahead = 0;                            ///< integral of the rail's slope along x with it
  DepthMoments moments;                        ///< moments about the deepest point
  double back = 0, front = 0;                  ///< ends of the overlap along x
  double size = 0;                             ///< mean radius of contact
};

void measure(const ProfileGap& gap, Overlap& overlap);

/// Says when neighbouring overlaps are one patch.
struct MergeRule {
  bool planar = true;   ///< normals that differ set them apart
  double distance = 1;  ///< from which they are apart, over the sum of their radii of contact
  double angle = 0.55;  ///< between their normals, from which they are apart, radian
};

/// Joins overlaps, in the order of s, to patches. side: -1 where the
/// profile's y points to the left; radius: that of the wheel at z = 0.
void gather(const ProfileGap& gap, const std::vector<Overlap>& overlap, const MergeRule& rule, double side,
            double radius, std::vector<OverlapPatch>& patch);

}  // namespace rollcon
