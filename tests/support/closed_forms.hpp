#pragma once
/// Provides closed forms and published numbers of contact mechanics, for tests and benches, without the library.
/// Half-spaces have semi-axes a along rolling (x) and b across, the undeformed gap h = A x^2 + B y^2, and 1/E* =
/// (1-nu1^2)/E1 + (1-nu2^2)/E2.

#include <map>
#include <string>
#include <vector>

namespace rollcon::closed_forms {

/// Holds isotropic elastic constants given by shear modulus and Poisson's ratio.
struct Elastic {
  double shear = 1, poisson = 0;
  double young() const { return 2 * shear * (1 + poisson); }
};

double effective_modulus(const Elastic& body1, const Elastic& body2);  ///< E*
double effective_modulus(const Elastic& body);                         ///< E*, on a rigid body

/// Holds complete elliptic integrals of the parameter m = 1 - m1 by the arithmetic-geometric mean, and (K - E)/K, which
/// keeps its digits as m goes to 0.
struct EllipticIntegrals {
  double k = 0, e = 0, k_minus_e_over_k = 0;
};
EllipticIntegrals elliptic_integrals(double m1);

/// Describes frictionless contact of quadratic surfaces (Hertz). The semi-axis a belongs to A, b to B.
struct Hertz {
  double A = 0, B = 0, a = 0, b = 0, p0 = 0, load = 0, approach = 0;
  double pressure(double x, double y) const;
};
Hertz hertz_from_load(double A, double B, double e_star, double load);
Hertz hertz_from_approach(double A, double B, double e_star, double approach);
/// Returns the curvatures that give semi-axes a, b at peak pressure p0.
Hertz hertz_from_axes(double a, double b, double p0, double e_star);

/// Describes line contact of a cylinder of combined radius R, with the load per length.
struct HertzLine {
  double radius = 0, a = 0, p0 = 0, load = 0, e_star = 0;
  double pressure(double x) const;
  double gap(double x) const;  ///< deformed gap outside the contact, 0 inside
};
HertzLine hertz_line_from_load(double radius, double e_star, double load);
HertzLine hertz_line_from_width(double radius, double e_star, double a);

/// Describes Carter's steady rolling of identical cylinders, xi > 0 or < 0; the traction on body 1 opposes the slip V
/// xi. The stick zone touches the leading edge x = +a.
struct Carter {
  HertzLine hertz;
  double mu = 0, xi = 0;
  double stick_half_length() const;  ///< a' = a - |xi| R/mu, not below 0
  double force_ratio() const;        ///< F/(mu P), sign opposite to xi
  double traction(double x) const;
};

/// Holds Kalker's creepage coefficients: Fx = -G a b C11 xi, Fy = -G a b C22 eta - G (ab)^1.5 C23 phi, Mz = G (ab)^1.5
/// C23 eta - G (ab)^2 C33 phi.
struct Kalker {
  double c11 = 0, c22 = 0, c23 = 0, c33 = 0;
};
/// Returns an entry of Kalker's table: a/b in {0.1 .. 1, 1/0.9 .. 10}, nu in {0, 0.25, 0.5}; throws otherwise.
Kalker kalker_table(double a_over_b, double nu);

struct CreepPoint {
  double xi = 0, force_ratio = 0;
};
std::vector<CreepPoint> creep_curve();  ///< rows of tests/data/creep_curve.csv

struct BentallJohnson {
  double mu = 0, force_ratio = 0, xi = 0, p0 = 0;
};
std::vector<BentallJohnson> bentall_johnson();  ///< rows of tests/data/bentall_johnson.csv
/// Returns the creepage of free rolling with vanishing friction, xi = 0.457 kappa a/R, recomputed from the condition
/// that as much load slips forwards as backwards.
double bentall_johnson_vanishing(const Elastic& body1, const Elastic& body2, double a, double radius);
/// Returns the creepage of free rolling without slip (Bufler): p + i q is bounded at both edges, where it behaves like
/// a distance to the power 1/2 +- i eta, eta = ln((1 + beta)/(1 - beta))/(2 pi), beta Dundurs' constant. Then xi = 2
/// eta a/R, P = pi E* a^2 (1 + 4 eta^2)/(4 R), and F = 0 of itself. The load is per length.
double no_slip_free_rolling(const Elastic& body1, const Elastic& body2, double load, double radius);

/// Returns an entry of tests/data/steady_rolling_limits.csv; throws when there is none.
double steady_rolling(const std::string& which_case, const std::string& quantity);
/// Returns the entries `quantity`_N by N.
std::map<int, double> steady_rolling_by_size(const std::string& which_case, const std::string& quantity);

/// Returns the rows of a data file; comments (#) and the heading are skipped.
std::vector<std::vector<std::string>> read_table(const std::string& file);

}  // namespace rollcon::closed_forms
