#pragma once
/// Sets up the third example of Rodriguez-Tembleque and Abascal (Int. J. Solids Struct. 47, 2010): an elastic sphere
/// rolls on a rigid plane under a prescribed tangential force. N, mm, MPa, s.

#include <memory>
#include <string>
#include <vector>

#include "support/frames.hpp"
#include "support/scene.hpp"

namespace rollcon::scenes::example3 {

inline constexpr double radius = 50, young = 1e4, poisson = 0.3, mu = 0.1, load = 298.6;
inline constexpr double force_ratio = 0.75, speed = 0.2 * radius;
inline const closed_forms::Elastic sphere{.shear = young / (2 * (1 + poisson)), .poisson = poisson};

/// Returns the frictionless contact: p0 = 140 MPa, a = 1.0063 mm.
inline closed_forms::Hertz hertz() {
  const double curvature = 1 / (2 * radius);
  return closed_forms::hertz_from_load(curvature, curvature, closed_forms::effective_modulus(sphere), load);
}

struct NamedFrame {
  std::string name;
  SurfaceMesh mesh;
};

/// Returns one of the paper's four frames by node count: 673 (quad4), 1985 (quad8), 703 (tri3), 2745 (tri6).
inline NamedFrame frame(int nodes) {
  const double reach = 1.3 * hertz().a;
  switch (nodes) {
    case 673:
      return {"673 quad4", frames::o_grid(ElementType::quad4, 16, 6, reach, reach)};
    case 1985:
      return {"1985 quad8", frames::o_grid(ElementType::quad8, 16, 6, reach, reach)};
    case 703:
      return {"703 tri3", frames::paper_disc(ElementType::tri3, reach)};
    default:
      return {"2745 tri6", frames::paper_disc(ElementType::tri6, reach)};
  }
}

inline std::unique_ptr<RollingPair> pair(const SurfaceMesh& mesh, const char* scheme, int threads = 1) {
  auto p = std::make_unique<RollingPair>(sphere, std::nullopt, threads);
  const double curvature = 1 / (2 * radius);
  p->frame(mesh).gap_quadratic(curvature, curvature).friction(mu).load(load).speed(speed);
  p->tangential_force(ROLLCON_LONGITUDINAL, force_ratio * mu * load).option("convection", scheme);
  return p;
}

}  // namespace rollcon::scenes::example3
