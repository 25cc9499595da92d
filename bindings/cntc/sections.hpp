#pragma once
#include <array>
#include <string>
#include <vector>

#include "profile.hpp"
#include "vectors.hpp"

namespace cntc {

constexpr double no_point = 999;  // coordinates where a profile has none

struct SectionPoint {
  Vec3 place{};  // x is 0
  double slope = 0;
};

/// Holds a profile, or one section of a profile that varies, by its arc length from the end where y is less.
class Section {
 public:
  explicit Section(const Profile& profile);
  explicit Section(std::vector<Vec3> points);

  double length() const { return length_; }
  SectionPoint at(double s) const;
  /// Returns the arc length of the point of n that is least by a measure.
  template <class Measure>
  double least(int n, Measure measure) const {
    double best = 0, least = 1e300;
    for (int k = 0; k <= n; ++k) {
      const double s = length() * k / n, off = measure(at(s).place);
      if (off < least) least = off, best = s;
    }
    return best;
  }
  /// Returns the arc length of the point where y is 0, or of the one nearest to that.
  double middle() const;
  /// Returns z at a y, on the branch nearest to the end, or `none` where the section has no such point.
  double z_at(double y, double none) const;

 private:
  const Profile* profile_ = nullptr;
  std::vector<Vec3> points_;
  std::vector<double> arc_;
  double length_ = 0;
};

/// Reads sections of a profile that varies. It stands in a wheel on rail of its own, whose wheel is lifted off.
class Sections {
 public:
  Sections(rollcon_context* context, const Profile& profile, bool wheel);
  /// Returns a point at the place u; share goes from end to end of the section.
  Vec3 point(double u, double share);
  Section at(double u);
  /// Counts lines along the surface, one for each half millimetre of the section nearest to 0.
  double lines() const { return lines_; }

 private:
  BodyHandle partner_;
  WheelHandle pair_;
  bool wheel_, stands_ = false;
  double u_ = 0, lines_ = 0;
};

/// Returns first and last place of the slices that a list (slcs, slcw) names.
std::array<double, 2> slice_range(const std::string& path);

}  // namespace cntc
