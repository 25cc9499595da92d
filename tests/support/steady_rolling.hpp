#pragma once
/// Cases (a) and (b): a circular contact of identical steel bodies in steady rolling, with longitudinal creepage, and
/// with spin as well (tests/data/steady_rolling_limits.csv).

#include <string>

#include "support/frames.hpp"
#include "support/scene.hpp"

namespace rollcon::scenes::steady_rolling {

inline const Elastic steel{.shear = 82000, .poisson = 0.28};
inline constexpr double mu = 0.3, radius = 5, creepage = -1.13e-3, spin = 3e-4;

inline const closed_forms::Hertz hertz =
    closed_forms::hertz_from_axes(radius, radius, 1000, closed_forms::effective_modulus(steel, steel));

/// which: "a" or "b".
inline void prepare(RollingPair& pair, const SurfaceMesh& mesh, const std::string& which) {
  pair.frame(mesh).gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(mu);
  pair.creep(creepage, 0, which == "b" ? spin : 0);
}

/// N x N nodes at the centres of CONTACT's N x N elements, 90 % of the width in contact.
inline SurfaceMesh grid(int n) {
  const double half = radius / 0.9 * (1 - 1.0 / n);
  const auto lines = frames::uniform_lines(-half, half, n - 1);
  return frames::rectangle(ElementType::quad4, lines, lines);
}

/// CONTACT's error of Fx at N; first order between the sizes it was run at.
inline double contact_error(const std::string& which, int n) {
  const int known = n >= 256 ? 256 : n >= 128 ? 128 : n >= 64 ? 64 : n >= 32 ? 32 : 16;
  return closed_forms::steady_rolling(which, "error_" + std::to_string(known)) * known / n;
}

/// Error of Fx against the extrapolated limit.
inline double force_error(const Solution& s, const std::string& which) {
  return s.force[0] / (mu * hertz.load) / closed_forms::steady_rolling(which, "fx") - 1;
}

}  // namespace rollcon::scenes::steady_rolling
