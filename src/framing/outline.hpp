#pragma once
/// Where one patch of a contact ends, smooth, and its strips along the rolling direction. docs/theory.md, section 4.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "framing/makers.hpp"

namespace rollcon {

/// A point where the contact ends. ends_body: it does because a body does.
struct EdgePoint {
  double x = 0, y = 0;
  bool ends_body = false;
};

class Outline {
 public:
  /// Of one patch, from points all around it, in any order, each off by up to a few parts in a hundred of the patch's
  /// size. Along the rolling direction the outermost ones count: strips cover what is not in contact between them.
  /// cell: distance up to which points are beside each other. At least four points.
  Outline(std::span<const EdgePoint> point, double cell);
  /// A circle.
  Outline(double x, double y, double radius);

  /// across + 1 strips from side to side, closer to each other near the sides. stretch: of the outline, about its
  /// middle, except where a body ends.
  std::vector<Strip> strips(std::int64_t across, double stretch) const;

 private:
  /// Half lengths of strips, of an ellipse of height 1, over angles from the upper end to the lower end.
  struct Side {
    std::vector<double> angle, reach, weight;
  };
  double reach(const Side& side, double angle) const;
  double middle(double y) const { return x_middle_ + slant_ * (y - y_middle_); }
  void find_end(std::span<const EdgePoint> point, int which);

  double x_middle_ = 0, y_middle_ = 0, half_height_ = 0, slant_ = 0;
  std::array<Side, 2> side_;  ///< against and along the rolling direction
  /// Lower and upper end: a point, or a line where a body ends there or the contact does at several points.
  struct End {
    double x = 0, y = 0;
    bool line = false, ends_body = false;
  };
  std::array<End, 2> end_;
};

}  // namespace rollcon
