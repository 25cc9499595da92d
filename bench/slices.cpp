// Compares ISO/TS 16281's slice model of rollers with full solutions of the same rollers, and prints the table of
// docs/tutorials/bearings.md. Units: mm, N.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "bench.hpp"

namespace rollcon::bench {
namespace {

constexpr closed_forms::Elastic steel{.shear = 206e3 / 2.6, .poisson = 0.3};
constexpr double radius = 6, half = 5;

struct Roller {
  const char *name, *shape;
  std::vector<double> parameter;
  std::function<double(double)> drop;  ///< how far the profile lies back at y
};

struct Answer {
  double approach = 0, moment = 0, pressure = 0;
};

double modulus() {
  return closed_forms::effective_modulus(steel, steel);
}

/// Solves the slice model: lines that do not feel each other, each with the standard's spring. Its 35948 N/mm^(10/9) is
/// that of a roller between two raceways, of which one gives half.
Answer sliced(const Roller& roller, double tilt, double load) {
  constexpr int slices = 51;
  const double spring = 35948 * std::pow(2, 10.0 / 9) * std::pow(2 * half, 8.0 / 9) / slices;
  const auto place = [](int k) { return half * (2 * (k + 0.5) / slices - 1); };
  const auto press = [&](double approach, Answer& to) {
    double force = 0;
    to = {.approach = approach};
    for (int k = 0; k < slices; ++k) {
      const double y = place(k), q = spring * std::pow(std::max(approach - roller.drop(y) - tilt * y, 0.0), 10.0 / 9);
      force += q, to.moment += q * y;
      to.pressure = std::max(to.pressure, std::sqrt(q * slices / (2 * half) * modulus() / (std::numbers::pi * radius)));
    }
    return force;
  };
  Answer answer;
  double low = -1, high = 1;
  for (int step = 0; step < 60; ++step) {
    const double middle = (low + high) / 2;
    (press(middle, answer) < load ? low : high) = middle;
  }
  answer.moment = std::abs(answer.moment);
  return answer;
}

Answer full(Runner& runner, const Roller& roller, double tilt, double load, Record& record) {
  const double began = now();
  scenes::RollingPair pair(steel, steel, runner.threads);
  const double centre[3] = {0, 0, radius}, axis[3] = {0, 1, 0};
  rollcon_body_set_profile_shape(pair.body(2), roller.shape, std::ssize(roller.parameter), roller.parameter.data());
  rollcon_body_revolve_profile(pair.body(2), centre, axis, radius);
  const double c = std::cos(tilt), s = std::sin(tilt);
  pair.friction(0).load(load).pose(2, {{{1, 0, 0}, {0, c, -s}, {0, s, c}}}, {}).option("pressure_length", 0.2);
  const scenes::Solution solution = timed_solve(pair, record, began);
  return {solution.approach, std::abs(solution.moment[0]), pair.stat("max_pressure")};
}

void run(Runner& runner) {
  const double relief = 150 / (std::numbers::pi * modulus());
  const Roller rollers[] = {{"straight, sharp ends", "line", {half, 0}, [](double) { return 0.0; }},
                            {"crown of 2000 mm", "arc", {2000, half}, [](double y) { return y * y / 4000; }},
                            {"logarithmic, k 0.999", "roller", {half, relief, 0.999, 0}, [&](double y) {
                               return -relief * std::log(1 - 0.999 * (y / half) * (y / half));
                             }}};
  std::string table =
      "| roller | load, N | tilt, mrad | pressure, MPa | slices | approach, um | slices | moment, N mm | slices |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Roller& roller : rollers)
    for (const double load : {1500.0, 6000.0})
      for (const double tilt : {0.0, 5e-4, 1e-3}) {
        if (runner.quick && (load > 1500 || tilt > 5e-4)) continue;
        char text[200];
        std::snprintf(text, sizeof text, "%g N, %g mrad", load, 1e3 * tilt);
        Record record{.case_name = "slices", .method = "ISO/TS 16281", .model = "half-spaces", .mesh = text};
        record.element = roller.name;
        record.threads = runner.threads;
        const Answer exact = full(runner, roller, tilt, load, record), found = sliced(roller, tilt, load);
        record.quantity = "largest pressure";
        record.against = "the full solution, mean over 0.2 mm";
        record.value = found.pressure;
        record.error = found.pressure / exact.pressure - 1;
        const double approach = found.approach / exact.approach - 1;
        const double moment = tilt > 0 ? found.moment / exact.moment - 1 : 0;
        record.extra = {{"error_approach", approach}, {"error_moment", moment}};
        runner.emit(record);
        std::snprintf(text, sizeof text, "| %s | %.0f | %.1f | %.0f | %+.0f %% | %.2f | %+.0f %% | ", roller.name, load,
                      1e3 * tilt, exact.pressure, 100 * record.error, 1e3 * exact.approach, 100 * approach);
        table += text;
        std::snprintf(text, sizeof text, "%.0f | %+.1f %% |\n", exact.moment, 100 * moment);
        table += tilt > 0 ? text : "0 | |\n";
      }
  std::printf("\n%s", table.c_str());
}

}  // namespace

std::vector<Case> slice_cases() {
  return {{"slices", "the slice model of ISO/TS 16281 beside full solutions of rollers", run}};
}

}  // namespace rollcon::bench
