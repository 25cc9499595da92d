#pragma once
/// Represents a profile: a curve in the plane of y and z, made of pieces - arcs, straight lines and cubics - in the
/// order of arc length.

#include <cstddef>
#include <vector>

#include "geometry/vec2.hpp"

namespace rollcon {

/// Runs with u from 0 to `length` along start + u along + u^2 square + u^3 cube, or, where both of the last two are
/// zero, along the arc with this curvature (0: a line), whose u is its arc length. Positive curvature turns from y to
/// z.
struct ProfilePiece {
  double length = 0;
  Vec2 start{0, 0}, along{1, 0}, square{0, 0}, cube{0, 0};
  double curvature = 0;
  bool operator==(const ProfilePiece&) const = default;
};

/// Holds a point, and its first and second derivative by the piece's parameter, which is nearly arc length.
struct ProfilePoint {
  Vec2 x{0, 0}, d1{0, 0}, d2{0, 0};

  Vec2 tangent() const { return (1 / length(d1)) * d1; }
  double curvature() const {
    const double speed = length(d1);
    return cross(d1, d2) / (speed * speed * speed);
  }
};

struct ProfileBox {
  Vec2 low, high;
};

/// Holds a part of a piece over which the curve turns little.
struct ProfileInterval {
  std::size_t piece;
  double from, to;  ///< bounds of the piece's parameter
  ProfileBox box;
};

class ProfileCurve {
 public:
  /// Takes pieces each of which begins where the one before ends.
  explicit ProfileCurve(std::vector<ProfilePiece> piece);

  double length() const { return start_.back(); }
  const std::vector<ProfilePiece>& pieces() const { return piece_; }
  /// Returns the arc length at which piece i begins.
  double start(std::size_t i) const { return start_[i]; }
  ProfilePoint at(std::size_t piece, double u) const;
  /// Returns the point at arc length s, from 0 to length().
  ProfilePoint at(double s) const;
  /// Returns the arc lengths at which the curve has this y, in ascending order.
  std::vector<double> at_y(double y) const;
  /// Returns the point of the curve nearest to x.
  ProfilePoint nearest(const Vec2& x) const;
  /// Returns points so close to each other that a spline through them is the curve within 1e-9 of its size, where it is
  /// smooth.
  std::vector<Vec2> points() const;

  const std::vector<ProfileInterval>& intervals() const { return interval_; }
  /// Each block joins so many intervals in one box.
  static constexpr std::size_t block = 48;
  const std::vector<ProfileBox>& blocks() const { return block_; }

 private:
  std::vector<ProfilePiece> piece_;
  std::vector<double> start_;
  std::vector<ProfileInterval> interval_;
  std::vector<ProfileBox> block_;
};

/// Returns the mirror image of a curve in the y axis.
ProfileCurve turned_over(const ProfileCurve& curve);

}  // namespace rollcon
