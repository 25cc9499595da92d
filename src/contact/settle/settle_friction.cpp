#include "contact/settle/settle_friction.hpp"

#include <algorithm>
#include <cmath>

#include "contact/laws/field_law.hpp"
#include "contact/settle/mixing.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t most_rounds = 100;
constexpr int most_retreats = 6;
constexpr double slack = 10;   // what solves leave open shows in the coefficients
constexpr double rough = 0.1;  // tolerance of a solve whose coefficients will change, over the last change

/// Holds what a law or heat wants to know of a solution.
struct AtNodes {
  std::vector<double> mu, slip_speed, pressure, power, temperature;
};

void read(const Solution& s, Derived& d, AtNodes& a) {
  derive_fields(s, d);
  const Iterate& it = s.iterate;
  const std::size_t n = at(s.prepared->problem.nodes);
  for (auto* v : {&a.mu, &a.slip_speed, &a.pressure, &a.power}) v->assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    a.mu[k] = s.given.friction * s.prepared->problem.mu[k];
    a.slip_speed[k] = std::hypot(d.slip[0][k], d.slip[1][k]);
    if (!(it.lambda[2][k] < 0)) continue;
    a.pressure[k] = -it.lambda[2][k];
    a.power[k] = std::max(0.0, -(it.lambda[0][k] * d.slip[0][k] + it.lambda[1][k] * d.slip[1][k]));
  }
}

void require_heat(const Solution& s, const BothHeats& heat) {
  if (s.prepared->step != StepKind::steady)
    fail(Status::err_state, "temperatures are those of steady rolling, and this is a step in time");
  for (std::size_t b = 0; b < 2; ++b)
    if (!heat[b].given)
      fail(Status::err_state, "what body %zu does with heat is not known: rollcon_contact_set_heat", b + 1);
  if (!(heat[0].conductivity * heat[0].capacity > 0) && !(heat[1].conductivity * heat[1].capacity > 0))
    fail(Status::err_state, "neither body takes up heat: conductivity or heat capacity of both are 0");
}

HeatedSurface heated(const Solution& s, const StreamLines& lines, const AtNodes& a, const BothHeats& heat) {
  return {lines, a.power, a.pressure, s.prepared->speed, heat};
}

/// Adds counts of the rounds before, which a solve's own report does not have.
void add_counts(const NewtonReport& before, NewtonReport& report) {
  report.normal_iterations += before.normal_iterations;
  report.tangential_iterations += before.tangential_iterations;
  report.full_iterations += before.full_iterations;
  report.fallbacks += before.fallbacks;
  report.predictions += before.predictions;
}

}  // namespace

void settle_friction(Solution& s, double tolerance, const std::function<void(double)>& solve) {
  const Prepared& on = *s.prepared;
  const Problem& p = on.problem;
  const FieldLaw& law = *p.law->of_field();
  const std::size_t n = at(p.nodes);
  SettledFriction& settled = s.settled;
  const bool cold = settled.utilisation.size() != n;
  std::vector<double>& utilisation = s.given.utilisation;
  utilisation = settled.utilisation;
  if (cold) utilisation.assign(n, 1.0);
  settled.rounds = 0;
  settled.change = 1;
  if (law.wants_temperature()) require_heat(s, on.heat);

  const StreamLines lines(on.frame);
  AtNodes now;
  Mixing mixing;
  std::vector<double> wanted(n), change(n), weight(n), before = utilisation;
  Derived derived;
  NewtonReport counted;
  int retreats = 0;
  double enough = std::max(tolerance, cold ? 1e-3 : tolerance);
  while (true) {
    ++settled.rounds;
    solve(enough);
    add_counts(counted, s.report);
    counted = s.report;
    Outcome outcome = s.report.outcome;
    const bool retreat = (outcome == Outcome::not_converged || outcome == Outcome::no_solution) && settled.rounds > 1;
    if (retreat && retreats < most_retreats && settled.rounds < most_rounds) {
      // Coefficients that went too far go half the way back, without what was learnt.
      ++retreats;
      for (std::size_t k = 0; k < n; ++k) utilisation[k] = 0.5 * (utilisation[k] + before[k]);
      mixing.start();
      continue;
    }
    // Loads that are beyond friction on the way say nothing about the coefficients that belong to them.
    if (retreat) outcome = Outcome::not_converged;
    if (outcome == Outcome::converged) {
      derived.forget();
      read(s, derived, now);
      if (law.wants_temperature()) {
        now.temperature.resize(2 * n);
        surface_temperatures(heated(s, lines, now, on.heat), on.frame.x, now.temperature);
      }
      law.ratios({lines, now.mu, now.slip_speed, now.pressure, now.temperature, on.speed}, wanted);
      double most = 0, off = 0;
      for (std::size_t k = 0; k < n; ++k) {
        change[k] = wanted[k] - utilisation[k];
        weight[k] = now.mu[k] * now.pressure[k];
        most = std::max(most, weight[k]);
        off = std::max(off, weight[k] * std::abs(change[k]));
      }
      settled.change = most > 0 ? off / most : 0;
      if (!(settled.change <= slack * tolerance) || enough > tolerance) {
        if (settled.rounds < most_rounds) {
          before = utilisation;
          if (settled.change > slack * tolerance) mixing.next(utilisation, change, weight);
          // Where nothing touches there is nothing to mix.
          for (std::size_t k = 0; k < n; ++k)
            utilisation[k] = weight[k] > 0 ? std::clamp(utilisation[k], 0.0, 1.0) : wanted[k];
          enough = std::clamp(rough * settled.change, tolerance, enough);
          continue;
        }
        outcome = Outcome::not_converged;
      }
    }
    s.report.outcome = outcome;
    s.report.from_nothing = cold;
    if (outcome != Outcome::converged)
      s.report.residual_tangential = std::max(s.report.residual_tangential, settled.change);
    settled.utilisation = utilisation;
    return;
  }
}

void node_temperatures(const Solution& s, Derived& d, const BothHeats& heat, std::span<double> temperature) {
  require_heat(s, heat);
  AtNodes now;
  read(s, d, now);
  const StreamLines lines(s.prepared->frame);
  surface_temperatures(heated(s, lines, now, heat), s.prepared->frame.x, temperature);
}

void temperatures_at(const Solution& s, Derived& d, const BothHeats& heat, std::span<const double> x,
                     std::span<const double> y, std::span<double> temperature) {
  require_heat(s, heat);
  AtNodes now;
  read(s, d, now);
  const StreamLines lines(s.prepared->frame);
  surface_temperatures(heated(s, lines, now, heat), x, y, temperature);
}

}  // namespace rollcon
