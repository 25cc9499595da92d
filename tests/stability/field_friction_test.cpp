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

// What a solve without the layer finds, to scale it by.
struct Found {
  double pressure = 0, traction = 0, approach = 0;
  explicit operator bool() const { return pressure > 0 && traction > 0 && approach > 0; }
};
Found find_without_layer(scenes::RollingPair& pair) {
  const std::int32_t status = rollcon_contact_solve(pair.handle());
  if (status < 0 || status == ROLLCON_NOT_CONVERGED || status == ROLLCON_NO_CONTACT) return {};
  const scenes::Solution s = pair.solution();
  Found found;
  found.approach = std::abs(s.approach);
  for (const auto& t : s.traction) {
    found.pressure = std::max(found.pressure, -t[2]);
    found.traction = std::max(found.traction, std::hypot(t[0], t[1]));
  }
  return found;
}

// From far stiffer than the bodies to far softer.
bool give_layer(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed) {
  extremes::Draw d(seed + 0x2468aceU);
  const Found found = find_without_layer(pair);
  if (!found) return false;
  scene.given.layer = found.approach / found.pressure * d.log_between(1e-3, 1e3);
  if (d.chance(0.5)) rollcon_contact_reset(pair.handle());
  return rollcon_contact_set_layer(pair.handle(), scene.given.layer) == ROLLCON_OK;
}

// A layer, elastic in half of the scenes, that begins to flow under part of the tractions found without it; harder or
// softer (one in seven) the further it flows.
bool give_yield(scenes::RollingPair& pair, extremes::Scene& scene, std::uint32_t seed, double& stress) {
  extremes::Draw d(seed + 0x13579bdU);
  const Found found = find_without_layer(pair);
  if (!found) return false;
  if (d.chance(0.5)) scene.given.layer = found.approach / found.pressure * d.log_between(1e-2, 10);
  stress = found.traction * d.between(0.1, 1.2);
  double hardening = d.chance(0.5) ? 0 : stress / found.approach * d.log_between(1e-2, 10);
  if (hardening > 0 && d.chance(0.3)) hardening *= -0.1;
  if (d.chance(0.5)) rollcon_contact_reset(pair.handle());
  const bool given = rollcon_contact_set_layer(pair.handle(), scene.given.layer) == ROLLCON_OK &&
                     rollcon_contact_set_layer_yield(pair.handle(), stress, hardening) == ROLLCON_OK;
  if (hardening != 0) stress = INFINITY;  // says no more of what is above it
  return given;
}

enum class Kind { memory, temperature, layer, yield };
constexpr const char* name_of[] = {"memory", "temperature", "layer", "yield"};

extremes::Scene draw_scene(Kind kind, std::uint32_t seed) {
  constexpr const char* laws[] = {"linear", "rational", "exponential", "orthotropic", "orthotropic_collinear"};
  if (kind == Kind::memory) return extremes::law_scene(laws[seed % 3], seed);
  if (kind == Kind::layer && seed % 2 == 0) return extremes::law_scene(laws[seed / 2 % 5], seed);
  return extremes::random_scene(seed);
}

void expect_laws_kept(Kind kind, std::uint32_t first, std::uint32_t scenes) {
  std::map<std::int32_t, int> count;
  double worst = 0, sum = 0, change = 0, rounds = 0;
  int solved = 0, tried = 0, without_loads = 0, unlike = 0;
  for (std::uint32_t seed = first; seed < first + scenes; ++seed) {
    extremes::Scene scene = draw_scene(kind, seed);
    double stress = INFINITY;
    const auto pair = extremes::make_pair(scene);
    extremes::give_scene(*pair, scene);
    const bool given_law = kind == Kind::memory        ? give_memory(*pair, scene, seed)
                           : kind == Kind::temperature ? give_temperature(*pair, scene, seed)
                           : kind == Kind::layer       ? give_layer(*pair, scene, seed)
                                                       : give_yield(*pair, scene, seed, stress);
    if (!given_law) continue;
    ++tried;
    const std::int32_t status = rollcon_contact_solve(pair->handle());
    ++count[status];
    const auto& by_force = scene.given.by_force;
    const bool loads = by_force[0] || by_force[1] || by_force[3];
    EXPECT_TRUE(status >= 0 || (loads && status == ROLLCON_ERR_LOAD)) << "seed " << seed << ": " << status;
    if (status == ROLLCON_NOT_CONVERGED) {
      without_loads += !loads;
      std::printf("%s, seed %u: not converged, %s\n", name_of[static_cast<int>(kind)], seed,
                  extremes::describe(scene).c_str());
    }
    if (status < 0 || status == ROLLCON_NOT_CONVERGED || status == ROLLCON_NO_CONTACT) continue;
    ++solved;
    unlike += scene.group.find("unlike") != std::string::npos;
    rounds += pair->stat("friction_rounds");
    change = std::max(change, pair->stat("friction_change"));
    laws::Given given = scene.given;
    if (kind != Kind::layer) {  // the laws with these coefficients
      given.law = {};
      given.friction.resize(static_cast<std::size_t>(given.frame.nodes()));
      ASSERT_EQ(
          rollcon_contact_get_field(pair->handle(), ROLLCON_FIELD_FRICTION, ROLLCON_LOCAL,
                                    static_cast<std::int64_t>(given.friction.size()), given.friction.data(), nullptr),
          ROLLCON_OK);
    }
    const scenes::Solution solution = pair->solution();
    for (const auto& t : solution.traction) EXPECT_LE(std::hypot(t[0], t[1]), stress * (1 + 1e-6)) << "seed " << seed;
    const laws::Laws law = laws::check(pair->handle(), given, 300);
    EXPECT_TRUE(law.finite) << "seed " << seed;
    EXPECT_LE(law.worst(), law_bound) << "seed " << seed << ": " << law.worst_name() << " "
                                      << extremes::describe(scene);
    worst = std::max(worst, law.worst());
    sum += law.worst();
  }
  std::printf(
      "%s: %d scenes, %d solved (%d of unlike bodies), laws off by %.1e in the mean, %.1e at worst (bound %.0e), "
      "coefficients change by %.1e in the last of %.1f rounds\n",
      name_of[static_cast<int>(kind)], tried, solved, unlike, sum / std::max(1, solved), worst, law_bound, change,
      rounds / std::max(1, solved));
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(change, 1e-7);
  EXPECT_LE(without_loads, tried / 20);
  EXPECT_LE(count[ROLLCON_NOT_CONVERGED], tried / 8);
}

class field_friction : public testing::TestWithParam<Kind> {};
class field_friction_long : public testing::TestWithParam<Kind> {};
class field_friction_nightly : public testing::TestWithParam<Kind> {};

TEST_P(field_friction, random_scenes) {
  expect_laws_kept(GetParam(), extremes::first_seed(), 15);
}
TEST_P(field_friction_long, random_scenes) {
  expect_laws_kept(GetParam(), extremes::first_seed() + 20, 100);
}
TEST_P(field_friction_nightly, random_scenes) {
  expect_laws_kept(GetParam(), extremes::first_seed() + 120, 380);
}

constexpr Kind all[] = {Kind::memory, Kind::temperature, Kind::layer, Kind::yield};
std::string name(const testing::TestParamInfo<Kind>& kind) {
  return name_of[static_cast<int>(kind.param)];
}
INSTANTIATE_TEST_SUITE_P(scenes, field_friction, testing::ValuesIn(all), name);
INSTANTIATE_TEST_SUITE_P(scenes_long, field_friction_long, testing::ValuesIn(all), name);
INSTANTIATE_TEST_SUITE_P(scenes_nightly, field_friction_nightly, testing::ValuesIn(all), name);

}  // namespace
}  // namespace rollcon
