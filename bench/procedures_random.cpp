// Runs the published procedures on contacts of half-spaces drawn at random.

#include <cmath>

#include "procedures.hpp"
#include "support/frames.hpp"

namespace rollcon::bench {
namespace {

struct Drawn {
  std::unique_ptr<scenes::RollingPair> pair{};
  bool force_given = false;
};

/// Draws ellipse, materials, friction, and creepages or forces from one seed.
Drawn draw(std::uint32_t seed, int threads) {
  frames::Random random(seed);
  const auto either = [&] { return random() < 0; };
  using scenes::Elastic;
  const Elastic first{.shear = 1, .poisson = random.between(0, 0.45)};
  Elastic second{.shear = std::pow(10, random.between(-1, 1)), .poisson = random.between(0, 0.45)};
  const bool twins = either(), rigid = either();
  if (twins) second = first;
  const double e_star =
      twins || !rigid ? closed_forms::effective_modulus(first, second) : closed_forms::effective_modulus(first);
  const double a = random.between(0.5, 2), b = 1, mu = random.between(0.05, 0.6);
  const auto hertz = closed_forms::hertz_from_axes(a, b, 1e-3, e_star);
  auto pair = twins || !rigid ? std::make_unique<scenes::RollingPair>(first, second, threads)
                              : std::make_unique<scenes::RollingPair>(first, std::nullopt, threads);
  const int n = 2 * static_cast<int>(random.between(5, 9));
  pair->rectangle(ElementType::quad4, n, n, 1.25 * a, 1.25 * b);
  pair->gap_quadratic(hertz.A, hertz.B).friction(mu).option("convection", "godunov");
  if (either())
    pair->load(hertz.load);
  else
    pair->approach(hertz.approach);
  const bool force_given = either();
  // A creepage of about four times mu p0 / E* saturates friction; beside a given force less of it.
  const double full = (force_given ? 1 : 4) * mu * 1e-3;
  const double longitudinal = full * random.between(-1, 1), lateral = full * random.between(-1, 1);
  const double turning = either() ? full / std::sqrt(a * b) * random.between(-1, 1) : 0;
  pair->creep(longitudinal, lateral, turning);
  if (force_given) pair->tangential_force(ROLLCON_LONGITUDINAL, mu * hertz.load * random.between(-0.8, 0.8));
  return {std::move(pair), force_given};
}

void run(Runner& runner) {
  const std::uint32_t scenes = runner.quick ? 3 : 24;
  constexpr std::int64_t patience = 600;  // what works takes less than a hundred iterations
  std::vector<Procedure> procedures{Procedure{}};
  for (const char* system : systems)
    for (const Procedure& p : procedures_by_solver(system))
      if (p.linear_solver != "gmres") procedures.push_back(p);
  for (Procedure& p : procedures) p.max_iterations = patience;
  for (std::uint32_t seed = 1; seed <= scenes; ++seed) {
    const Drawn drawn = draw(seed, runner.threads);
    const auto& pair = drawn.pair;
    scenes::Solution standard;
    double sticking = 0;
    for (const Procedure& procedure : procedures) {
      Record record{.case_name = "procedures_random", .model = "scene " + std::to_string(seed)};
      record.threads = runner.threads;
      const scenes::Solution s = solve_by(procedure, *pair, record);
      record.series.clear();
      if (standard.nodes() == 0) {
        standard = s;

        sticking = pair->stat("nodes_stick") / pair->stat("nodes_contact");
      }
      record.mesh = std::to_string(record.nodes) + " nodes";
      record.extra.emplace_back("force_given", drawn.force_given);
      record.extra.emplace_back("sticking", sticking);
      record.quantity = "largest difference of tractions";
      record.against = Procedure{}.name();
      record.value = record.error = record.status < 0 ? NAN : traction_difference(standard, s);
      runner.emit(record);
    }
  }
}

}  // namespace

std::vector<Case> procedure_random_cases() {
  return {{"procedures_random", "solution procedures on random contacts of half-spaces", run}};
}

}  // namespace rollcon::bench
