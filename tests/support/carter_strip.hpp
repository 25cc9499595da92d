#pragma once
/// Sets up Carter's problem for tests and benches: identical steel cylinders, a = 1 mm, R = 500 mm,
/// mu = 0.3, creepage -2.4e-4 (F/(mu P) = 0.64), on strips of finite length (support/strip.hpp).

#include <algorithm>
#include <cmath>

#include "support/frames.hpp"
#include "support/rolling_errors.hpp"
#include "support/strip.hpp"

namespace rollcon::scenes {

inline constexpr const char* schemes[] = {"godunov", "least_squares", "characteristic"};

inline const Elastic roller{.shear = 82000, .poisson = 0.28};
inline const closed_forms::Carter carter{
    .hertz = closed_forms::hertz_line_from_width(500, closed_forms::effective_modulus(roller, roller), 1),
    .mu = 0.3,
    .xi = -2.4e-4};

/// Returns `across` equidistant nodes inside |x| < 1 with the contact's edge midway between two nodes (shift 0.5) or on
/// a node (shift 0 or 1), and a margin of a tenth of the contact on both sides.
inline std::vector<double> strip_nodes(int across, double shift = 0.5) {
  const double h = 2.0 / across;
  const int margin = std::max(2, across / 10);
  std::vector<double> x;
  for (int k = -margin; k < across + margin; ++k) x.push_back(-1 + (k + shift) * h);
  return x;
}

/// Returns lines graded to both edges of the contact, x = cos(theta), mirrored outside.
inline std::vector<double> graded_nodes(int n) {
  const std::vector<double> inside = frames::cosine_lines(1, n);
  std::vector<double> x;
  for (int k = 4; k >= 1; --k) x.push_back(-2 - inside[static_cast<std::size_t>(k)]);
  x.insert(x.end(), inside.begin(), inside.end());
  for (std::size_t k = 1; k <= 4; ++k) x.push_back(2 - inside[inside.size() - 1 - k]);
  return x;
}

struct CarterErrors {
  double load = 0, force = 0, traction = 0;
  double force_ratio = 0;  ///< longitudinal force found, over mu P
};

/// Compares the middle section with the closed form: normal load, force vector over mu P relative (none is lateral),
/// and the relative L2 norm of the nodal tractions.
inline CarterErrors compare(const Section& section) {
  CarterErrors error;
  error.load = section.load() / carter.hertz.load - 1;
  const double unit = carter.mu * section.load();
  error.force_ratio = section.force() / unit;
  error.force =
      rolling_errors({{error.force_ratio, section.lateral_force() / unit}, 0}, {{carter.force_ratio(), 0}, 0}).force;
  double difference = 0, norm = 0;
  for (std::size_t k = 1; k + 1 < section.x.size(); ++k) {
    const double width = 0.5 * (section.x[k + 1] - section.x[k - 1]);
    const double q = carter.traction(section.x[k]);
    difference += width * std::pow(section.traction[k] - q, 2);
    norm += width * q * q;
  }
  error.traction = std::sqrt(difference / norm);
  return error;
}

/// Sets the strip's gap, approach, creepage and friction for the nodes of a frame given in the strip's coordinates.
inline void load_strip(RollingPair& pair, const Strip& strip, const SurfaceMesh& mesh) {
  std::vector<double> x, y;
  for (const Vec3& node : mesh.node) {
    x.push_back(node[0]);
    y.push_back(node[1]);
  }
  pair.gap(strip.gap(x, y)).approach(strip.approach()).friction(carter.mu);
  pair.creep(carter.xi, 0, 0);
}

}  // namespace rollcon::scenes
