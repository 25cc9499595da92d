// Compares error estimates with true errors, and measures what they cost: every scene with a known solution, five
// frames and more of each kind.

#include "support/effectivity.hpp"

#include <cmath>

#include "bench.hpp"

namespace rollcon::bench {
namespace {

using namespace scenes;

constexpr const char* schemes[] = {"godunov", "least_squares", "characteristic"};

void emit(Runner& runner, const Judgement& judgement) {
  for (const Judged& j : judgement) {
    Record r{.case_name = "effectivity", .method = j.scheme, .model = j.model};
    r.mesh = j.scene + ": " + j.mesh;
    r.quantity = "error of the " + j.quantity;
    r.against = j.against;
    r.value = j.estimate;
    r.error = j.error;
    r.nodes = j.nodes;
    r.pairs = j.in_contact;
    r.status = j.status;
    r.seconds = j.solve_seconds;
    r.threads = 1;
    r.extra = {{"effectivity", j.effectivity()},
               {"estimate_seconds", j.estimate_seconds},
               {"estimate_over_solve", j.estimate_seconds / j.solve_seconds}};
    runner.emit(r);
  }
}

void frictionless(Runner& runner) {
  for (int across : {8, 12, 16, 24, 36}) {
    if (runner.quick && across > 12) continue;
    for (const bool quadratic : {false, true})
      for (const bool triangles : {false, true})
        emit(runner, judge_hertz(judged_grid(1, 1, across, triangles, quadratic)));
    emit(runner, judge_hertz(judged_unstructured(1, 1, across)));
  }
  for (int rings : {5, 6, 8, 12, 16, 20}) {
    if (runner.quick && rings > 6) continue;
    emit(runner, judge_hertz(judged_rings(1, 1, rings)));
  }
}

void rolling(Runner& runner, const char* scheme) {
  const std::vector<double> axes = creep_curve_axes();
  for (int across : {12, 16, 24, 36, 50}) {
    if (runner.quick && across > 16) continue;
    emit(runner, judge_carter(across, false, scheme));
  }
  for (int across : {10, 14, 20, 28, 40}) {
    if (runner.quick && across > 14) continue;
    emit(runner, judge_carter(across, true, scheme));
  }
  for (const std::string which : {"a", "b"}) {
    for (int across : {12, 16, 20, 24, 32}) {
      if (runner.quick && across > 16) continue;
      emit(runner, judge_steady_rolling(which, judged_grid(5, 5, across), scheme));
      emit(runner, judge_steady_rolling(which, judged_unstructured(5, 5, across), scheme));
      if (across <= 24) emit(runner, judge_steady_rolling(which, judged_grid(5, 5, across, false, true), scheme));
    }
    for (int rings : {5, 6, 8, 12, 16}) {
      if (runner.quick && rings > 6) continue;
      emit(runner, judge_steady_rolling(which, judged_rings(5, 5, rings), scheme));
    }
  }
  for (int direction : {1, 2, 3})
    for (int rings : {5, 6, 8, 10, 12}) {
      if (runner.quick && rings > 6) continue;
      emit(runner, judge_linear_theory(direction, rings, scheme));
    }
  for (double xi : {8e-4, 1.6e-3, 2.4e-3, 3.2e-3}) {
    if (runner.quick && xi > 1e-3) continue;
    for (int across : {12, 18, 24}) {
      if (runner.quick && across > 12) continue;
      emit(runner, judge_creep_curve(xi, judged_grid(axes[0], axes[1], across), scheme));
    }
    for (int rings : {6, 8, 12}) {
      if (runner.quick && rings > 6) continue;
      emit(runner, judge_creep_curve(xi, judged_rings(axes[0], axes[1], rings), scheme));
    }
  }
  for (int nodes : {6, 8, 12, 673, 703, 1985}) {
    if (runner.quick && nodes > 6) continue;
    emit(runner, judge_example3(nodes, scheme));
  }
  for (const bool finite_elements : {true, false})
    for (int across : {8, 10, 12, 16, 20}) {
      if (runner.quick && across > 8) continue;
      emit(runner, judge_block(finite_elements, across, scheme));
    }
}

void run(Runner& runner) {
  frictionless(runner);
  for (const char* scheme : schemes) {
    if (runner.quick && scheme != schemes[2]) continue;
    rolling(runner, scheme);
  }
}

}  // namespace

std::vector<Case> effectivity_cases() {
  return {{"effectivity", "error estimates beside true errors, and their cost", run}};
}

}  // namespace rollcon::bench
