#pragma once
/// Rolls in plane strain on a half-space frame of finite length: a strip |y| <= half_length with rolling along x. The
/// undeformed gap is shaped so that the exact pressure is Hertz's line pressure on the whole strip, ends included; the
/// middle section then obeys the plane theory up to tangential end effects of order (a / half_length)^2.

#include <vector>

#include "support/closed_forms.hpp"
#include "support/scene.hpp"

namespace rollcon::scenes {

struct Strip {
  closed_forms::HertzLine hertz;
  double half_length = 20;

  double total_load() const { return 2 * half_length * hertz.load; }
  /// Returns the normal displacement u1 - u2 of the strip's pressure at (x, y), |y| <= half_length.
  double displacement(double x, double y) const;
  double approach() const { return displacement(0, 0); }
  /// Returns the undeformed gap at the nodes, to be used with approach() or total_load().
  std::vector<double> gap(const std::vector<double>& x, const std::vector<double>& y) const;
  /// Returns the rigid slip (pairs, for speed 1) that makes up for what the pressure on the missing parts beyond the
  /// ends would add to the slip of dissimilar bodies. The coupling is the sum of +-(1 - 2 nu)/(4 pi G).
  std::vector<double> end_slip(const std::vector<double>& x, const std::vector<double>& y, double coupling) const;
};

/// Returns lines of nodes y = const of a strip of contact half-width a: the middle, where nothing varies along y, and
/// the ends, whose three-dimensional zone is about a wide. half_length >= 5 a.
std::vector<double> strip_lines(double half_length, double a = 1);

/// Holds values on the line y = 0 ordered by x.
struct Section {
  std::vector<double> x, pressure, traction, lateral;  ///< traction: longitudinal, on body 1
  double load() const;                                 ///< integral of the piecewise linear pressure
  double force() const;
  double lateral_force() const;
};
Section middle_section(const Solution& s);

}  // namespace rollcon::scenes
