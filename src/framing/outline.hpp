#pragma once
/// Describes where one patch of a contact ends, smooth, and its strips along the rolling direction (docs/theory.md, 4).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "framing/makers.hpp"

namespace rollcon {

/// Holds a point where the contact ends; ends_body: it does because a body does.
struct EdgePoint {
  double x = 0, y = 0;
  bool ends_body = false;
};

/// Holds the part of a patch's load that acts at y.
struct LoadAt {
  double y = 0, load = 0;
};

/// Says where strips lie at ends of bodies: closer where a rigid body ends or a half-space is cut off, as pressures
/// have no bound there; evenly where elastic bodies end, which deform.
enum class AtBodyEnds { closer, even };

class Outline {
 public:
  /// Fits one patch to points all around it, in any order, each off by up to a few parts in a hundred of the patch's
  /// size. Along the rolling direction the outermost ones count: strips cover what is not in contact between them.
  /// cell: distances along x and y up to which points are beside each other. At least four points. load: strips lie
  /// closer where its density along y turns more than that of an ellipse.
  Outline(std::span<const EdgePoint> point, std::span<const LoadAt> load, const EdgePoint& cell);
  /// Makes a circle.
  Outline(double x, double y, double radius);

  /// Returns across + 1 strips from side to side of an ellipse, more of other shapes, closer near the sides; twice as
  /// many halve their distances. stretch: factor on the outline, about its middle, except where a body ends.
  std::vector<Strip> strips(std::int64_t across, double stretch, AtBodyEnds at_ends = AtBodyEnds::closer) const;
  /// Says whether the outline ends where a body ends.
  bool ends_body() const { return end_[0].ends_body || end_[1].ends_body; }
  Rectangle box() const;  ///< around the outline
  /// Returns how much shorter a strip is than the straight lines between the ends of two others are there, over the
  /// longest strip: 0 where the outline is convex and the strips' middles lie on a line.
  double hollow() const;
  /// Returns how many times as many strips as an ellipse the outline gets.
  double more_strips() const { return passed_.empty() ? 1 : passed_.back(); }

 private:
  /// Holds half lengths of strips, of an ellipse of height 1, over angles from the upper end to the lower end.
  struct Side {
    std::vector<double> angle, reach, weight;
  };
  double reach(const Side& side, double angle) const;
  double middle(double y) const { return x_middle_ + slant_ * (y - y_middle_); }
  void find_end(std::span<const EdgePoint> point, int which);
  void find_density(std::span<const LoadAt> load, double cell);
  /// Returns the angle of a strip whose number is this fraction of all.
  double angle_of(double part) const;
  /// Returns y over the half height, from the middle, of a strip of an ellipse at that angle.
  double height_of(double angle, AtBodyEnds at_ends) const;

  double x_middle_ = 0, y_middle_ = 0, half_height_ = 0, slant_ = 0;
  std::array<Side, 2> side_;  ///< sides against and along the rolling direction
  /// Holds the lower or upper end: a point, or a line where a body ends there or the contact does at several points.
  struct End {
    double x = 0, y = 0;
    bool line = false, ends_body = false;
  };
  std::array<End, 2> end_;
  /// Strips that an ellipse would have from the upper end to equal steps of the angle, over all that it has; empty: as
  /// many as angle.
  std::vector<double> passed_;
};

}  // namespace rollcon
