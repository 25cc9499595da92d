// Compares a step in time with a steady warm solve of the same loads: two contacts of a wheelset's oscillation, one in
// steps, are solved in turn, so that the machine's load does not tell.

#include <cstdio>
#include <ctime>
#include <string>

#include "bench.hpp"
#include "memory.hpp"
#include "support/wheelset_run.hpp"

namespace rollcon::bench {
namespace {

using wheelset_run::Drive;

double cpu_now() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Walk {
  std::string model;
  int elements;  ///< along one side
  const char* operators;
  Drive drive;
  double second_poisson;  ///< Poisson's ratio of body 2
  double distance;        ///< distance of a step, over an element
  bool shift = false;
};

struct Sum {
  double seconds = 0;
  std::int64_t iterations = 0, allocations = 0, fallbacks = 0, failed = 0;

  void solve(rollcon_contact* contact, bool count) {
    const std::int64_t before = heap_allocations();
    const double began = cpu_now();
    const std::int32_t status = rollcon_contact_solve(contact);
    const double spent = cpu_now() - began;
    const std::int64_t made = heap_allocations() - before;
    if (!count) return;
    double n = 0, f = 0;
    rollcon_contact_get_stat(contact, "iterations", &n);
    rollcon_contact_get_stat(contact, "fallbacks", &f);
    seconds += spent;
    iterations += static_cast<std::int64_t>(n);
    fallbacks += static_cast<std::int64_t>(f);
    allocations += made;
    failed += status < 0 || status == ROLLCON_NOT_CONVERGED;
  }
};

void run(Runner& runner, const Walk& walk) {
  const closed_forms::Elastic steel{.shear = wheelset_run::young / (2 * (1 + wheelset_run::poisson)),
                                    .poisson = wheelset_run::poisson};
  closed_forms::Elastic other = steel;
  if (walk.second_poisson != steel.poisson) other = {0.7 * steel.shear, walk.second_poisson};
  scenes::RollingPair steady(steel, other, runner.threads), steps(steel, other, runner.threads);
  const double element = 2 * wheelset_run::half_along / walk.elements;
  for (scenes::RollingPair* pair : {&steady, &steps}) {
    wheelset_run::set_scene(pair->handle(), walk.elements);
    pair->option("tolerance", wheelset_run::tolerance).option("operators", walk.operators);
  }
  rollcon_contact_set_step(steps.handle(), walk.shift ? ROLLCON_SHIFT_STEP : ROLLCON_ROLLING_STEP,
                           walk.distance * element / 30000);
  const int most = walk.elements > 60 ? 60 : walk.elements > 25 ? 300 : 3000;
  const std::int64_t solves = runner.quick ? most / 10 : most, warm_up = solves / 3;
  Sum of_steady, of_steps;
  for (std::int64_t i = -warm_up; i < solves; ++i) {
    wheelset_run::Step s = wheelset_run::step(4 * i, walk.drive);
    wheelset_run::prescribe(steady.handle(), s, walk.drive);
    if (walk.shift) {
      s.lateral *= element, s.spin *= element;
      if (walk.drive == Drive::creepage) s.longitudinal *= element;
    }
    wheelset_run::prescribe(steps.handle(), s, walk.drive);
    of_steady.solve(steady.handle(), i >= 0);
    of_steps.solve(steps.handle(), i >= 0);
  }
  Record record{.case_name = "time_steps", .method = walk.operators, .model = walk.model};
  record.element = "quad4";
  record.mesh = std::to_string(walk.elements) + " x " + std::to_string(walk.elements);
  record.threads = runner.threads;
  record.quantity = "CPU time of a step over that of a steady warm solve";
  record.against = "1.5";
  record.value = of_steps.seconds / of_steady.seconds;
  record.error = record.value / 1.5 - 1;
  record.status = of_steps.failed > 0 ? ROLLCON_NOT_CONVERGED : 0;
  record.seconds = of_steps.seconds;
  record.iterations = of_steps.iterations;
  rollcon_contact_get_size(steps.handle(), &record.nodes, &record.elements);
  const auto each = [&](double sum) { return sum / static_cast<double>(solves); };
  record.extra = {{"milliseconds_per_step", 1e3 * each(of_steps.seconds)},
                  {"milliseconds_per_steady_solve", 1e3 * each(of_steady.seconds)},
                  {"iterations_per_step", each(static_cast<double>(of_steps.iterations))},
                  {"iterations_per_steady_solve", each(static_cast<double>(of_steady.iterations))},
                  {"allocations", static_cast<double>(of_steps.allocations)},
                  {"fallbacks", static_cast<double>(of_steps.fallbacks)},
                  {"failed", static_cast<double>(of_steps.failed)}};
  runner.emit(record);
  std::printf("    ratio %.2f; %.3f ms a step, %.3f ms steady; iterations %.2f, %.2f; %lld allocations, %lld failed\n",
              record.value, 1e3 * each(of_steps.seconds), 1e3 * each(of_steady.seconds),
              each(static_cast<double>(of_steps.iterations)), each(static_cast<double>(of_steady.iterations)),
              static_cast<long long>(of_steps.allocations), static_cast<long long>(of_steps.failed));
}

void time_steps(Runner& runner) {
  const double nu = wheelset_run::poisson;
  for (const Drive drive : {Drive::creepage, Drive::traction}) {
    const std::string given = drive == Drive::creepage ? "creepages given" : "traction given";
    run(runner, {given + ", an element a step", 15, "table", drive, nu, 1});
    run(runner, {given + ", four contact lengths a step", 15, "table", drive, nu, 45});
    run(runner, {given + ", dissimilar, an element a step", 15, "table", drive, 0.45, 1});
    run(runner, {given + ", shift", 15, "table", drive, nu, 1, true});
    run(runner, {given + ", an element a step", 31, "table", drive, nu, 1});
    run(runner, {given + ", an element a step", 31, "fft", drive, nu, 1});
    run(runner, {given + ", dissimilar, an element a step", 31, "fft", drive, 0.45, 1});
    run(runner, {given + ", shift", 31, "fft", drive, nu, 1, true});
    run(runner, {given + ", an element a step", 127, "fft", drive, nu, 1});
  }
}

}  // namespace

std::vector<Case> time_step_cases() {
  return {{"time_steps", "steps in time beside steady solves", time_steps}};
}

}  // namespace rollcon::bench
