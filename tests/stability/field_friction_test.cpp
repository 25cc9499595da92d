/// Solves random scenes under friction that follows the whole solution, across the rolling direction, and with a layer
/// between the bodies, loads included: coefficients are those of what was found, the laws hold with them, or a status
/// says why not.

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "support/extremes.hpp"
#include "support/extremes_draw.hpp"
#include "support/first_seed.hpp"
#include "support/independent_results.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double law_bound = 1e-8;

double size_of(const extremes::Scene& scene) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& x : scene.given.frame.node) low = std::min(low, x[0]), high = std::max(high, x[0]);
  return high - low;
}

double largest(const std::vector<double>& v) {
  double most = 0;
  for (const double x : v) most = std::max(most, std::abs(x));
  return most;
}

std::vector<double> field_of(const scenes::RollingPair& pair, std::int32_t field, std::int64_t values) {
  std::vector<double> v(static_cast<std::size_t>(values));
  EXPECT_GE(rollcon_contact_get_field(pair.handle(), field, ROLLCON_LOCAL, values, v.data(), nullptr), 0);
  return v;
}

// Describes what such friction is made of.
struct Kind {
  const char* name;
  bool falls;  ///< true under a law of falling friction
  /// Completes the scene; returns false if it has no sense.
  bool (*give)(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed);
  /// Returns the difference of coefficients from those of the kind's own formula, over the greatest; null: only the
  /// laws are checked.
  double (*off)(const scenes::RollingPair& pair, const extremes::Scene& scene, const std::vector<double>& mu);
  /// Fraction of the scenes that may end without convergence: loads may be more than a layer that flows carries.
  double undecided = 0.125;
};

// Solves without what is tried: gives displacements over tractions, and tractions; returns false if it was not solved.
bool sizes_of(scenes::RollingPair& pair, const extremes::Scene& scene, double& soft, double& traction) {
  const std::int32_t status = rollcon_contact_solve(pair.handle());
  if (status < 0 || status == ROLLCON_NOT_CONVERGED || status == ROLLCON_NO_CONTACT) return false;
  const std::int64_t n = 3 * scene.given.frame.nodes();
  const double u = std::max(largest(field_of(pair, ROLLCON_FIELD_DISPLACEMENT1, n)),
                            largest(field_of(pair, ROLLCON_FIELD_DISPLACEMENT2, n)));
  const std::vector<double> t = field_of(pair, ROLLCON_FIELD_TRACTION, n);
  soft = u / largest(t);
  traction = 0;
  for (std::size_t k = 0; k < t.size(); k += 3) traction = std::max(traction, std::hypot(t[k], t[k + 1]));
  return soft > 1e-200 && traction > 1e-200;
}

// Gives a layer from hardly to a hundred times as soft as the bodies.
bool give_layer(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed) {
  extremes::Draw d(seed + 0x3141592U);
  double soft = 0, traction = 0;
  if (!sizes_of(pair, scene, soft, traction)) return false;
  scene.given.layer = soft * d.log_between(1e-3, 100);
  if (d.chance(0.5)) rollcon_contact_reset(pair.handle());
  return rollcon_contact_set_layer(pair.handle(), scene.given.layer, 0, 0) == ROLLCON_OK;
}

// Gives a layer that flows under a part of the tractions, elastic before or not.
bool give_yield(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed) {
  extremes::Draw d(seed + 0x2718281U);
  double soft = 0, traction = 0;
  if (!sizes_of(pair, scene, soft, traction)) return false;
  scene.given.layer = d.chance(0.3) ? 0 : soft * d.log_between(1e-2, 10);
  const double hardening = d.chance(0.3) ? 0 : d.log_between(1e-3, 1) / soft;
  return rollcon_contact_set_layer(pair.handle(), scene.given.layer, traction * d.log_between(0.1, 2), hardening) ==
         ROLLCON_OK;
}

// Gives points across the frame and beyond it, none of them twice.
bool give_across(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed) {
  extremes::Draw d(seed + 0x1618033U);
  laws::Given& g = scene.given;
  const double mu = *std::max_element(g.friction.begin(), g.friction.end());
  const std::vector<double> y = laws::project(g).y;
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const int n = 1 + static_cast<int>(5 * d.between(0, 0.999));
  std::vector<double> place, at, points;
  for (int i = 0; i < n; ++i) place.push_back(*low + (*high - *low) * (i + d.between(0.1, 0.9)) / n * 1.2);
  for (int i = 0; i < n; ++i) at.push_back(d.chance(0.1) ? 0 : mu * d.log_between(0.05, 1));
  for (std::size_t i = 0; i < place.size(); ++i) points.insert(points.end(), {place[i], at[i]});
  g.friction.clear();
  for (const double v : y) {
    const auto i = static_cast<std::size_t>(std::upper_bound(place.begin(), place.end(), v) - place.begin());
    if (i == 0 || i == place.size())
      g.friction.push_back(i == 0 ? at.front() : at.back());
    else
      g.friction.push_back(at[i - 1] + (at[i] - at[i - 1]) * (v - place[i - 1]) / (place[i] - place[i - 1]));
  }
  return rollcon_contact_set_friction_field(pair.handle(), 0, nullptr) == ROLLCON_OK &&
         rollcon_contact_set_friction_across(pair.handle(), n, points.data()) == ROLLCON_OK;
}

// Gives a length of slip from far below to far above what a particle slips in the contact.
bool give_memory(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed) {
  extremes::Draw d(seed + 0x1234567U);
  const double speed = scene.given.law.parameter[2];
  const double length = speed / scene.given.speed * size_of(scene) * d.log_between(1e-3, 10);
  return rollcon_contact_set_friction_memory(pair.handle(), length, speed * d.log_between(1e-4, 1)) == ROLLCON_OK;
}

// Gives coefficients that change over the temperatures of a solve without that.
bool give_temperature(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed) {
  extremes::Draw d(seed + 0x7654321U);
  for (int body = 1; body <= 2; ++body)
    if (rollcon_contact_set_heat(pair.handle(), body, d.log_between(0.1, 10), d.log_between(0.1, 10), 0) < 0)
      return false;
  const std::int32_t status = rollcon_contact_solve(pair.handle());
  if (status < 0 || status == ROLLCON_NOT_CONVERGED || status == ROLLCON_NO_CONTACT) return false;
  std::vector<double> t(static_cast<std::size_t>(2 * scene.given.frame.nodes()));
  if (rollcon_contact_get_field(pair.handle(), ROLLCON_FIELD_TEMPERATURE, ROLLCON_LOCAL,
                                static_cast<std::int64_t>(t.size()), t.data(), nullptr) < 0)
    return false;
  const double hot = *std::max_element(t.begin(), t.end());
  if (!(hot > 1e-200)) return false;
  const double mu = *std::max_element(scene.given.friction.begin(), scene.given.friction.end());
  const double from = d.between(0, 0.6) * hot;
  const double law[] = {from, mu, from + d.log_between(0.3, 3) * hot, d.between(0.3, 1) * mu};
  scene.given.law.parameter.assign(law, law + 4);
  if (d.chance(0.5)) rollcon_contact_reset(pair.handle());
  return rollcon_contact_set_friction(pair.handle(), "temperature", 4, law) == ROLLCON_OK;
}

// Compares with a formula that is linear between two temperatures, those of the greatest coefficient by the first.
double off_temperature(const scenes::RollingPair& pair, const extremes::Scene& scene, const std::vector<double>& mu) {
  const std::vector<double>& law = scene.given.law.parameter;
  const auto n = static_cast<std::int64_t>(mu.size());
  const std::vector<double> t = field_of(pair, ROLLCON_FIELD_TEMPERATURE, 2 * n),
                            p = field_of(pair, ROLLCON_FIELD_PRESSURE, n);
  const double all = *std::max_element(p.begin(), p.end()) * *std::max_element(mu.begin(), mu.end());
  double off = 0;
  for (std::size_t k = 0; k < mu.size(); ++k) {
    if (!(p[k] > 0) || mu[k] == 0) continue;
    const double part = std::clamp((t[2 * k] - law[0]) / (law[2] - law[0]), 0.0, 1.0);
    const double due = (law[1] + part * (law[3] - law[1])) / law[1] *
                       (scene.given.friction.size() == 1 ? scene.given.friction[0] : scene.given.friction[k]);
    off = std::max(off, std::abs(mu[k] - due) * p[k] / all);
  }
  return off;
}

double off_across(const scenes::RollingPair&, const extremes::Scene& scene, const std::vector<double>& mu) {
  double off = 0;
  const double most = *std::max_element(scene.given.friction.begin(), scene.given.friction.end());
  for (std::size_t k = 0; k < mu.size(); ++k)
    if (mu[k] > 0) off = std::max(off, std::abs(mu[k] - scene.given.friction[k]) / most);
  return off;
}

constexpr Kind memory{"memory", true, give_memory, nullptr},
    temperature{"temperature", false, give_temperature, off_temperature}, layer{"layer", false, give_layer, nullptr},
    yielding{"layer that flows", false, give_yield, nullptr, 0.25}, across{"across", false, give_across, off_across};

void expect_laws_kept(const Kind& kind, std::uint32_t first, std::uint32_t scenes) {
  std::map<std::int32_t, int> count;
  double worst = 0, change = 0, rounds = 0, off = 0;
  int solved = 0, tried = 0, without_loads = 0;
  for (std::uint32_t seed = first; seed < first + scenes; ++seed) {
    constexpr const char* falling[] = {"linear", "rational", "exponential"};
    extremes::Scene scene = kind.falls      ? extremes::law_scene(falling[seed % 3], seed)
                            : seed % 3 == 0 ? extremes::forces_scene(seed)
                                            : extremes::random_scene(seed);
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    if (!kind.give(*pair, scene, seed)) continue;
    ++tried;
    const std::int32_t status = rollcon_contact_solve(pair->handle());
    ++count[status];
    const auto& by_force = scene.given.by_force;
    const bool loads = by_force[0] || by_force[1] || by_force[3];
    EXPECT_TRUE(status >= 0 || (loads && status == ROLLCON_ERR_LOAD)) << "seed " << seed << ": " << status;
    if (status == ROLLCON_NOT_CONVERGED) {
      without_loads += !loads;
      std::printf("seed %u: not converged, %s\n", seed, extremes::describe(scene).c_str());
    }
    if (status < 0 || status == ROLLCON_NOT_CONVERGED || status == ROLLCON_NO_CONTACT) continue;
    ++solved;
    rounds += pair->stat("friction_rounds");
    change = std::max(change, pair->stat("friction_change"));
    // The laws are checked with these coefficients.
    laws::Given given = scene.given;
    given.law = {};
    given.friction.resize(static_cast<std::size_t>(given.frame.nodes()));
    ASSERT_EQ(
        rollcon_contact_get_field(pair->handle(), ROLLCON_FIELD_FRICTION, ROLLCON_LOCAL,
                                  static_cast<std::int64_t>(given.friction.size()), given.friction.data(), nullptr),
        ROLLCON_OK);
    if (kind.off) off = std::max(off, kind.off(*pair, scene, given.friction));
    const laws::Laws law = laws::check(pair->handle(), given, 300);
    EXPECT_TRUE(law.finite) << "seed " << seed;
    EXPECT_LE(law.worst(), law_bound) << "seed " << seed << ": " << law.worst_name() << " "
                                      << extremes::describe(scene);
    worst = std::max(worst, law.worst());
  }
  std::printf(
      "%s: %d scenes, %d solved, worst law residual %.1e (bound %.0e), coefficients change by %.1e in the last "
      "of %.1f rounds, off their formula by %.1e\n",
      kind.name, tried, solved, worst, law_bound, change, rounds / std::max(1, solved), off);
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(change, 1e-7);
  EXPECT_LE(off, 1e-6);
  EXPECT_LE(without_loads, tried / 20);
  EXPECT_LE(count[ROLLCON_NOT_CONVERGED], kind.undecided * tried);
}

TEST(field_friction, random_scenes_with_memory) {
  expect_laws_kept(memory, extremes::first_seed(), 20);
}
TEST(field_friction, random_scenes_of_temperature) {
  expect_laws_kept(temperature, extremes::first_seed(), 20);
}
TEST(field_friction, random_scenes_with_layers) {
  expect_laws_kept(layer, extremes::first_seed(), 20);
  expect_laws_kept(yielding, extremes::first_seed(), 20);
}
TEST(field_friction, random_scenes_across) {
  expect_laws_kept(across, extremes::first_seed(), 20);
}
TEST(field_friction_long, random_scenes_with_memory) {
  expect_laws_kept(memory, extremes::first_seed() + 20, 40);
}
TEST(field_friction_long, random_scenes_of_temperature) {
  expect_laws_kept(temperature, extremes::first_seed() + 20, 40);
}
TEST(field_friction_nightly, random_scenes_with_memory) {
  expect_laws_kept(memory, extremes::first_seed() + 60, 440);
}
TEST(field_friction_nightly, random_scenes_of_temperature) {
  expect_laws_kept(temperature, extremes::first_seed() + 60, 440);
}
TEST(field_friction_nightly, random_scenes_with_layers) {
  expect_laws_kept(layer, extremes::first_seed() + 20, 480);
  expect_laws_kept(yielding, extremes::first_seed() + 20, 480);
}
TEST(field_friction_nightly, random_scenes_across) {
  expect_laws_kept(across, extremes::first_seed() + 20, 480);
}

}  // namespace
}  // namespace rollcon
