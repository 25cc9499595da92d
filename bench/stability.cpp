// Runs rollcon-bench stability [--quick] [--json FILE] [--scenes N] [--threads N].
//
// The cases are named scenes and N random ones (5000), from nothing and from wildly different states; the published
// procedures solve a part of them. Every solve has a record. Cases stability_named, stability_random, stability_forces
// (1000 scenes) and stability_bodies are its parts.

#include "stability.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

namespace rollcon::bench {
namespace {

using extremes::Ending;
using extremes::Scene;

/// Returns the standard procedure and those of the paper on condensed systems. The others cost more and make the same
/// steps (docs/procedures.md).
std::vector<Procedure> published() {
  std::vector<Procedure> all;
  const auto add = [&](const char* jacobian, const char* linear) {
    Procedure p;
    p.jacobian = jacobian;
    p.linear_solver = linear;
    p.max_iterations = 500;  // the standard
    all.push_back(p);
  };
  add("b_derivative", "lu");
  add("b_derivative", "gmres_adaptive");
  add("simplified", "lu");
  add("reduced", "lu");
  return all;
}

bool several_loads(const Scene& scene) {
  const auto& by_force = scene.given.by_force;
  return (by_force[0] || by_force[1]) && by_force[3];
}

class Suite {
 public:
  explicit Suite(Runner& runner) : runner_(runner) {}

  void run_scene(const Scene& scene, std::vector<int> ways) {
    const auto pair = begin(scene, "cold");
    if (!pair) return;
    const Ending cold = extremes::solve(*pair, scene, true);
    judge(scene, "cold", cold);
    for (const int way : ways) {
      const char* name = "warm from another state";
      const Scene other = extremes::disturbed(scene, way);
      try {
        pair->reset();  // nothing may be predicted from the solution wanted
        extremes::give_loads(*pair, other);
        (void)rollcon_contact_solve(pair->handle());
        extremes::give_loads(*pair, scene);
      } catch (const std::exception& error) {
        std::printf("%s: %s, %s: %s\n", scene.group.c_str(), scene.name.c_str(), name, error.what());
        continue;
      }
      const Ending warm = extremes::solve(*pair, scene);
      const double difference =
          warm.solved() && cold.solved() ? extremes::traction_difference(warm.traction, cold.traction) : 0;
      judge(scene, name, warm, difference);
    }
  }

  void run_published(Scene scene) {
    const laws::Scheme scheme = scene.given.scheme;
    std::erase_if(scene.option, [](const auto& option) { return option.first == "operators"; });
    scene.set("operators", std::string("auto"));
    for (const Procedure& procedure : published()) {
      scene.given.scheme =
          procedure.jacobian == "reduced" && scheme == laws::Scheme::characteristic ? laws::Scheme::godunov : scheme;
      const std::string name = procedure.jacobian + " " + procedure.linear_solver;
      const auto pair = begin(scene, name);
      if (!pair) continue;
      apply(procedure, *pair);
      judge(scene, name, extremes::solve(*pair, scene));
    }
  }

  void print() const { table_.print(); }

 private:
  std::unique_ptr<scenes::RollingPair> begin(const Scene& scene, const std::string& way) {
    try {
      auto pair = extremes::make_pair(scene, runner_.threads);
      extremes::give_scene(*pair, scene);
      return pair;
    } catch (const std::exception& error) {
      Ending refused;
      refused.status = ROLLCON_ERR_ARGUMENT;
      refused.message = error.what();
      judge(scene, way, refused);
      return nullptr;
    }
  }

  void judge(const Scene& scene, const std::string& way, const Ending& e, double difference = 0) {
    bool right = scene.is_right(e.status) && (!e.solved() || e.law.turn >= scene.turn);
    if (right && e.status == ROLLCON_ERR_LOAD && scene.right.size() > 1)
      right = several_loads(scene) ? !(extremes::loads_over_friction(scene) < 0.97)
                                   : !(extremes::load_over_friction(scene) < 0.9);
    table_.add(way, scene.group, e, right);
    const bool good = right && e.honest(law_bound);
    if (!good && (way == "cold" || way.starts_with("warm")))
      std::printf("%s: %s, %s: status %d, %s %.1e; %s; %s\n", scene.group.c_str(), scene.name.c_str(), way.c_str(),
                  e.status, e.law.worst_name(), e.law.worst(), extremes::describe(scene).c_str(), e.message.c_str());
    std::fflush(stdout);
    Record record{.case_name = "stability", .method = way, .model = scene.group};
    record.mesh = scene.name;
    record.quantity = "greatest error of the laws";
    record.against = "laws recomputed";
    record.value = record.error = e.status < 0 ? 0 : e.law.worst();
    record.nodes = scene.given.frame.nodes();
    record.elements = scene.given.frame.elements();
    record.pairs = e.law.contact;
    record.status = e.status;
    record.seconds = e.seconds;
    record.iterations = static_cast<std::int64_t>(e.iterations);
    record.threads = runner_.threads;
    record.note = e.message;
    record.extra = {{"right", right},
                    {"residual", e.residual},
                    {"fallbacks", e.fallbacks},
                    {"condition", e.condition},
                    {"tension", e.law.tension},
                    {"penetration", e.law.penetration},
                    {"separation", e.law.separation},
                    {"bound", e.law.bound},
                    {"stick", e.law.stick},
                    {"direction", e.law.direction},
                    {"equilibrium", e.law.equilibrium},
                    {"difference", difference},
                    {"turn", e.law.turn},
                    {"sticking", static_cast<double>(e.law.sticking)}};
    runner_.write(record);
  }

  Runner& runner_;
  StabilityTable table_;
};

constexpr std::int64_t small = 300;  // nodes up to which one can wait for the published procedures

void run_named(Suite& suite, const std::vector<Scene>& scenes, bool quick, std::size_t published_every) {
  std::size_t number = 0;
  for (const Scene& scene : scenes) {
    const bool large = scene.given.frame.nodes() > 2000;
    suite.run_scene(scene, large ? std::vector<int>{} : quick ? std::vector{0} : std::vector{0, 1, 2});
    if (scene.given.frame.nodes() <= small && number++ % published_every == 0) suite.run_published(scene);
  }
}

std::uint32_t random_count(const Runner& runner) {
  return runner.scenes > 0 ? static_cast<std::uint32_t>(runner.scenes) : runner.quick ? 100 : 5000;
}

void run_halfspaces(Runner& runner) {
  Suite suite(runner);
  std::vector<Scene> named = extremes::named_scenes();
  if (runner.quick) std::erase_if(named, [](const Scene& s) { return s.given.frame.nodes() > 400; });
  run_named(suite, named, runner.quick, runner.quick ? 10 : 1);
  for (const auto& [limit, said] : stability_refusals()) {
    std::printf("%s: %s\n", limit.c_str(), said.c_str());
    Record record{.case_name = "stability", .method = "refused", .model = limit};
    record.quantity = "what the library said";
    record.note = said;
    runner.write(record);
  }
  suite.print();
}

void run_random(Runner& runner) {
  Suite suite(runner);
  const std::uint32_t count = random_count(runner);
  for (std::uint32_t seed = 1; seed <= count - stability_random_body_count(count); ++seed) {
    const Scene scene = extremes::random_scene(seed);
    const bool warm = seed % 4 == 0;
    suite.run_scene(scene, warm ? std::vector{static_cast<int>(seed / 4 % 3)} : std::vector<int>{});
    if (scene.given.frame.nodes() <= small && seed % 20 == 0) suite.run_published(scene);
  }
  suite.print();
}

void run_forces(Runner& runner) {
  Suite suite(runner);
  const std::uint32_t count = runner.scenes > 0 ? static_cast<std::uint32_t>(runner.scenes) : runner.quick ? 100 : 1000;
  for (std::uint32_t seed = 1; seed <= count; ++seed) {
    const Scene scene = extremes::forces_scene(seed);
    const bool warm = seed % 4 == 0;
    suite.run_scene(scene, warm ? std::vector{static_cast<int>(seed / 4 % 3)} : std::vector<int>{});
    if (seed % 20 == 0) suite.run_published(scene);
  }
  suite.print();
}

void run_bodies(Runner& runner) {
  Suite suite(runner);
  run_named(suite, stability_body_scenes(runner.quick), runner.quick, 5);
  const std::uint32_t count = stability_random_body_count(random_count(runner));
  for (std::uint32_t seed = 1; seed <= count; ++seed) suite.run_scene(stability_random_body_scene(seed), {});
  suite.print();
}

}  // namespace

std::vector<Case> stability_cases() {
  return {{"stability_named", "extreme scenes of half-spaces, judged by laws recomputed", run_halfspaces},
          {"stability_random", "likewise random ones", run_random},
          {"stability_forces", "likewise with two or three tangential loads given", run_forces},
          {"stability_bodies", "likewise bodies with meshes, named and random ones", run_bodies}};
}

}  // namespace rollcon::bench
