#pragma once
/// Applies Kalker's linear theory on an ellipse with a b = 1 between identical half-spaces: three motions so small that
/// hardly anything slips, and the answers that creepage coefficients give to them.

#include <algorithm>
#include <array>
#include <cmath>

#include "support/rolling_errors.hpp"

namespace rollcon::scenes::linear_theory {

inline constexpr double mu = 0.3;

/// Holds C23 and C32, which are equal in theory but two numbers once discretised, and the other coefficients.
struct Coefficients {
  double c11 = 0, c22 = 0, c23 = 0, c32 = 0, c33 = 0;
};

inline closed_forms::Hertz ellipse(double a_over_b, const Elastic& body) {
  return closed_forms::hertz_from_axes(std::sqrt(a_over_b), 1 / std::sqrt(a_over_b), 1000,
                                       closed_forms::effective_modulus(body, body));
}

inline Coefficients table(double a_over_b, double poisson) {
  const closed_forms::Kalker listed = closed_forms::kalker_table(a_over_b, poisson);
  return {listed.c11, listed.c22, listed.c23, listed.c23, listed.c33};
}

/// Holds a creepage by itself, and the answer over `unit`: what friction would carry under mu times the load.
struct Motion {
  const char* name;
  std::array<double, 3> creep;
};

class Motions {
 public:
  /// Takes as `share` the fraction of mu P that a motion would carry without slip by force or by moment, whichever is
  /// more. That load stands for mu P here, in forces and in moments: errors are a fraction of what is carried, not of
  /// what could be.
  Motions(const Coefficients& table, const closed_forms::Hertz& hertz, const Elastic& body, double share)
      : unit_(share * mu * hertz.load), creep_per_unit_(unit_ / body.shear) {
    all = {{{"longitudinal creepage", {creep_per_unit_ / table.c11, 0, 0}},
            {"lateral creepage", {0, creep_per_unit_ / table.c22, 0}},
            {"spin", {0, 0, creep_per_unit_ / std::max(table.c23, table.c33)}}}};
  }

  std::array<Motion, 3> all;

  /// The scales G a b, G (a b)^1.5 and G (a b)^2 are all G.
  RollingAnswer exact(const Motion& motion, const Coefficients& c) const {
    const auto [xi, eta, phi] = motion.creep;
    return {{-c.c11 * xi / creep_per_unit_, -(c.c22 * eta + c.c23 * phi) / creep_per_unit_},
            (c.c32 * eta - c.c33 * phi) / creep_per_unit_};
  }
  RollingAnswer found(const Solution& s) const { return found_forces(s, unit_, 1); }

  /// Returns the coefficients from the answers to all three.
  Coefficients coefficients(const std::array<RollingAnswer, 3>& found) const {
    const double xi = all[0].creep[0] / creep_per_unit_, eta = all[1].creep[1] / creep_per_unit_,
                 phi = all[2].creep[2] / creep_per_unit_;
    return {-found[0].force[0] / xi, -found[1].force[1] / eta, -found[2].force[1] / phi, found[1].moment / eta,
            -found[2].moment / phi};
  }

 private:
  double unit_, creep_per_unit_;
};

}  // namespace rollcon::scenes::linear_theory
