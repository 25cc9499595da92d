#pragma once
/// Solves the contact of two smooth surfaces that touch at a point, without friction (Hertz): its ellipse from
/// curvatures and load or approach (docs/theory.md, section 4).

namespace rollcon {

/// Holds the gap a x^2 + b y^2 + c x y of the undeformed bodies, as rollcon_contact_set_gap_quadratic takes it.
struct QuadraticGap {
  double a = 0, b = 0, c = 0;
};

/// Holds the ellipse, its larger semi-axis at `angle` (radian) from the rolling direction.
struct HertzContact {
  double larger = 0, smaller = 0, angle = 0;
  double load = 0, approach = 0, pressure = 0;
};

/// Returns false where the gap has no least curvature > 0: no ellipse bounds the contact.
bool has_ellipse(const QuadraticGap& gap);

/// Returns a gap whose ellipse has this ratio of semi-axes, a along the first.
QuadraticGap gap_with_ratio(double ratio, double modulus);

/// Find the contact of a gap that has an ellipse; modulus: E*; load >= 0, approach any (<= 0: of no size).
HertzContact hertz_by_load(const QuadraticGap& gap, double modulus, double load);
HertzContact hertz_by_approach(const QuadraticGap& gap, double modulus, double approach);

/// Returns a frame's length over the ellipse of Hertz: friction of unlike bodies moves the contact's edge.
double stretch_by_friction(double dundurs_beta, double friction);

}  // namespace rollcon
