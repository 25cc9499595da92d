/// Implements friction that depends on the temperature of the surfaces where they touch: linear between given points,
/// constant beyond them (docs/friction.md).

#include <algorithm>
#include <cstdio>
#include <vector>

#include "contact/laws/coulomb_given.hpp"
#include "contact/laws/field_law.hpp"
#include "contact/laws/parameters.hpp"
#include "support/linear_between.hpp"

namespace rollcon {
namespace {

class OfTemperature final : public CoulombGiven, public FieldLaw {
 public:
  /// Takes temperatures that ascend, with ratios of at most 1.
  OfTemperature(std::vector<double> temperature, std::vector<double> ratio, double mu)
      : temperature_(std::move(temperature)), ratio_(std::move(ratio)), mu_(mu) {}

  const FieldLaw* of_field() const override { return this; }
  bool wants_temperature() const override { return true; }
  void ratios(const FrictionField& field, std::span<double> ratio) const override {
    for (std::size_t k = 0; k < ratio.size(); ++k)

      ratio[k] = linear_between(temperature_, ratio_, 0.5 * (field.temperature[2 * k] + field.temperature[2 * k + 1]));
  }

  std::string description() const override {
    char text[120];
    std::snprintf(text, sizeof text, "friction: linear in the surface temperature, %g at %g to %g at %g",
                  mu_ * ratio_.front(), temperature_.front(), mu_ * ratio_.back(), temperature_.back());
    return text;
  }

 private:
  std::vector<double> temperature_, ratio_;
  double mu_;
};

}  // namespace

GivenFriction make_temperature(std::span<const double> parameters) {
  if (parameters.size() % 2 != 0)
    fail(Status::err_argument, "n is %zu; 'temperature' has an even number of parameters: T1, mu1, T2, mu2, ...",
         parameters.size());
  std::vector<double> temperature, ratio;
  double mu = 0;
  for (std::size_t i = 0; i < parameters.size(); i += 2) {
    const double t = parameters[i], value = parameters[i + 1];
    if (!temperature.empty() && !(t > temperature.back()))
      fail(Status::err_argument, "T%zu is %g; allowed: above T%zu, which is %g", i / 2 + 1, t, i / 2,
           temperature.back());
    char name[32];
    std::snprintf(name, sizeof name, "mu%zu", i / 2 + 1);
    require_coefficient(value, name);
    temperature.push_back(t);
    ratio.push_back(value);
    mu = std::max(mu, value);
  }
  for (double& r : ratio) r = mu > 0 ? r / mu : 1;
  return {std::make_shared<OfTemperature>(std::move(temperature), std::move(ratio), mu), mu};
}

}  // namespace rollcon
