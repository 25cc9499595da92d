#pragma once
/// The contact of two smooth surfaces that touch at a point, without friction (Hertz): its ellipse from curvatures and
/// load or approach. docs/theory.md, section 4.

namespace rollcon {

/// Gap a x^2 + b y^2 + c x y of the undeformed bodies, as rollcon_contact_set_gap_quadratic takes it.
struct QuadraticGap {
  double a = 0, b = 0, c = 0;
};

/// The larger semi-axis is at `angle` (radian) from the rolling direction.
struct HertzContact {
  double larger = 0, smaller = 0, angle = 0;
  double load = 0, approach = 0, pressure = 0;
};

/// False where the gap has no least curvature > 0: no ellipse bounds the contact.
bool has_ellipse(const QuadraticGap& gap);

/// modulus: E* of the pair; load >= 0, approach any (<= 0: an ellipse of no size). The gap has an ellipse.
HertzContact hertz_by_load(const QuadraticGap& gap, double modulus, double load);
HertzContact hertz_by_approach(const QuadraticGap& gap, double modulus, double approach);

/// How much longer a frame is to be than the ellipse of Hertz: friction of unlike bodies moves the contact's edge.
double stretch_by_friction(double dundurs_beta, double friction);

}  // namespace rollcon
