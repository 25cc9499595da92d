// Measures frictionless Hertz contact: force at given approach over mesh size, kind of frame and axis ratio.

#include <cmath>
#include <cstdio>

#include "meshes.hpp"
#include "study.hpp"
#include "support/hertz_fit.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Hertz;
using scenes::RollingPair;

const closed_forms::Elastic steel{.shear = 82000, .poisson = 0.28};
constexpr double reach = 28.0 / 24.0;

/// Presses half-spaces together.
void press(Runner& runner, const Hertz& exact, const SurfaceMesh& mesh, const std::string& element,
           const std::string& name, int across) {
  Record record{.case_name = "hertz", .method = "frictionless", .model = "half-spaces"};
  record.mesh = name;
  record.element = element;
  record.threads = runner.threads;
  const auto s = cold_solve(runner, record, [&] {
                   auto pair = std::make_unique<RollingPair>(steel, steel, runner.threads);
                   pair->frame(mesh).gap_quadratic(exact.A, exact.B).friction(0);
                   pair->approach(exact.approach);
                   return pair;
                 }).solution;
  const auto fit = scenes::fit_hertz(s, exact.a, exact.b);
  record.quantity = "force at given approach";
  record.against = "Hertz's closed form";
  record.value = -s.force[2] / exact.load;
  record.error = record.value - 1;
  record.extra = {{"error_p0", fit.p0 / exact.p0 - 1},
                  {"error_a", fit.a / exact.a - 1},
                  {"error_b", fit.b / exact.b - 1},
                  {"a_over_b", exact.a / exact.b}};
  add_size(record, across, 0);
  runner.emit(record);
}

void run(Runner& runner) {
  const double e_star = closed_forms::effective_modulus(steel, steel);
  const Hertz circle = closed_forms::hertz_from_axes(1, 1, 1000, e_star);
  for (const FrameKind& kind : frame_kinds) {
    const std::vector<int> sizes = kind.rings ? std::vector{12, 16, 24, 32, 40} : std::vector{12, 24, 36, 48, 60};
    for (const int across : sizes) {
      if (runner.quick && across > 24) continue;
      const std::string name = kind.rings ? " " + std::to_string(across / 2) : " grid " + std::to_string(across);
      press(runner, circle, frame_over(kind, across, 1, 1, reach), kind.name, kind.name + name, across);
    }
  }
  for (double ratio : {0.02, 0.1, 0.2, 0.5, 2.0, 5.0, 10.0, 50.0}) {
    const Hertz exact = closed_forms::hertz_from_axes(std::sqrt(ratio), 1 / std::sqrt(ratio), 1000, e_star);
    char name[40];
    std::snprintf(name, sizeof name, "quad4 24, a/b = %g", ratio);
    press(runner, exact, frame_over(frame_kinds[0], 24, exact.a, exact.b, reach), "quad4", name, 24);
  }
}

}  // namespace

std::vector<Case> hertz_cases() {
  return {{"hertz", "frictionless circle and ellipses on grids and rings", run}};
}

}  // namespace rollcon::bench
