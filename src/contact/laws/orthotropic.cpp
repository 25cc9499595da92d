/// Implements friction that differs between two directions of a surface: |(t1/mu1, t2/mu2)| <= p in axes that are
/// turned by an angle, with the slip along the normal of the ellipse or against the traction (docs/friction.md).
///
/// N = R diag(r1, r2) R^T with r_i = mu_i / max(mu1, mu2) makes the ellipse a disk of radius mu p: tau = N^-1 t. Slip
/// normal to the ellipse is against tau for sigma = N s, so the law is Coulomb's for tau and sigma.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "contact/laws/friction_law.hpp"
#include "contact/laws/parameters.hpp"

namespace rollcon {
namespace {

constexpr double most_apart = 1e3;  // greatest ratio of the coefficients

/// Holds a symmetric matrix.
struct Plane2 {
  double xx = 1, xy = 0, yy = 1;
  std::array<double, 2> times(double a, double b) const { return {xx * a + xy * b, xy * a + yy * b}; }
};

Plane2 turned(double first, double second, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {first * c * c + second * s * s, (first - second) * c * s, first * s * s + second * c * c};
}

class Ellipse : public FrictionLaw {
 public:
  Ellipse(double mu1, double mu2, double angle) : mu1_(mu1), mu2_(mu2), angle_(angle) {
    const double largest = std::max(mu1, mu2), r1 = largest > 0 ? mu1 / largest : 1,
                 r2 = largest > 0 ? mu2 / largest : 1;
    // Where the axes do not matter the angle is left out, lest it brings rounding.
    n_ = turned(r1, r2, r1 == r2 ? 0 : angle);
    inverse_ = turned(1 / r1, 1 / r2, r1 == r2 ? 0 : angle);
  }

  std::array<std::array<double, 2>, 2> capacity(double mu, double pressure) const override {
    const double most = mu * pressure;
    return {{{most * n_.xx, most * n_.xy}, {most * n_.xy, most * n_.yy}}};
  }
  bool isotropic() const override { return false; }

 protected:
  std::string describe(const char* slip) const {
    char text[200];
    std::snprintf(text, sizeof text,
                  "friction: orthotropic, %g and %g along axes that are turned by %g (radian), slip %s", mu1_, mu2_,
                  angle_, slip);
    return text;
  }
  /// Maps a traction into the plane of the disk.
  std::array<double, 2> tau(double t1, double t2) const { return inverse_.times(t1, t2); }

  double mu1_, mu2_, angle_;
  Plane2 n_, inverse_;
};

/// Makes the row of a node whose traction P has P(a, p) = p P(a, 1), in terms of a derivative by the scaled slip:
/// `by_t` that by the traction, `by_s` minus that by the slip, both symmetric or not; `per_pressure`: P over p.
TangentialLaw rows(const double (&by_t)[2][2], const double (&by_s)[2][2], const std::array<double, 2>& per_pressure,
                   double pressure, bool bound_follows) {
  TangentialLaw law{};
  law.sliding = true;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      law.own[i][j] = (i == j) - by_t[i][j];
      law.slip[i][j] = by_s[i][j];
    }
    if (bound_follows)
      law.own[i][2] = per_pressure[i];
    else
      law.constant[i] = pressure * per_pressure[i];
  }
  return law;
}

void set_direction(TangentialLaw& law, const std::array<double, 2>& normal) {
  const double length = std::hypot(normal[0], normal[1]);
  law.direction[0] = normal[0] / length;
  law.direction[1] = normal[1] / length;
}

class Associated final : public Ellipse {
 public:
  using Ellipse::Ellipse;

  FrictionTraction traction(const FrictionPoint& p) const override {
    const auto a = augmented(p);
    FrictionTraction t = within_bound(a[0], a[1], std::hypot(a[0], a[1]), p.mu * p.pressure);
    const auto on = n_.times(t.t1, t.t2);
    t.t1 = on[0];
    t.t2 = on[1];
    return t;
  }

  TangentialLaw linearise(const FrictionPoint& p, bool bound_follows) const override {
    const auto a = augmented(p);
    const double length = std::hypot(a[0], a[1]), bound = p.mu * p.pressure;
    if (length < bound) return stick_law();
    if (!(length > 0)) return law_without_friction();
    const double e1 = a[0] / length, e2 = a[1] / length, gamma = bound / length;
    const std::array<double, 2> across = n_.times(-e2, e1);  // N of what is across e; e e^T + it = I
    const std::array<double, 2> by_tau = inverse_.times(-e2, e1);
    double by_t[2][2], by_s[2][2];
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        by_t[i][j] = gamma * across[i] * by_tau[j];
        by_s[i][j] = gamma * across[i] * across[j];
      }
    auto on = n_.times(e1, e2);
    for (double& v : on) v *= p.mu;
    TangentialLaw law = rows(by_t, by_s, on, p.pressure, bound_follows);
    set_direction(law, inverse_.times(e1, e2));
    return law;
  }

  std::array<double, 2> against(const FrictionPoint& p) const override {
    const auto on = tau(p.t1, p.t2);
    const auto normal = inverse_.times(on[0], on[1]);
    const double length = std::hypot(normal[0], normal[1]);
    return {normal[0] / length, normal[1] / length};
  }

  std::string description() const override { return describe("normal to the ellipse"); }

 private:
  std::array<double, 2> augmented(const FrictionPoint& p) const {
    const auto t = tau(p.t1, p.t2);
    const auto s = n_.times(p.rt * p.s1, p.rt * p.s2);
    return {t[0] - s[0], t[1] - s[1]};
  }
};

class Collinear final : public Ellipse {
 public:
  using Ellipse::Ellipse;

  FrictionTraction traction(const FrictionPoint& p) const override {
    const double a1 = p.t1 - p.rt * p.s1, a2 = p.t2 - p.rt * p.s2;
    const auto on = tau(a1, a2);
    return within_bound(a1, a2, std::hypot(on[0], on[1]), p.mu * p.pressure);
  }

  // Linearises P = mu p a / rho with rho = |N^-1 a|, whose gradient is g = N^-2 a / rho.
  TangentialLaw linearise(const FrictionPoint& p, bool bound_follows) const override {
    const double a1 = p.t1 - p.rt * p.s1, a2 = p.t2 - p.rt * p.s2;
    const auto on = tau(a1, a2);
    const double rho = std::hypot(on[0], on[1]), bound = p.mu * p.pressure;
    if (rho < bound) return stick_law();
    if (!(rho > 0)) return law_without_friction();
    const auto g = inverse_.times(on[0] / rho, on[1] / rho);
    const double a[2] = {a1 / rho, a2 / rho}, gamma = bound / rho;
    double by_a[2][2];
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) by_a[i][j] = gamma * ((i == j) - a[i] * g[j]);
    TangentialLaw law = rows(by_a, by_a, {p.mu * a[0], p.mu * a[1]}, p.pressure, bound_follows);
    set_direction(law, g);
    return law;
  }

  std::string description() const override { return describe("against the traction"); }
};

template <class Law>
GivenFriction make(std::span<const double> parameters) {
  const double mu1 = parameters[0], mu2 = parameters[1];
  require_coefficient(mu1, "mu1");
  require_coefficient(mu2, "mu2");
  const double least = std::min(mu1, mu2), largest = std::max(mu1, mu2);
  if (largest > most_apart * least)
    fail(Status::err_argument, "mu1 is %g and mu2 %g; allowed: both 0, or neither more than %g times the other", mu1,
         mu2, most_apart);
  return {std::make_shared<Law>(mu1, mu2, parameters[2]), largest};
}

}  // namespace

GivenFriction make_orthotropic(std::span<const double> parameters) {
  return make<Associated>(parameters);
}

GivenFriction make_orthotropic_collinear(std::span<const double> parameters) {
  return make<Collinear>(parameters);
}

}  // namespace rollcon
