#pragma once
/// Makes scenes of time steps: two equal spheres with closed forms, and those of Kalker's transient.

#include <numbers>

#include "contact/scene_fixture.hpp"

namespace rollcon::contact_test {

enum : std::int32_t { rolling_step = 1, shift_step = 2 };

/// Presses two equal spheres of radius 50 (the pair's curvature has R = 50, as in Cattaneo's example), G = 200, nu =
/// 0.42, mu 0.4.
struct Spheres {
  double g = 200, nu = 0.42, mu = 0.4, load = 9.1954;
  double young = 2 * g * (1 + nu);
  double modulus = young / (1 - nu * nu) / 2, radius = 50;
  double a = std::cbrt(3 * load * radius / (4 * modulus));
  double p0 = 3 * load / (2 * std::numbers::pi * a * a);
  Pair pair{young, nu, young, nu};

  explicit Spheres(int n, const char* operators = "auto", double half = 1.2) {
    const std::vector<double> lines = frames::uniform_lines(-half * a, half * a, n);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    scene().set_gap_quadratic(0.5 / radius, 0.5 / radius, 0);
    pair.friction(mu);
    scene().prescribe(3, 2, load);
    scene().options.set_text("operators", operators);
  }
  Scene& scene() { return pair.contact->scene; }
  Contact& contact() { return *pair.contact; }
  /// Returns Cattaneo's and Mindlin's shift of equal bodies under a force Q of mu P, from nothing.
  double shift(double q) const { return 3 * mu * load * (2 - nu) / (8 * g * a) * (1 - std::pow(1 - q, 2.0 / 3)); }
  double creep() {
    double c[3];
    contact().motion(nullptr, c);
    return c[0];
  }
  double force() {
    double f[3];
    contact().resultant(InAxes::local, f, nullptr);
    return f[0];
  }
};

/// Presses Kalker's two spheres: G = 1, nu = 0.28, a = 3.5, mu = 0.4013.
struct KalkerSpheres {
  static constexpr double g = 1, nu = 0.28, a = 3.5, load = 0.4705, mu = 0.4013;
  Pair pair{2 * g * (1 + nu), nu, 2 * g*(1 + nu), nu};
  explicit KalkerSpheres(int n, const char* operators = "auto", double half = 4.25) {
    const std::vector<double> lines = frames::uniform_lines(-half, half, n);
    pair.frame(frames::rectangle(ElementType::quad4, lines, lines));
    scene().set_gap_quadratic(0.002963, 0.002963, 0);
    pair.friction(mu);
    scene().prescribe(3, 2, load);
    scene().options.set_text("operators", operators);
  }
  Scene& scene() { return pair.contact->scene; }
  Contact& contact() { return *pair.contact; }
  double creep(int which = 0) {
    double c[3];
    contact().motion(nullptr, c);
    return c[which];
  }
};

/// Rolls under changing loads, motions, approach, friction and gap.
inline void change_scene(Scene& scene, int k) {
  const double t = 0.3 * k;
  scene.prescribe(3, 2, KalkerSpheres::load * (1 + 0.3 * std::sin(t)));
  scene.set_creep(-1e-3 * std::cos(t), 4e-4 * std::sin(2 * t), 2e-4 * std::sin(t));
  const double mu = 0.4 + 0.1 * std::cos(t);
  scene.set_friction("coulomb", 1, &mu);
  scene.set_gap_quadratic(0.003 + 2e-4 * std::sin(t), 0.003, 1e-4 * std::cos(t));
}

}  // namespace rollcon::contact_test
