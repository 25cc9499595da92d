#pragma once
/// Fits a profile to points, measured or calculated.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/profile_curve.hpp"

namespace rollcon {

/// Says how messages name a point: "point 3 (counting from 0)", "line 12 of rail.txt".
using PointName = std::function<std::string(std::size_t)>;

/// Holds how points become a curve; angles are in degrees.
struct ProfileFit {
  double filter_length = 0;
  std::int64_t filter_order = 3;  ///< 2 or 3: the derivative whose square the filter keeps small
  bool points_alike = false;      ///< every point weighs the same in the filter, else the length of curve beside it
  double kink_angle = 30;         ///< least turn of a kink
  double kink_beside = 1.0 / 3;   ///< a kink's neighbours turn by at most this fraction of it
  double zigzag_angle = 90;       ///< two turns in succession by more, to and fro, are a zig-zag
};

/// Holds what became of the points.
struct FitReport {
  std::int64_t kinks = 0, zigzags = 0;
  double moved = 0;      ///< farthest that the filter moved a point
  double curvature = 0;  ///< largest change of curvature if the filter were applied once more, about what it took away
  double y = 0;          ///< the place of that change
  /// Adds what became of another curve's points.
  void add(const FitReport& other);
};

/// Returns the curve through the points in the order of ascending y: a cubic spline in arc length between kinks. Only
/// its direction is continuous where the points' distances jump fivefold and more. Points nearer to each other than a
/// thousandth of their usual distance are dropped, and where the path goes back and forth again the two are replaced by
/// their mean. If filter_length > 0, the points are smoothed before: waves of that length to one half, shorter ones to
/// nothing. Whatever a caller would not expect is added to `told`, each sentence ending in "; ". Throws err_argument
/// naming the point if there are fewer than two of them, one is far from all plausible lengths, the path turns back,
/// they have no order, or the filter is longer than the curve.
ProfileCurve profile_through(const std::vector<Vec2>& point, const ProfileFit& fit, const PointName& name,
                             std::string* told = nullptr, FitReport* report = nullptr);

/// Moves points so that the integral of their squared deviation along the curve, plus (L / 2 pi)^2m times that of the
/// squared derivative of order m, is least; where m is 3, circles keep their curvature up to their ends.
void smooth_points(std::vector<Vec2>& point, const ProfileFit& fit);

/// Returns cubics through the points with two continuous derivatives, and a third continuous at the last point but one,
/// unless unit tangents at the ends are given.
std::vector<ProfilePiece> spline_through(const std::vector<Vec2>& point, const Vec2* begin = nullptr,
                                         const Vec2* end = nullptr);

}  // namespace rollcon
