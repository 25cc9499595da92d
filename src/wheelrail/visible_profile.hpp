#pragma once
/// Finds the part of a profile that can be seen along z, from which contact comes: a height z for each y.
///
/// The profile is cut into cells over which it turns little; each is a part of a piece of the curve, so that points are
/// exact. Parts steeper than 89.4 degrees are left out, and so is what hides behind others (rolled-over lips).

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/profile_curve.hpp"

namespace rollcon {

/// Maps the curve's plane into another: origin + y e_y + z e_z, with e_y and e_z unit vectors at right angles; mirrored
/// or not.
struct ProfilePlane {
  Vec2 origin{0, 0}, e_y{1, 0}, e_z{0, 1};
};

/// Tells where a parameter s stands, which is arc length nearly.
struct VisiblePoint {
  double y, z;
  double slope;           ///< dz/dy
  double dy, dz, dslope;  ///< derivatives by s

  /// Returns the curvature, positive where the slope rises.
  double curvature() const;
};

/// Holds values of a cell at its two ends.
struct VisibleCell {
  enum class Kind { curve, line, corner } kind = Kind::curve;
  std::size_t piece = 0;
  std::array<double, 2> u{}, s{}, y{}, z{}, slope{};

  double chord() const { return (z[1] - z[0]) / (y[1] - y[0]); }
  /// Returns z on the cubic through both ends; for an arc that turns by 0.02 it misses 3e-5 of the height.
  double cubic_z(double at) const {
    const double width = y[1] - y[0], t = (at - y[0]) / width, middle = chord();
    return z[0] + width * t * (middle + (1 - t) * ((1 - t) * (slope[0] - middle) - t * (slope[1] - middle)));
  }
};

/// Joins cells of one kind after another, over which the profile turns no more than over a cell of any curve: a spline
/// may have very short ones.
struct VisibleSpan {
  std::size_t first = 0, last = 0;
  std::array<double, 2> s{}, y{}, z{}, slope{};
};

class VisibleProfile {
 public:
  enum class Seen { from_greater_z, from_lesser_z };

  /// Cuts the curve; seen from greater z, corners that stick out are cells of their own, in which only the slope
  /// changes. Throws err_argument where nothing is to be seen.
  VisibleProfile(std::shared_ptr<const ProfileCurve> curve, const ProfilePlane& map, Seen seen);

  const std::vector<VisibleCell>& cells() const { return cell_; }
  const std::vector<VisibleSpan>& spans() const { return span_; }
  VisiblePoint at(const VisibleSpan& span, double s) const { return at_among(span.first, span.last, s); }
  /// Returns the point at s, which lies between those of the first and the last cell.
  VisiblePoint at(double s) const { return at_among(0, cell_.size() - 1, s); }
  /// Returns the point at this y, which is between those of the ends; the search begins at cell `near`.
  VisiblePoint at_y(double y, std::size_t near = 0) const;
  double low() const { return cell_.front().y[0]; }  ///< least y
  double high() const { return cell_.back().y[1]; }  ///< greatest y
  /// Returns the cell at y, which is between those of the ends; `near` is tried first.
  std::size_t cell_at_y(double y, std::size_t near) const;

 private:
  VisiblePoint at(const VisibleCell& cell, double s) const;
  VisiblePoint at_among(std::size_t first, std::size_t last, double s) const;
  VisiblePoint on_curve(std::size_t piece, double u) const;
  void add_piece(std::size_t piece, double longest);
  void add(VisibleCell cell);
  bool keep_steep_out(VisibleCell& cell) const;
  void end_at(VisibleCell& cell, int end, double u) const;
  VisiblePoint at_y(const VisibleCell& cell, double y, double& u) const;
  double u_at_y(const VisibleCell& cell, double y) const;
  void cut_back(double y);
  void bridge_to(const VisibleCell& cell);
  void number();
  void gather_spans(double longest);

  std::shared_ptr<const ProfileCurve> curve_;
  ProfilePlane map_;
  Seen seen_;
  double forward_;  ///< -1: y falls with u
  std::vector<VisibleCell> cell_;
  std::vector<VisibleSpan> span_;
};

}  // namespace rollcon
