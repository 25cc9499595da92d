// Compares a table of load cases in one call, over threads, with a plain loop of solves.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "bench.hpp"
#include "support/wheelset_run.hpp"

namespace rollcon::bench {
namespace {

struct List {
  std::string name;
  std::vector<double> values;  ///< load, spin, lateral, longitudinal
  std::int64_t cases() const { return static_cast<std::int64_t>(values.size()) / 4; }
};

List grid(bool quick) {
  List list{"grid", {}};
  const int along = quick ? 9 : 21, across = quick ? 5 : 11;
  const auto part = [](int i, int n) { return 2.0 * i / (n - 1) - 1; };
  for (int l = 0; l < 3; ++l)
    for (int s = 0; s < 3; ++s)
      for (int b = 0; b < across; ++b)
        for (int a = 0; a < along; ++a)
          list.values.insert(list.values.end(), {wheelset_run::load * (1 + 0.3 * part(l, 3)), 4e-4 * part(s, 3),
                                                 4e-3 * part(b, across), 4e-3 * part(a, along)});
  return list;
}

List scattered(bool quick) {
  List list{"scattered", {}};
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < (quick ? 150 : 2000); ++i)
    list.values.insert(list.values.end(), {wheelset_run::load * (1 + 0.3 * unit(generator)), 4e-4 * unit(generator),
                                           4e-3 * unit(generator), 4e-3 * unit(generator)});
  return list;
}

struct Run {
  double seconds = 0, iterations = 0;
  std::int64_t not_ok = 0;
  std::vector<double> force;
};

Run one_by_one(scenes::RollingPair& pair, const List& list) {
  Run r;
  r.force.resize(static_cast<std::size_t>(3 * list.cases()));
  pair.reset();
  const double began = now();
  for (std::int64_t i = 0; i < list.cases(); ++i) {
    const double* v = list.values.data() + 4 * i;
    rollcon_contact_set_creep(pair.handle(), v[3], v[2], v[1]);
    rollcon_contact_prescribe(pair.handle(), ROLLCON_NORMAL, ROLLCON_BY_FORCE, v[0]);
    r.not_ok += rollcon_contact_solve(pair.handle()) != ROLLCON_OK;
    rollcon_contact_get_resultant(pair.handle(), ROLLCON_LOCAL, &r.force[3 * static_cast<std::size_t>(i)], nullptr);
    double n = 0;
    rollcon_contact_get_stat(pair.handle(), "iterations", &n);
    r.iterations += n;
  }
  r.seconds = now() - began;
  return r;
}

Run at_once(scenes::RollingPair& pair, const List& list) {
  Run r;
  const auto n = static_cast<std::size_t>(list.cases());
  r.force.resize(3 * n);
  std::vector<double> row(4 * n);
  std::vector<std::int32_t> status(n);
  const double began = now();
  rollcon_contact_solve_many(pair.handle(), "normal spin lateral longitudinal", list.cases(), list.values.data(),
                             "force iterations", 4, row.data(), nullptr, status.data());
  r.seconds = now() - began;
  for (std::size_t i = 0; i < n; ++i) {
    std::copy_n(&row[4 * i], 3, &r.force[3 * i]);
    r.iterations += row[4 * i + 3];
  }
  r.not_ok = std::count_if(status.begin(), status.end(), [](auto s) { return s != ROLLCON_OK; });
  return r;
}

void emit(Runner& runner, const List& list, const Run& run, const Run& loop, const char* method, int threads,
          scenes::RollingPair& pair, int elements) {
  double off = 0;
  for (std::size_t i = 0; i < run.force.size(); ++i)
    off = std::max(off, std::abs(run.force[i] - loop.force[i]) / wheelset_run::load);
  Record record{.case_name = "many", .method = method, .model = "identical half-spaces"};
  record.element = "quad4";
  record.mesh = std::to_string(elements) + " x " + std::to_string(elements) + ", " + list.name + " list";
  record.threads = threads;
  rollcon_contact_get_size(pair.handle(), &record.nodes, &record.elements);
  record.quantity = "milliseconds per case, error: of forces over the load";
  record.against = "solves one by one";
  record.value = 1e3 * run.seconds / static_cast<double>(list.cases());
  record.error = off;
  record.seconds = run.seconds;
  record.iterations = static_cast<std::int64_t>(run.iterations);
  record.status = run.not_ok == 0 ? 0 : ROLLCON_NOT_CONVERGED;
  record.extra = {{"cases", static_cast<double>(list.cases())},
                  {"iterations_per_case", run.iterations / static_cast<double>(list.cases())},
                  {"seconds_over_one_by_one", run.seconds / loop.seconds},
                  {"not_ok", static_cast<double>(run.not_ok)}};
  runner.emit(record);
}

void many(Runner& runner) {
  const closed_forms::Elastic steel{.shear = wheelset_run::young / (2 * (1 + wheelset_run::poisson)),
                                    .poisson = wheelset_run::poisson};
  for (const int elements : {11, 15})
    for (const List& list : {grid(runner.quick), scattered(runner.quick)}) {
      scenes::RollingPair single(steel, steel, 1), twin(steel, steel, 2);
      for (scenes::RollingPair* pair : {&single, &twin}) {
        wheelset_run::set_scene(pair->handle(), elements);
        pair->load(wheelset_run::load);
        pair->solve();  // makes the operators, which are not compared
      }
      // The least of three runs counts, in turns.
      Run loop, one, two;
      for (int k = 0; k < 3; ++k) {
        for (auto& [best, next] :
             {std::pair<Run&, Run>{loop, one_by_one(single, list)}, std::pair<Run&, Run>{one, at_once(single, list)},
              std::pair<Run&, Run>{two, at_once(twin, list)}})
          if (k == 0 || next.seconds < best.seconds) best = next;
      }
      emit(runner, list, loop, loop, "one by one", 1, single, elements);
      emit(runner, list, one, loop, "solve_many", 1, single, elements);
      emit(runner, list, two, loop, "solve_many", 2, twin, elements);
    }
}

}  // namespace

std::vector<Case> many_cases() {
  return {{"many", "a table of load cases in one call against one by one", many}};
}

}  // namespace rollcon::bench
