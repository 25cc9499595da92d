/// Coulomb's law as a projection (Alart & Curnier 1991; docs/theory.md, sections 2 and 6).

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/laws/friction_law.hpp"

namespace rollcon {
namespace {

class Coulomb final : public FrictionLaw {
 public:
  FrictionTraction traction(const FrictionPoint& p) const override {
    FrictionTraction t{};
    t.bound = p.mu * p.pressure;
    t.length = std::hypot(p.a1, p.a2);
    const double factor = t.length > t.bound ? t.bound / t.length : 1;
    t.t1 = factor * p.a1;
    t.t2 = factor * p.a2;
    t.sliding = !(t.length < t.bound);
    return t;
  }

  TangentialLaw linearise(const FrictionPoint& p, bool bound_follows) const override {
    const double length = std::hypot(p.a1, p.a2), bound = p.mu * p.pressure;
    if (length < bound) return stick_law();
    TangentialLaw law{};
    law.sliding = true;
    if (!(length > 0)) {  // no friction at this node: lambda_t = 0
      law.own[0][0] = law.own[1][1] = 1;
      return law;
    }
    const double e1 = p.a1 / length, e2 = p.a2 / length;
    const double gamma = bound / length;
    law.direction[0] = e1;
    law.direction[1] = e2;
    // gamma (I - e e^T): the rotation of the slip direction
    const double r11 = gamma * e2 * e2, r12 = -gamma * e1 * e2, r22 = gamma * e1 * e1;
    law.own[0][0] = 1 - r11;
    law.own[0][1] = law.own[1][0] = -r12;
    law.own[1][1] = 1 - r22;
    law.slip[0][0] = r11;
    law.slip[0][1] = law.slip[1][0] = r12;
    law.slip[1][1] = r22;
    if (bound_follows) {
      law.own[0][2] = p.mu * e1;
      law.own[1][2] = p.mu * e2;
    } else {
      law.constant[0] = bound * e1;
      law.constant[1] = bound * e2;
    }
    return law;
  }

  std::array<std::array<double, 2>, 2> capacity(double mu, double pressure) const override {
    return {{{mu * pressure, 0}, {0, mu * pressure}}};
  }

  // A response that is not positive (a node at the rim where material leaves, under the characteristic scheme) allows
  // several tractions; the one taken slides.
  std::array<double, 2> solve(const NodeResponse& response, std::array<double, 2> slip, std::array<double, 2> old,
                              double mu, double pressure) const override {
    const double bound = mu * pressure;
    if (!(bound > 0)) return {0, 0};
    const auto& b = response.b;
    const double s1 = slip[0] - b[0][0] * old[0] - b[0][1] * old[1];
    const double s2 = slip[1] - b[1][0] * old[0] - b[1][1] * old[1];
    // (B + g I) t = -s: what is left of slip is -g t. |t| falls as g grows, from where B + g I is positive.
    const auto with = [&](double g) {
      const double d1 = b[0][0] + g, d2 = b[1][1] + g, det = d1 * d2 - b[0][1] * b[1][0];
      return std::array<double, 2>{-(d2 * s1 - b[0][1] * s2) / det, -(d1 * s2 - b[1][0] * s1) / det};
    };
    const auto length = [](const std::array<double, 2>& t) { return std::hypot(t[0], t[1]); };
    const double least = 0.5 * (b[0][0] + b[1][1]) - 0.5 * std::hypot(b[0][0] - b[1][1], b[0][1] + b[1][0]);
    std::array<double, 2> t = old;
    if (least > 0) {
      t = with(0);
      if (length(t) <= bound) return t;
    }
    double low = std::max(0.0, -least), high = low + std::hypot(s1, s2) / bound;
    for (int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
      const double g = 0.5 * (low + high);
      t = with(g);
      (length(t) > bound ? low : high) = g;
    }
    const double found = length(t);
    return found > 0 && std::isfinite(found) ? std::array<double, 2>{bound * t[0] / found, bound * t[1] / found} : old;
  }
};

}  // namespace

const FrictionLaw& coulomb() {
  static const Coulomb law;
  return law;
}

}  // namespace rollcon
