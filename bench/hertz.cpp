// Frictionless Hertz contact: force at given approach over mesh size, kind of frame and axis ratio.

#include <cmath>
#include <cstdio>

#include "bench.hpp"
#include "support/frames.hpp"
#include "support/graded_disc.hpp"
#include "support/hertz_fit.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Hertz;
using scenes::RollingPair;

const closed_forms::Elastic steel{.shear = 82000, .poisson = 0.28};

void press(Runner& runner, const Hertz& exact, const SurfaceMesh& mesh, const std::string& name) {
  Record record{.case_name = "hertz", .method = "frictionless", .model = "half-spaces"};
  record.mesh = name;
  record.threads = runner.threads;
  const double began = now();
  RollingPair pair(steel, steel, runner.threads);
  pair.frame(mesh).gap_quadratic(exact.A, exact.B).friction(0).approach(exact.approach);
  const auto s = timed_solve(pair, record, began);
  const auto fit = scenes::fit_hertz(s, exact.a, exact.b);
  record.quantity = "force at given approach";
  record.against = "Hertz's closed form";
  record.value = -s.force[2] / exact.load;
  record.error = record.value - 1;
  record.extra = {{"error_p0", fit.p0 / exact.p0 - 1},
                  {"error_a", fit.a / exact.a - 1},
                  {"error_b", fit.b / exact.b - 1},
                  {"a_over_b", exact.a / exact.b},
                  {"across", 2 * std::sqrt(record.pairs / 3.14159265)}};
  runner.emit(record);
}

void run(Runner& runner) {
  const double e_star = closed_forms::effective_modulus(steel, steel);
  const Hertz circle = closed_forms::hertz_from_axes(1, 1, 1000, e_star);
  for (int across : {12, 24, 36, 48}) {
    if (runner.quick && across > 24) continue;
    const double reach = 28.0 / 24.0;
    const auto lines = frames::uniform_lines(-reach, reach, across * 28 / 24);
    const std::string suffix = " grid " + std::to_string(across);
    press(runner, circle, frames::rectangle(ElementType::quad4, lines, lines), "quad4" + suffix);
    press(runner, circle, frames::rectangle(ElementType::tri3, lines, lines), "tri3" + suffix);
    if (across % 2) continue;
    const auto half = frames::uniform_lines(-reach, reach, across * 14 / 24);
    press(runner, circle, frames::rectangle(ElementType::quad8, half, half), "quad8" + suffix);
    press(runner, circle, frames::rectangle(ElementType::tri6, half, half), "tri6" + suffix);
  }
  for (int rings : {6, 8, 12, 16, 20}) {
    if (runner.quick && rings > 8) continue;
    press(runner, circle, scenes::graded_disc(1, 1, rings), "rings " + std::to_string(rings));
  }
  const auto lines = frames::uniform_lines(-28.0 / 24.0, 28.0 / 24.0, 28);
  const SurfaceMesh square = frames::rectangle(ElementType::quad4, lines, lines);
  for (double ratio : {0.02, 0.1, 0.2, 0.5, 2.0, 5.0, 10.0, 50.0}) {
    const Hertz exact =
        closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000, e_star);
    char name[40];
    std::snprintf(name, sizeof name, "quad4 24, a/b = %g", ratio);
    press(runner, exact, frames::stretch(square, exact.a, exact.b), name);
  }
}

}  // namespace

std::vector<Case> hertz_cases() {
  return {{"hertz", "frictionless circle and ellipses on grids and rings", run}};
}

}  // namespace rollcon::bench
