/// Random scenes under friction that follows the whole solution, loads included: coefficients are those of what was
/// found, the laws hold with them, or a status says why not.

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "support/extremes.hpp"
#include "support/extremes_draw.hpp"
#include "support/first_seed.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double law_bound = 1e-8;

double size_of(const extremes::Scene& scene) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& x : scene.given.frame.node) low = std::min(low, x[0]), high = std::max(high, x[0]);
  return high - low;
}

// A length of slip from far below to far above what a particle slips in the contact.
bool give_memory(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed) {
  extremes::Draw d(seed + 0x1234567U);
  const double speed = scene.given.law.parameter[2];
  const double length = speed / scene.given.speed * size_of(scene) * d.log_between(1e-3, 10);
  return rollcon_contact_set_friction_memory(pair.handle(), length, speed * d.log_between(1e-4, 1)) == ROLLCON_OK;
}

// Coefficients that change over the temperatures of a solve without that.
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
  if (d.chance(0.5)) rollcon_contact_reset(pair.handle());
  return rollcon_contact_set_friction(pair.handle(), "temperature", 4, law) == ROLLCON_OK;
}

void expect_laws_kept(bool memory, std::uint32_t first, std::uint32_t scenes) {
  std::map<std::int32_t, int> count;
  double worst = 0, change = 0, rounds = 0;
  int solved = 0, tried = 0, without_loads = 0;
  for (std::uint32_t seed = first; seed < first + scenes; ++seed) {
    constexpr const char* falling[] = {"linear", "rational", "exponential"};
    extremes::Scene scene = memory ? extremes::law_scene(falling[seed % 3], seed) : extremes::random_scene(seed);
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    if (!(memory ? give_memory(*pair, scene, seed) : give_temperature(*pair, scene, seed))) continue;
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
    // The laws with these coefficients.
    laws::Given given = scene.given;
    given.law = {};
    given.friction.resize(static_cast<std::size_t>(given.frame.nodes()));
    ASSERT_EQ(
        rollcon_contact_get_field(pair->handle(), ROLLCON_FIELD_FRICTION, ROLLCON_LOCAL,
                                  static_cast<std::int64_t>(given.friction.size()), given.friction.data(), nullptr),
        ROLLCON_OK);
    const laws::Laws law = laws::check(pair->handle(), given, 300);
    EXPECT_TRUE(law.finite) << "seed " << seed;
    EXPECT_LE(law.worst(), law_bound) << "seed " << seed << ": " << law.worst_name() << " "
                                      << extremes::describe(scene);
    worst = std::max(worst, law.worst());
  }
  std::printf(
      "%s: %d scenes, %d solved, worst law residual %.1e (bound %.0e), coefficients change by %.1e in the last "
      "of %.1f rounds\n",
      memory ? "memory" : "temperature", tried, solved, worst, law_bound, change, rounds / std::max(1, solved));
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(change, 1e-7);
  EXPECT_LE(without_loads, tried / 20);
  EXPECT_LE(count[ROLLCON_NOT_CONVERGED], tried / 8);
}

TEST(field_friction, random_scenes_with_memory) {
  expect_laws_kept(true, extremes::first_seed(), 20);
}
TEST(field_friction, random_scenes_of_temperature) {
  expect_laws_kept(false, extremes::first_seed(), 20);
}
TEST(field_friction_long, random_scenes_with_memory) {
  expect_laws_kept(true, extremes::first_seed() + 20, 480);
}
TEST(field_friction_long, random_scenes_of_temperature) {
  expect_laws_kept(false, extremes::first_seed() + 20, 480);
}

}  // namespace
}  // namespace rollcon
