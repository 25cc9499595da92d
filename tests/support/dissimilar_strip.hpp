#pragma once
/// Rolls long rollers of two materials in plane strain, as half-spaces on a strip of finite length (support/strip.hpp).

#include <cmath>
#include <vector>

#include "support/frames.hpp"
#include "support/strip.hpp"

namespace rollcon::scenes {

struct DissimilarStrip {
  Strip strip;
  RollingPair pair;

  /// Takes lines of nodes across the contact, in half-widths, and the load per length.
  DissimilarStrip(const Elastic& body1, const Elastic& body2, double radius, double load, std::vector<double> lines,
                  const char* scheme)
      : strip{closed_forms::hertz_line_from_load(radius, closed_forms::effective_modulus(body1, body2), load), 0},
        pair(body1, body2) {
    strip.half_length = 20 * strip.hertz.a;
    for (double& x : lines) x *= strip.hertz.a;
    const auto mesh = frames::rectangle(ElementType::quad4, lines, strip_lines(strip.half_length, strip.hertz.a));
    std::vector<double> x, y;
    for (const Vec3& node : mesh.node) {
      x.push_back(node[0]);
      y.push_back(node[1]);
    }
    const auto coupling = [](const Elastic& e) { return (1 - 2 * e.poisson) / (4 * std::acos(-1.0) * e.shear); };
    pair.frame(mesh).gap(strip.gap(x, y)).load(strip.total_load());
    pair.creep_field(strip.end_slip(x, y, coupling(body1) - coupling(body2)));
    pair.option("convection", scheme);
  }

  /// Rolls at a longitudinal force over mu times the load; body 1 is driven along +t1. The ends of the strip are
  /// loaded: the frame's rim is in contact by intent.
  Solution roll(double mu, double force_ratio) {
    pair.friction(mu).tangential_force(ROLLCON_LONGITUDINAL, force_ratio * mu * strip.total_load());
    if (pair.solve() != ROLLCON_RIM_CONTACT) throw std::runtime_error("strip: not converged");
    return pair.solution();
  }
};

}  // namespace rollcon::scenes
