#pragma once
/// Finds the gap between a wheel's outline and a rail along z, as a function of the parameter s of the wheel's profile.

#include <cmath>

#include "wheelrail/varying_pair.hpp"

namespace rollcon {

struct GapPoint {
  double s;
  Vec3 wheel;   ///< point of the locus
  double gap;   ///< z of the rail less that of the wheel there
  double rise;  ///< slope of the gap by y
  double rail_slope;
  double forward_y;       ///< dy of the locus by s
  double rail_ahead = 0;  ///< dz/dx of a rail that varies

  /// Returns the depth of the overlap along the normal of the rail.
  double depth() const { return -gap / std::sqrt(1 + rail_slope * rail_slope); }
};

/// Holds what a table of the rail says, which is nearly right.
struct RoughGap {
  bool known = false;
  double s = 0, y = 0, gap = 0, rise = 0;
  double slack = 0;  ///< greatest error of gap
};

class ProfileGap {
 public:
  /// Takes what varies in pairs where wheel or rail does, else null.
  ProfileGap(const VisibleProfile& wheel, const VisibleProfile& rail, const WheelLocus& locus,
             const VaryingPair* varying)
      : wheel_(wheel), rail_(rail), locus_(locus), varying_(varying) {}

  const VisibleProfile& wheel() const { return wheel_; }
  const VisibleProfile& rail() const { return rail_; }
  const WheelLocus& locus() const { return locus_; }
  const VaryingPair* varying() const { return varying_; }
  /// Returns the point of the wheel's circle through p that is nearest to the rail along z; nullopt where none can
  /// touch.
  std::optional<LocusPoint> locus_at(const VisiblePoint& p) const {
    return varying_ ? varying_->nearest(locus_, p) : locus_.at(p);
  }

  /// Return nullopt beside the rail, or where the locus has no point.
  std::optional<GapPoint> at(const VisiblePoint& p, double s) const;
  std::optional<GapPoint> at(const LocusPoint& point, double s) const;
  std::optional<GapPoint> at(double s) const { return at(wheel_.at(s), s); }
  std::optional<GapPoint> at(const VisibleSpan& span, double s) const { return at(wheel_.at(span, s), s); }
  /// Returns the point of the rail at this y, which is on it, of one that varies at this x; the search begins where the
  /// last one ended.
  VisiblePoint rail_at(double y, double x) const;
  /// Returns z of the rail at this y, by a cubic in its cell.
  double rail_z(double y) const;
  /// Returns the rough gap at an end of a span of the wheel.
  RoughGap rough(const VisibleSpan& span, std::size_t end) const;

  /// Find where the gap vanishes within a span, and where it is least or greatest. Gaps, or rises, have different signs
  /// at both ends; where they do not, by the rough table's errors, the end with the lesser value is returned.
  GapPoint zero(const VisibleSpan& span, const GapPoint& a, const GapPoint& b) const;
  GapPoint extreme(const VisibleSpan& span, const GapPoint& a, const GapPoint& b) const;
  /// Returns the last point with a gap between two parameters, of which `in` has one.
  GapPoint edge(const VisibleSpan& span, double in, double out) const;

 private:
  const VisibleProfile& wheel_;
  const VisibleProfile& rail_;
  WheelLocus locus_;
  const VaryingPair* varying_;
  mutable std::size_t near_ = 0;
};

}  // namespace rollcon
