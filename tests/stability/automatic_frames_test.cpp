/// Solves extreme scenes without a frame: half-spaces and rigid planes whose gap is quadratic. Each one is solved with
/// the laws satisfied, results of finite size and loads carried, or ends with a status that says why not; forces are
/// those on the scene's own frame as far as that is trusted, and units do not matter.

#include <map>

#include "support/extremes_base.hpp"
#include "support/first_seed.hpp"
#include "support/testing.hpp"

namespace rollcon::without_frames {
namespace {

using extremes::Scene;
using scenes::RollingPair;
using scenes::Solution;

/// The laws are those that the library recomputes on the finer frame of a pair; loads are over those prescribed.
constexpr double law_bound = 1e-8, load_bound = 1e-9;
/// Forces are compared with those on the scene's own frame, over the sum of both error estimates (see errors_by_loads):
/// measured were at most 1.02 at the standard accuracy, 1.01 on the coarsest frames.
constexpr double standard_apart = 1.6, coarse_apart = 1.6;

bool needs_no_frame(const Scene& scene) {
  const laws::Given& g = scene.given;
  return g.quadratic && g.gap.empty() && g.friction.size() == 1 && g.creep_field.empty();
}

Scene without_frame(Scene scene) {
  // Choices of operators are for lattices.
  std::erase_if(scene.option, [](const auto& o) { return o.first == "accuracy" || o.first == "operators"; });
  return scene;
}

/// Returns named scenes; those that differ by their frames alone come once.
std::vector<Scene> named_scenes() {
  std::vector<Scene> scenes;
  for (Scene& scene : extremes::named_scenes())
    if (needs_no_frame(scene) && (scene.group != "frames" || scene.name.starts_with("regular, 1681")))
      scenes.push_back(std::move(scene));
  return scenes;
}

std::vector<Scene> scenes_of_seeds(Scene (*make)(std::uint32_t), std::uint32_t first, std::uint32_t count) {
  std::vector<Scene> scenes;
  for (std::uint32_t seed = first; seed < first + count; ++seed)
    if (Scene scene = make(seed); needs_no_frame(scene)) scenes.push_back(std::move(scene));
  return scenes;
}

std::string full_name(const Scene& scene) {
  return scene.group + ": " + scene.name;
}

void ROLLCON_CALL count_warning(std::int32_t, const char*, void* count) {
  ++*static_cast<int*>(count);
}

/// Holds what does not depend on units: forces over mu Fn, lengths over that of the contact.
struct Shares {
  std::array<double, 3> force{};  ///< along, across, spin moment
  double approach = 0;
  std::array<double, 3> creep{};
};

struct Outcome {
  std::int32_t status = 0;
  int warnings = 0;
  std::string message;
  Solution solution;
  double size = 0, bound = 0;  ///< size of the contact; bound mu Fn
  double estimate = 0, law = 0;
  double by_loads = 1;  ///< errors of forces that were not prescribed over error estimates

  bool solved() const {
    return status == ROLLCON_OK || status == ROLLCON_INACCURATE || status == ROLLCON_COARSE ||
           status == ROLLCON_TOO_DEEP || status == ROLLCON_NO_CONTACT;
  }
  bool has_friction() const { return bound > 0; }
  Shares shares() const {
    const auto& [x, y, n] = solution.force;
    const auto& [xi, eta, phi] = solution.creep;
    return {
        {x / bound, y / bound, solution.moment[2] / (bound * size)}, solution.approach / size, {xi, eta, phi * size}};
  }
};

/// Returns the factor by which prescribed forces enlarge errors. Estimates are of forces at given motions
/// (docs/theory.md). Where forces are prescribed their errors become errors of motions, and these add to the error of a
/// force that is not prescribed: by its derivatives with the prescribed ones.
double errors_by_loads(const RollingPair& pair, const Scene& scene, double size) {
  constexpr std::int32_t direction[] = {ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_SPIN};
  constexpr std::size_t entry[] = {0, 1, 3};
  const auto& by_force = scene.given.by_force;
  double sum = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!by_force[entry[i]]) continue;
    double f[3] = {};
    const std::int32_t status =
        rollcon_contact_get_sensitivity(pair.handle(), direction[i], f, nullptr, nullptr, nullptr);
    if (status < 0) return 1;  // at the limit of friction
    sum += std::hypot(by_force[0] ? 0 : f[0], by_force[1] ? 0 : f[1]) * (i == 2 ? size : 1);
  }
  return sum;
}

Outcome read(RollingPair& pair, const Scene& scene) {
  Outcome o;
  o.status = rollcon_contact_solve(pair.handle());
  if (o.status < 0) {
    o.message = rollcon_last_error();
    return o;
  }
  o.solution = pair.solution();
  o.size = std::sqrt(pair.stat("contact_area") / std::numbers::pi);
  o.bound = scene.given.friction[0] * -o.solution.force[2];
  o.estimate = pair.stat("error_estimate");
  for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
    o.law = std::max(o.law, pair.stat(law));
  if (o.status == ROLLCON_OK && o.has_friction()) o.by_loads = errors_by_loads(pair, scene, o.size);
  return o;
}

/// Solves with `accuracy` as the option frame_accuracy; 0 leaves it.
Outcome solve_without_frame(const Scene& scene, double accuracy) {
  const Scene plain = without_frame(scene);
  const auto pair = extremes::make_pair(plain);
  int warnings = 0;
  EXPECT_EQ(rollcon_context_set_log(pair->context(), ROLLCON_LOG_WARNING, count_warning, &warnings), ROLLCON_OK);
  extremes::give_loads(*pair, plain);
  if (accuracy > 0) pair->option("frame_accuracy", accuracy);
  Outcome o = read(*pair, plain);
  o.warnings = warnings;
  return o;
}

bool all_finite(const Outcome& o) {
  const Solution& s = o.solution;
  bool finite = std::isfinite(s.approach) && std::isfinite(o.size) && std::isfinite(o.estimate);
  for (std::size_t i = 0; i < 3; ++i)
    finite = finite && std::isfinite(s.force[i]) && std::isfinite(s.moment[i]) && std::isfinite(s.creep[i]);
  for (std::size_t k = 0; k < s.nodes(); ++k)
    for (const double v : {s.traction[k][0], s.traction[k][1], s.traction[k][2], s.slip[k][0], s.slip[k][1], s.gap[k]})
      finite = finite && std::isfinite(v);
  return finite;
}

/// Returns the difference of loads found and those prescribed, over what the contact can carry of their kind.
double missed_load(const Outcome& o, const Scene& scene) {
  const laws::Given& g = scene.given;
  const Solution& s = o.solution;
  const double found[] = {s.force[0], s.force[1], -s.force[2], s.moment[2]};
  const double scale[] = {o.bound, o.bound, -s.force[2], o.bound * o.size};
  double worst = 0;
  for (std::size_t d = 0; d < 4; ++d)
    if (g.by_force[d] && found[d] != g.value[d]) worst = std::max(worst, std::abs(found[d] - g.value[d]) / scale[d]);
  return worst;
}

struct Worst {
  double law = 0, load = 0, beyond_friction = -1, apart = 0, by_loads = 1;
  int compared = 0;
  std::string farthest;
};

/// Compares the force with that on the scene's own frame, where both are claimed to be good to 10 %.
void compare_with_own_frame(const Scene& scene, const Outcome& o, double apart_bound, Worst& worst) {
  if (o.status != ROLLCON_OK || !o.has_friction() || scene.given.frame.nodes() > 2000) return;
  const auto pair = extremes::make_pair(scene);
  extremes::give_scene(*pair, scene);
  const Outcome own = read(*pair, scene);
  if (own.status != ROLLCON_OK || own.estimate > 0.1) return;
  const auto &f = o.solution.force, &g = own.solution.force;
  const double told = o.estimate * o.by_loads + own.estimate * own.by_loads;
  const double apart = std::hypot(f[0] - g[0], f[1] - g[1]) / o.bound / told;
  EXPECT_LE(apart, apart_bound) << full_name(scene);
  ++worst.compared;
  worst.by_loads = std::max({worst.by_loads, o.by_loads, own.by_loads});
  if (apart > worst.apart) worst.apart = apart, worst.farthest = full_name(scene);
}

/// Judges an outcome. A coarse pair has 6 x 4 and 12 x 8 elements; the coarser one carries up to a fifth less spin
/// moment than the contact.
void judge(const Scene& scene, const Outcome& o, bool coarse_pair, Worst& worst) {
  const std::string name = full_name(scene);
  const bool told = o.status == ROLLCON_OK || o.status == ROLLCON_NO_CONTACT;
  EXPECT_EQ(told, o.warnings == 0) << name << ": status " << o.status;
  if (o.status < 0) {
    EXPECT_EQ(o.status, ROLLCON_ERR_LOAD) << name << ": " << o.message;
    EXPECT_TRUE(scene.is_right(ROLLCON_ERR_LOAD) || coarse_pair) << name << ": " << o.message;
    EXPECT_FALSE(extremes::loads_over_friction(scene) < (coarse_pair ? 0.8 : 0.9)) << name << ": " << o.message;
    return;
  }
  EXPECT_TRUE(all_finite(o)) << name;
  if (o.status == ROLLCON_NOT_CONVERGED) return;
  ASSERT_TRUE(o.solved()) << name << ": status " << o.status;
  EXPECT_TRUE(scene.is_right(o.status == ROLLCON_NO_CONTACT ? ROLLCON_NO_CONTACT : ROLLCON_OK))
      << name << ": " << o.status;
  if (o.status == ROLLCON_NO_CONTACT) {
    EXPECT_EQ(o.solution.force, (std::array<double, 3>{})) << name;
    return;
  }
  // Laws are over mean pressures. Where a peak is told that no material bears, they hold beside the peak.
  constexpr double most_peak = 1000;
  double peak = 1;
  if (o.status == ROLLCON_TOO_DEEP)
    for (const double p : o.solution.pressure) peak = std::max(peak, p * o.size * o.size / -o.solution.force[2]);
  peak = std::min(peak, most_peak);
  EXPECT_LE(o.law, law_bound * peak) << name;
  worst.law = std::max(worst.law, o.law);
  const double missed = missed_load(o, scene);
  EXPECT_LE(missed, load_bound) << name;
  worst.load = std::max(worst.load, missed);
  const auto& f = o.solution.force;
  const double force = std::hypot(f[0], f[1]), beyond = o.has_friction() ? force / o.bound - 1 : force;
  EXPECT_LE(beyond, load_bound) << name;
  worst.beyond_friction = std::max(worst.beyond_friction, beyond);
}

/// Expects right ends; at most so many may end without convergence.
void expect_right_ends(const std::vector<Scene>& scenes, double accuracy, double apart_bound, int most_not_converged) {
  Worst worst;
  std::map<std::int32_t, int> count;
  for (const Scene& scene : scenes) {
    const Outcome o = solve_without_frame(scene, accuracy);
    ++count[o.status];
    judge(scene, o, accuracy > 0, worst);
    compare_with_own_frame(scene, o, apart_bound, worst);
    if (o.status == ROLLCON_NOT_CONVERGED) std::printf("%s: not converged\n", full_name(scene).c_str());
  }
  std::printf("%zu scenes: laws %.1e (bound %.0e), loads %.1e and force beyond friction %.1e (bound %.0e)\n",
              scenes.size(), worst.law, law_bound, worst.load, worst.beyond_friction, load_bound);
  std::printf("%d beside their own frames: %.2f of the estimates (bound %.1f), %s; greatest factor by loads %.2f\n",
              worst.compared, worst.apart, apart_bound, worst.farthest.c_str(), worst.by_loads);
  if (scenes.size() >= 20) {
    EXPECT_GT(worst.compared, 0);
  }
  for (const auto& [status, n] : count) std::printf("%5d %s\n", n, rollcon_status_string(status));
  EXPECT_LE(count[ROLLCON_NOT_CONVERGED], most_not_converged);
}

/// Returns every step-th scene from the first one.
std::vector<Scene> some_of(std::vector<Scene> scenes, int first, int step) {
  std::vector<Scene> some;
  for (std::size_t i = static_cast<std::size_t>(first); i < scenes.size(); i += static_cast<std::size_t>(step))
    some.push_back(std::move(scenes[i]));
  return some;
}

// The coarsest pair of frames is accurate enough with 6 % of the force.
constexpr double coarse = 0.06;

/// Expects right ends of the first seeds; at most so many may end without convergence.
void expect_right_ends_of_seeds(std::uint32_t count, int most) {
  const std::uint32_t first = extremes::first_seed();
  if (first != 1) most += 2;
  expect_right_ends(scenes_of_seeds(extremes::random_scene, first, count), coarse, coarse_apart, most);
  expect_right_ends(scenes_of_seeds(extremes::forces_scene, first, count / 3), coarse, coarse_apart, most);
}

TEST(stability, named_scenes_without_a_frame) {
  expect_right_ends(some_of(named_scenes(), 0, 10), coarse, coarse_apart, 0);
}

TEST(stability_long, named_scenes_without_a_frame) {
  expect_right_ends(named_scenes(), coarse, coarse_apart, 0);
}

TEST(stability, random_scenes_without_a_frame) {
  expect_right_ends_of_seeds(15, 0);
}

TEST(stability_long, random_scenes_without_a_frame) {
  expect_right_ends_of_seeds(60, 1);
}

TEST(stability_nightly, random_scenes_without_a_frame) {
  expect_right_ends_of_seeds(180, 1);
}

// The frames have the library's standard accuracy; scenes that need the finest ones take seconds.
class StandardAccuracy : public testing::TestWithParam<int> {};
constexpr int parts = 8;

TEST_P(StandardAccuracy, named_scenes) {
  // One scene of all, friction of 10 on a rigid body, finds no end on finer frames.
  expect_right_ends(some_of(named_scenes(), GetParam(), parts), 0, standard_apart, 1);
}

TEST_P(StandardAccuracy, random_scenes) {
  const std::uint32_t first = extremes::first_seed();
  const int most = first == 1 ? 1 : 2;  // two of all: unlike bodies, friction above 1
  const auto part = [&](std::vector<Scene> scenes) { return some_of(std::move(scenes), GetParam(), parts); };
  expect_right_ends(part(scenes_of_seeds(extremes::random_scene, first, 150)), 0, standard_apart, most);
  expect_right_ends(part(scenes_of_seeds(extremes::forces_scene, first, 60)), 0, standard_apart, most);
}

INSTANTIATE_TEST_SUITE_P(Parts_nightly, StandardAccuracy, testing::Range(0, parts));

void expect_the_same_in_other_units(int step, int least) {
  constexpr double bound = 1e-9;
  std::vector<Scene> scenes = named_scenes();
  for (Scene& scene : scenes_of_seeds(extremes::random_scene, 1, 60)) scenes.push_back(std::move(scene));
  double worst = 0;
  int compared = 0;
  for (const Scene& scene : some_of(std::move(scenes), 0, step)) {
    const Outcome here = solve_without_frame(scene, coarse);
    const Outcome there = solve_without_frame(extremes::in_units(scene, 1e3, 1e-6), coarse);
    EXPECT_EQ(here.status, there.status) << full_name(scene);
    if (!here.solved() || !here.has_friction()) continue;
    const Shares a = here.shares(), b = there.shares();
    double difference = std::abs(a.approach - b.approach) / std::abs(a.approach);
    // Creepages amplify the rounding of forces without bound next to the limit of friction.
    const bool free = std::hypot(a.force[0], a.force[1]) < 0.9999;
    // The creepage is not less than what slides all of the contact, roughly, because creepages may be zero by symmetry.
    const double creep =
        std::max(std::hypot(a.creep[0], a.creep[1], a.creep[2]), scene.given.friction[0] * std::abs(a.approach));
    for (std::size_t k = 0; k < 3; ++k) {
      difference = std::max(difference, std::abs(a.force[k] - b.force[k]));
      if (free) difference = std::max(difference, std::abs(a.creep[k] - b.creep[k]) / creep);
    }
    EXPECT_LE(difference, bound) << full_name(scene);
    worst = std::max(worst, difference);
    ++compared;
  }
  EXPECT_GE(compared, least);
  std::printf("%d scenes in mm, MPa and um, TPa: differ by %.1e (bound %.0e)\n", compared, worst, bound);
}

TEST(stability, units_of_scenes_without_a_frame) {
  expect_the_same_in_other_units(16, 15);
}

TEST(stability_long, units_of_scenes_without_a_frame) {
  expect_the_same_in_other_units(3, 80);
}

}  // namespace
}  // namespace rollcon::without_frames
