#include "contact/results/wear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/results/power.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Adds the integrals over [from, to], within one interval of y, of a linear function from f0 to f1 times the hats of
/// y[j] and y[j + 1].
void add_linear(double from, double to, double f0, double f1, std::span<const double> y, std::size_t j,
                double* volume) {
  const double length = to - from, width = y[j + 1] - y[j];
  const double right0 = (from - y[j]) / width, right1 = (to - y[j]) / width;
  const double total = 0.5 * length * (f0 + f1);
  const double right = length / 6 * (2 * f0 * right0 + f0 * right1 + f1 * right0 + 2 * f1 * right1);
  volume[j] += total - right;
  volume[j + 1] += right;
}

/// Spreads `amount` as a triangle from middle - half to middle + half.
void spread(double middle, double half, double amount, std::span<const double> y, double* volume) {
  const std::size_t n = y.size();
  const auto height = [&](double x) { return amount / half * std::max(0.0, 1 - std::abs(x - middle) / half); };
  const auto beyond = [&](double x) {  // area below x
    const double t = std::clamp((x - middle) / half, -1.0, 1.0);
    return amount * (t < 0 ? 0.5 * (1 + t) * (1 + t) : 1 - 0.5 * (1 - t) * (1 - t));
  };
  volume[0] += beyond(y[0]);
  volume[n - 1] += amount - beyond(y[n - 1]);
  const double low = std::max(middle - half, y[0]), high = std::min(middle + half, y[n - 1]);
  if (!(low < high)) return;
  std::size_t j = at(std::upper_bound(y.begin(), y.end(), low) - y.begin()) - 1;
  for (double from = low; from < high; ++j) {
    if (j + 1 >= n) return;
    double to = std::min(high, y[j + 1]);
    if (from < middle && middle < to) {
      add_linear(from, middle, height(from), height(middle), y, j, volume);
      from = middle;
    }
    add_linear(from, to, height(from), height(to), y, j, volume);
    from = to;
  }
}

/// Returns half of what the elements around each node cover of t2.
std::vector<double> half_widths(const Frame& frame) {
  const std::size_t n = at(frame.nodes());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> low(n, infinity), high(n, -infinity), half(n);
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    double least = infinity, most = -infinity;
    for (const std::int32_t k : frame.mesh.element(e))
      least = std::min(least, frame.y[at(k)]), most = std::max(most, frame.y[at(k)]);
    for (const std::int32_t k : frame.mesh.element(e))
      low[at(k)] = std::min(low[at(k)], least), high[at(k)] = std::max(high[at(k)], most);
  }
  for (std::size_t k = 0; k < n; ++k) half[k] = std::max(0.5 * (high[k] - low[k]), 1e-12 * std::abs(frame.y[k]));
  return half;
}

/// Holds what slip takes at each node, over the speed, and what the law makes of that.
struct NodalWear {
  std::vector<double> energy, volume;
  double all_energy = 0, all_volume = 0;

  void scale(double factor) {
    for (double& v : energy) v *= factor;
    for (double& v : volume) v *= factor;
    all_energy *= factor;
    all_volume *= factor;
  }
};

NodalWear wear_at_nodes(const Solution& state, const Derived& derived, const WearLaw& law) {
  const Prepared& on = *state.prepared;
  const std::size_t n = on.problem.weight.size();
  NodalWear found{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  for (std::size_t k = 0; k < n; ++k) {
    const double pressure = -state.iterate.lambda[2][k];
    if (!(pressure > 0)) continue;
    const double t[2] = {state.iterate.lambda[0][k], state.iterate.lambda[1][k]};
    const double slip[2] = {derived.slip[0][k] / on.speed, derived.slip[1][k] / on.speed};
    found.volume[k] = on.problem.weight[k] * law.rate(pressure, t, slip);
    found.energy[k] = on.problem.weight[k] * std::max(0.0, -(t[0] * slip[0] + t[1] * slip[1]));
    found.all_volume += found.volume[k];
    found.all_energy += found.energy[k];
  }
  return found;
}

/// Returns the volume for energy that is missed, taken as slip against friction at its bound all over a node's area.
double volume_of_missed(const Solution& state, const WearLaw& law, std::size_t k, double energy) {
  const double t[2] = {state.iterate.lambda[0][k], state.iterate.lambda[1][k]};
  const double pressure = -state.iterate.lambda[2][k], weight = state.prepared->problem.weight[k];
  const double length = std::hypot(t[0], t[1]),
               bound = state.given.coefficient(state.prepared->problem.mu, k) * pressure;
  if (!(length > 0 && bound > 0)) return 0;
  const double direction[2] = {t[0] / length, t[1] / length}, slip = -energy / (weight * bound);
  return weight *
         law.rate(pressure, {bound * direction[0], bound * direction[1]}, {slip * direction[0], slip * direction[1]});
}

/// Brings the whole to what the balance of work says. Nodes that slide miss the strip before the contact's edge: up to
/// a half more is theirs. Where little slides, rigid slip at work tells as much as nodes do.
void meet_balance(const Solution& state, const WearLaw& law, NodalWear& wear) {
  constexpr double least = 0.8, theirs = 1.5, noise = 1e-3;
  if (!power_is_balanced(state)) return;
  const Problem& p = state.prepared->problem;
  const double energy = power_put_in(state) / state.prepared->speed;
  if (!(energy > least * wear.all_energy)) return;
  const double per_energy = wear.all_energy > noise * energy ? wear.all_volume / wear.all_energy : 0;
  if (wear.all_energy > 0) wear.scale(std::min(energy / wear.all_energy, theirs));
  const double missed = energy - wear.all_energy;
  if (!(missed > 1e-12 * energy)) return;
  std::vector<double> share(wear.energy.size(), 0.0);
  double whole = 0;
  for (std::size_t k = 0; k < share.size(); ++k) {
    if (!(state.iterate.lambda[2][k] < 0) || !(p.weight[k] > 0)) continue;
    const auto i = static_cast<std::int64_t>(k);
    const double put_in = -p.weight[k] * (state.iterate.lambda[0][k] * p.rigid_slip1(i, state.iterate.motion) +
                                          state.iterate.lambda[1][k] * p.rigid_slip2(i, state.iterate.motion));
    share[k] = std::max(0.0, put_in - wear.energy[k]);
    whole += share[k];
  }
  if (!(whole > 0)) {
    if (wear.all_energy > 0) wear.scale(energy / wear.all_energy);
    return;
  }
  for (std::size_t k = 0; k < share.size(); ++k) {
    if (share[k] == 0) continue;
    const double more = missed * share[k] / whole;
    wear.volume[k] += per_energy > 0 ? per_energy * more : volume_of_missed(state, law, k, more);
  }
}

}  // namespace

double add_wear(const Solution& state, Derived& derived, const WearLaw& law, std::span<const double> y, double share,
                double* volume) {
  if (state.prepared->pair.creeps())
    fail(Status::err_unsupported,
         "a body is viscoelastic (rollcon_body_set_viscoelastic); allowed: wear of elastic and rigid bodies");
  derive_fields(state, derived);
  const Prepared& on = *state.prepared;
  const std::vector<double> half = half_widths(on.frame);
  NodalWear wear = wear_at_nodes(state, derived, law);
  meet_balance(state, law, wear);
  double total = 0;
  for (std::size_t k = 0; k < wear.volume.size(); ++k) {
    if (wear.volume[k] == 0) continue;
    total += wear.volume[k];
    if (!y.empty()) spread(on.frame.y[k], half[k], share * wear.volume[k], y, volume);
  }
  return total;
}

std::array<double, 2> contact_across(const Solution& state) {
  std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const Frame& frame = state.prepared->frame;
  for (std::size_t k = 0; k < frame.y.size(); ++k) {
    if (!(state.iterate.lambda[2][k] < 0)) continue;
    range[0] = std::min(range[0], frame.y[k]);
    range[1] = std::max(range[1], frame.y[k]);
  }
  return range;
}

}  // namespace rollcon
