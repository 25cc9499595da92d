#pragma once
/// Represents the line in which the plane across the rolling direction meets the surface of a conformal contact.

#include <cstddef>
#include <vector>

namespace rollcon {

class SectionLine {
 public:
  /// Is one of the line's points: where, how high above the plane of the axes, and the angle of its tangent with that
  /// plane, about the rolling direction, from t2 towards n.
  struct Place {
    double y = 0, height = 0, angle = 0;
  };
  /// Takes at least one place, y ascending, angles less than a right one. The line is a circular arc between two of
  /// them, and goes on straight beyond the ends.
  explicit SectionLine(std::vector<Place> place);

  struct Point {
    double arc = 0;  ///< length from the first place
    double angle = 0;
  };
  Point at(double y) const;

 private:
  std::vector<Place> place_;
  std::vector<double> arc_;

  double arc_from(std::size_t i, double y, double& angle) const;
};

}  // namespace rollcon
