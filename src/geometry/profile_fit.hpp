#pragma once
/// Fits a profile to points, measured or calculated.

#include <functional>
#include <string>
#include <vector>

#include "geometry/profile_curve.hpp"

namespace rollcon {

/// Says how messages name a point: "point 3 (counting from 0)", "line 12 of rail.txt".
using PointName = std::function<std::string(std::size_t)>;

/// Returns the curve through the points in the order of ascending y: a cubic spline in arc length between kinks. Only
/// its direction is continuous where the points' distances jump fivefold and more. Points nearer to each other than a
/// thousandth of their usual distance are dropped, and where the path goes back and forth again the two are replaced by
/// their mean. If filter_length > 0, the points are smoothed before: waves of that length to one half, shorter ones to
/// nothing. Whatever a caller would not expect is added to `told`, each sentence ending in "; ". Throws err_argument
/// naming the point if there are fewer than two of them, one is far from all plausible lengths, the path turns back,
/// they have no order, or the filter is longer than the curve.
ProfileCurve profile_through(const std::vector<Vec2>& point, double filter_length, const PointName& name,
                             std::string* told = nullptr);

/// Moves points so that the integral of their squared deviation along the curve, plus (L / 2 pi)^6 times that of the
/// squared third derivative, is least; circles keep their curvature up to their ends.
void smooth_points(std::vector<Vec2>& point, double filter_length);

/// Returns cubics through the points with two continuous derivatives, and a third continuous at the last point but one,
/// unless unit tangents at the ends are given.
std::vector<ProfilePiece> spline_through(const std::vector<Vec2>& point, const Vec2* begin = nullptr,
                                         const Vec2* end = nullptr);

}  // namespace rollcon
