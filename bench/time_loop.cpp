// Measures the time loop of a vehicle simulation: one contact of a wheelset, solved again and again while load and
// creepages change slowly. Does it stay as fast and as small as it began?

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <string>

#include "bench.hpp"
#include "memory.hpp"
#include "support/wheelset_run.hpp"

namespace rollcon::bench {
namespace {

using wheelset_run::Drive;

/// Returns the processor seconds of this thread: other work of the machine must not look like growth.
double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Loop {
  std::string model;
  int elements;  ///< along one side
  Drive drive;
  double second_poisson;  ///< Poisson's ratio of body 2
};

struct Part {
  double seconds = 0;
  std::int64_t solves = 0, iterations = 0, most_iterations = 0, fallbacks = 0, allocations = 0;
  std::array<std::int64_t, 7> status{};  ///< how often each status >= 0
  std::int64_t failed = 0;
};

void run(Runner& runner, const Loop& loop) {
  constexpr double young2_over_young = 0.7;  // ratio for dissimilar bodies
  const bool same = loop.second_poisson == wheelset_run::poisson;
  const closed_forms::Elastic steel = closed_forms::Elastic{
      .shear = wheelset_run::young / (2 * (1 + wheelset_run::poisson)), .poisson = wheelset_run::poisson};
  closed_forms::Elastic other = steel;
  if (!same) {
    other.poisson = loop.second_poisson;
    other.shear *= young2_over_young;
  }
  scenes::RollingPair pair(steel, other, runner.threads);
  rollcon_contact* const contact = pair.handle();
  wheelset_run::set_scene(contact, loop.elements);
  pair.option("tolerance", wheelset_run::tolerance);
  const std::int64_t steps = runner.quick ? 2000 : 100000, tenth = steps / 10;
  std::array<Part, 3> part;  // first tenth, between, last tenth
  std::int64_t resident_first = 0;
  constexpr std::int64_t warm_up = 2000;  // one period of the load, after which all sizes of systems occurred
  int told = 0;
  reset_peak_resident();
  for (std::int64_t i = -warm_up; i < steps; ++i) {
    wheelset_run::prescribe(contact, wheelset_run::step(i, loop.drive), loop.drive);
    const std::int64_t before = heap_allocations();
    const double began = cpu_seconds();
    const std::int32_t status = rollcon_contact_solve(contact);
    const double seconds = cpu_seconds() - began;
    const std::int64_t allocations = heap_allocations() - before;
    if (i < 0) continue;
    if (i == 0) reset_peak_resident();
    Part& p = part[i < tenth ? 0 : i < steps - tenth ? 1 : 2];
    p.seconds += seconds;
    ++p.solves;
    p.allocations += allocations;
    if (status < 0)
      ++p.failed;
    else
      ++p.status[static_cast<std::size_t>(status)];
    double iterations = 0, fallbacks = 0;
    rollcon_contact_get_stat(contact, "iterations", &iterations);
    rollcon_contact_get_stat(contact, "fallbacks", &fallbacks);
    p.iterations += static_cast<std::int64_t>(iterations);
    p.most_iterations = std::max(p.most_iterations, static_cast<std::int64_t>(iterations));
    p.fallbacks += static_cast<std::int64_t>(fallbacks);
    if ((status != ROLLCON_OK || fallbacks > 0) && told++ < 4) {
      const auto s = wheelset_run::step(i, loop.drive);
      std::printf(
          "    step %lld: status %d, %g iterations, %g fallbacks; load %.17g, longitudinal %.17g, lateral %.17g, spin "
          "%.17g\n",
          static_cast<long long>(i), status, iterations, fallbacks, s.load, s.longitudinal, s.lateral, s.spin);
    }
    if (i == tenth - 1) resident_first = peak_resident_bytes();
  }
  Part all;
  for (const Part& p : part) {
    all.seconds += p.seconds;
    all.solves += p.solves;
    all.iterations += p.iterations;
    all.most_iterations = std::max(all.most_iterations, p.most_iterations);
    all.fallbacks += p.fallbacks;
    all.allocations += p.allocations;
    all.failed += p.failed;
    for (std::size_t k = 0; k < all.status.size(); ++k) all.status[k] += p.status[k];
  }
  const auto per_solve = [](const Part& p) { return p.seconds / static_cast<double>(p.solves); };
  Record record{.case_name = "time_loop", .method = "warm", .model = loop.model};
  record.element = "quad4";
  record.mesh = std::to_string(loop.elements) + " x " + std::to_string(loop.elements);
  record.threads = runner.threads;
  record.quantity = "iterations per solve, error: growth of CPU time";
  record.value = static_cast<double>(all.iterations) / static_cast<double>(all.solves);
  record.error = per_solve(part[2]) / per_solve(part[0]) - 1;
  record.against = "first tenth of the solves";
  record.status = all.failed > 0 ? ROLLCON_ERR_LOAD : all.status[1] > 0 ? ROLLCON_NOT_CONVERGED : 0;
  record.seconds = all.seconds;
  record.iterations = all.iterations;
  rollcon_contact_get_size(contact, &record.nodes, &record.elements);
  record.resident_bytes = peak_resident_bytes();
  record.extra = {{"solves", static_cast<double>(all.solves)},
                  {"milliseconds_per_solve", 1e3 * per_solve(all)},
                  {"milliseconds_first_tenth", 1e3 * per_solve(part[0])},
                  {"milliseconds_last_tenth", 1e3 * per_solve(part[2])},
                  {"most_iterations", static_cast<double>(all.most_iterations)},
                  {"fallbacks", static_cast<double>(all.fallbacks)},
                  {"allocations", static_cast<double>(all.allocations)},
                  {"resident_growth_bytes", static_cast<double>(record.resident_bytes - resident_first)},
                  {"converged", static_cast<double>(all.status[0])},
                  {"not_converged", static_cast<double>(all.status[1])},
                  {"rim_contact", static_cast<double>(all.status[4])},
                  {"coarse", static_cast<double>(all.status[5])},
                  {"failed", static_cast<double>(all.failed)}};
  runner.emit(record);
}

void time_loop(Runner& runner) {
  const double nu = wheelset_run::poisson;
  for (const int n : {11, 15})
    for (const Loop& loop :
         {Loop{"creepages given", n, Drive::creepage, nu}, Loop{"traction given", n, Drive::traction, nu},
          Loop{"creepages given, dissimilar", n, Drive::creepage, 0.45},
          Loop{"traction given, dissimilar", n, Drive::traction, 0.45}})
      run(runner, loop);
}

}  // namespace

std::vector<Case> time_loop_cases() {
  return {{"time_loop", "100,000 solves of a wheelset's oscillation", time_loop}};
}

}  // namespace rollcon::bench
