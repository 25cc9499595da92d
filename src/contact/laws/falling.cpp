/// Implements friction by slip speed s (docs/friction.md): mu = muk + sum mui f(s/si), with f that falls from 1.
///
/// It is a projection like Coulomb's, onto a disk whose radius follows the slip of the iterate.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "contact/laws/friction_law.hpp"
#include "contact/laws/parameters.hpp"

namespace rollcon {
namespace {

struct Fall {
  double value, slope;  ///< derivative by its argument, not positive
};

Fall linear(double x, std::size_t) {
  return x < 2 ? Fall{1 - x / 2, -0.5} : Fall{0, 0};
}

// Lets the second term fall with the square.
Fall rational(double x, std::size_t term) {
  const double y = term == 0 ? 1 + x : 1 + x * x;
  return {1 / y, -(term == 0 ? 1 : 2 * x) / (y * y)};
}

Fall exponential(double x, std::size_t) {
  const double value = std::exp(-std::numbers::ln2 * x);
  return {value, -std::numbers::ln2 * value};
}

struct Family {
  const char* name;
  Fall (*fall)(double, std::size_t);
};
constexpr Family linear_family{"linear", linear}, rational_family{"rational", rational},
    exponential_family{"exponential", exponential};

struct Term {
  double part = 0, speed = 1;  ///< fraction of the coefficient at rest
};

class Falling final : public FrictionLaw {
 public:
  Falling(const Family& family, double kept, std::array<Term, 2> terms, double mu)
      : family_(family), kept_(kept), terms_(terms), mu_(mu) {}

  FrictionTraction traction(const FrictionPoint& p) const override {
    const double a1 = p.t1 - p.rt * p.s1, a2 = p.t2 - p.rt * p.s2;
    return within_bound(a1, a2, std::hypot(a1, a2), coefficient(p) * p.pressure);
  }

  // Takes the speed at a new slip s along the iterate's direction u, u.s: Newton's row is linear in it and in p.
  TangentialLaw linearise(const FrictionPoint& p, bool bound_follows) const override {
    const double a1 = p.t1 - p.rt * p.s1, a2 = p.t2 - p.rt * p.s2;
    const double length = std::hypot(a1, a2), speed = std::hypot(p.s1, p.s2);
    const Fall at = ratio(p.falling * speed);
    const double bound = p.mu * at.value * p.pressure;
    if (length < bound) return stick_law();
    if (!(length > 0)) return law_without_friction();
    TangentialLaw law{};
    law.sliding = true;
    const double e[2] = {a1 / length, a2 / length}, gamma = bound / length;
    const double slope = p.mu * p.pressure * at.slope * p.falling;  // slope of the bound by the speed
    const double u[2] = {speed > 0 ? p.s1 / speed : 0, speed > 0 ? p.s2 / speed : 0};
    const double across[2] = {-e[1], e[0]};
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const double turns = gamma * across[i] * across[j];
        law.own[i][j] = (i == j) - turns;
        law.slip[i][j] = turns - slope * e[i] * u[j] / p.rt;
      }
      law.constant[i] = -slope * speed * e[i];
      if (bound_follows)
        law.own[i][2] = p.mu * at.value * e[i];
      else
        law.constant[i] += bound * e[i];
    }
    if (slope == 0 || speed == 0) law.direction[0] = e[0], law.direction[1] = e[1];
    return law;
  }

  bool falls() const override { return true; }
  double coefficient(const FrictionPoint& p) const override {
    return p.mu * ratio(p.falling * std::hypot(p.s1, p.s2)).value;
  }
  std::shared_ptr<const FrictionLaw> at_speed(double speed) const override {
    auto law = std::make_shared<Falling>(*this);
    law->rolling_ = speed;
    return law;
  }

  std::string description() const override {
    char text[240];
    std::snprintf(text, sizeof text, "friction: %s in the slip speed, %g at rest, %g kept", family_.name, mu_,
                  kept_ * mu_);
    std::string all = text;
    for (const Term& term : terms_) {
      if (!(term.part > 0)) continue;
      std::snprintf(text, sizeof text, ", %g at %g", term.part * mu_, term.speed);
      all += text;
    }
    return all;
  }

 private:
  /// Returns the ratio to the coefficient at rest, by the slip over rolling speed.
  Fall ratio(double slip) const {
    Fall sum{kept_, 0};
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      if (!(terms_[i].part > 0)) continue;
      const double by = rolling_ / terms_[i].speed;
      const Fall f = family_.fall(slip * by, i);
      sum.value += terms_[i].part * f.value;
      sum.slope += terms_[i].part * by * f.slope;
    }
    return sum;
  }

  const Family& family_;
  double kept_;
  std::array<Term, 2> terms_;
  double mu_, rolling_ = 1;
};

GivenFriction make(const Family& family, std::span<const double> parameters) {
  require_coefficient(parameters[0], "muk");
  if (parameters.size() == 4)
    fail(Status::err_argument, "n is 4; '%s' has 3 or 5 parameters: muk, mu1, s1, and mu2, s2", family.name);
  double mu = parameters[0];
  std::array<Term, 2> terms{};
  for (std::size_t i = 0; 2 * i + 2 < parameters.size(); ++i) {
    const double part = parameters[2 * i + 1], speed = parameters[2 * i + 2];
    require_coefficient(part, i == 0 ? "mu1" : "mu2");
    if (!(speed > 0)) fail(Status::err_argument, "s%d is %g; allowed: > 0", static_cast<int>(i) + 1, speed);
    terms[i] = {part, speed};
    mu += part;
  }
  for (Term& term : terms) term.part = mu > 0 ? term.part / mu : 0;
  return {std::make_shared<Falling>(family, mu > 0 ? parameters[0] / mu : 1, terms, mu), mu};
}

}  // namespace

GivenFriction make_linear(std::span<const double> parameters) {
  return make(linear_family, parameters);
}
GivenFriction make_rational(std::span<const double> parameters) {
  return make(rational_family, parameters);
}
GivenFriction make_exponential(std::span<const double> parameters) {
  return make(exponential_family, parameters);
}

}  // namespace rollcon
