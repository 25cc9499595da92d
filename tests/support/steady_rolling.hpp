#pragma once
/// Sets up cases (a) and (b): a circular contact of identical steel bodies in steady rolling, with longitudinal
/// creepage, and with spin as well (tests/data/steady_rolling_limits.csv).

#include <iterator>
#include <map>
#include <string>

#include "support/frames.hpp"
#include "support/rolling_errors.hpp"

namespace rollcon::scenes::steady_rolling {

inline const Elastic steel{.shear = 82000, .poisson = 0.28};
inline constexpr double mu = 0.3, radius = 5, creepage = -1.13e-3, spin = 3e-4;

inline const closed_forms::Hertz hertz =
    closed_forms::hertz_from_axes(radius, radius, 1000, closed_forms::effective_modulus(steel, steel));

/// Takes the case "a" or "b".
inline void prepare(RollingPair& pair, const SurfaceMesh& mesh, const std::string& which) {
  pair.frame(mesh).gap_quadratic(hertz.A, hertz.B).load(hertz.load).friction(mu);
  pair.creep(creepage, 0, which == "b" ? spin : 0);
}

/// Returns N x N nodes at the centres of CONTACT's N x N elements, 90 % of the width in contact.
inline SurfaceMesh grid(int n) {
  const double half = radius / 0.9 * (1 - 1.0 / n);
  const auto lines = frames::uniform_lines(-half, half, n - 1);
  return frames::rectangle(ElementType::quad4, lines, lines);
}

/// Returns CONTACT's error of the force vector at N: linear in 1/N between the sizes that are known, in proportion to
/// it beyond.
inline double contact_error(const std::string& which, int n) {
  const std::map<int, double> known = closed_forms::steady_rolling_by_size(which, "error");
  const auto finer = known.lower_bound(n);
  if (finer == known.begin()) return finer->second * finer->first / n;
  const auto coarser = std::prev(finer);
  if (finer == known.end()) return coarser->second * coarser->first / n;
  const double share = (1.0 / n - 1.0 / finer->first) / (1.0 / coarser->first - 1.0 / finer->first);
  return finer->second + share * (coarser->second - finer->second);
}

/// Returns forces over mu Fn, and the moment over mu Fn a.
inline RollingAnswer found(const Solution& s) {
  return found_forces(s, mu * hertz.load, radius);
}

inline RollingAnswer limit(const std::string& which) {
  const auto entry = [&](const char* what) { return closed_forms::steady_rolling(which, what); };
  return {{entry("fx"), entry("fy")}, entry("mz")};
}

inline RollingErrors errors(const Solution& s, const std::string& which) {
  return rolling_errors(found(s), limit(which));
}

}  // namespace rollcon::scenes::steady_rolling
