#pragma once
/// Finds where circles of a wheel can touch a rail when one of them, or both, vary along the track or round the axis,
/// or the rail is a roller: the gap along z is least there along x.

#include <optional>

#include "wheelrail/slice_heights.hpp"
#include "wheelrail/wheel_locus.hpp"

namespace rollcon {

class VaryingPair {
 public:
  /// Takes heights of what varies, else null, and the rail's profile where it does not; roller: z of the axis about
  /// which the rail's profile is revolved, none for a rail; along: the rail's place where x is 0; turned: angle by
  /// which the wheel has turned from below to ahead; radius: the wheel's.
  VaryingPair(const SliceHeights* wheel, const SliceHeights* rail, const VisibleProfile& rail_profile,
              std::optional<double> roller, double along, double turned, double radius);

  struct Rough {
    double gap, y, slack;  ///< gap: infinite beside the rail; slack: its greatest error
  };
  /// Returns nearly the least gap of the circle at y and z of the wheel's profile.
  Rough rough(const WheelLocus& locus, double y, double z) const;
  std::optional<SliceHeight> rail(double x, double y) const;
  /// Returns the rail's section, at its nearest place to x and y; its slope is that by y.
  VisiblePoint rail_section(double x, double y) const;
  /// Returns the point of the circle through p of the wheel's profile that is nearest to the rail.
  std::optional<LocusPoint> nearest(const WheelLocus& locus, const VisiblePoint& p) const;
  /// Returns the curvature of the gap along the circle there.
  double curvature_along(const WheelLocus& locus, const VisiblePoint& p) const;
  struct Reach {
    double behind = 0, ahead = 0;
    bool parted = false;  ///< there is no overlap somewhere in between
  };
  /// Returns how far along x the circle overlaps behind that point and ahead of it.
  Reach reach(const WheelLocus& locus, const VisiblePoint& p) const;

 private:
  /// Holds the gap at an angle of a circle, and derivatives by the angle t and by y of the wheel's profile.
  struct At {
    Vec3 x{}, t{}, y{}, tt{}, ty{}, yy{};
    double gap, gap_t, gap_y, gap_tt, gap_ty, gap_yy;
    /// Vanishes where the gap is least along x; its derivatives.
    double lean() const { return gap_t * y[1] - t[1] * gap_y; }
    double lean_t() const { return gap_tt * y[1] + gap_t * ty[1] - tt[1] * gap_y - t[1] * gap_ty; }
    double lean_y() const { return gap_ty * y[1] + gap_t * yy[1] - ty[1] * gap_y - t[1] * gap_yy; }
  };
  std::optional<At> at(const WheelLocus& locus, const VisiblePoint& p, double angle) const;
  /// Returns the height of a roller with this section at the distance u from above its axis; nullopt beside it.
  std::optional<SliceHeight> revolved(const SliceHeight& section, double u) const;
  /// Finds the station, 0: the lowest point, where the gap is nearly least; nullopt: beside the rail.
  std::optional<int> best_station(const WheelLocus& locus, double y, double z, double& lowest, double& at_y) const;
  double rough_gap(const WheelLocus& locus, double y, double z, double turn_c, double turn_s, double angle,
                   double& at_y) const;
  double slack(const WheelLocus& locus) const;
  std::optional<At> least_near(const WheelLocus& locus, const VisiblePoint& p, int station, double& angle) const;
  const std::optional<At>& least(const WheelLocus& locus, const VisiblePoint& p) const;

  const SliceHeights *wheel_, *rail_;
  const VisibleProfile& rail_profile_;
  std::optional<double> roller_;
  double along_, turned_;
  double station_;                           ///< angle between places that are tried
  static constexpr int most_stations = 200;  ///< on either side
  int stations_;
  std::array<std::array<double, 2>, 2 * most_stations + 1> turn_;  ///< cosine and sine at each
  mutable std::array<double, 2 * most_stations + 1> station_gap_;  ///< at each, of the last circle
  mutable std::size_t near_ = 0;
  // Members that least() found last follow.
  mutable double angle_ = 0, found_y_ = 0, found_slope_ = 0;
  mutable bool tried_ = false;
  mutable std::optional<At> found_;
};

}  // namespace rollcon
