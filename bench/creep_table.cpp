// Creep-force tables: errors of force and spin moment over random Hertzian cases, beside FASTSIM (J. J. Kalker, Vehicle
// System Dynamics 11 (1982) 1-13) on the same cases, and times of an evaluation. Errors are over mu Fn (moments over
// mu Fn sqrt(a b)).

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "bench.hpp"
#include "support/closed_forms.hpp"
#include "support/frames.hpp"
#include "support/scene.hpp"

namespace rollcon::bench {
namespace {

using Input = std::array<double, 9>;
using Forces = std::array<double, 3>;
constexpr double poisson = 0.28, shear = 82000, mu = 0.3, load = 1e5;

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Ratios of semi-axes 1/25 to 25. Creepages whose linear theory asks for 0.1 to 100 mu Fn, evenly in r / (r + 3), in
/// any direction, spin among them.
Input draw(frames::Random& random) {
  const double ratio = std::exp(random.between(-std::log(25), std::log(25))), size = 5;
  const double a = size * std::sqrt(ratio), b = size / std::sqrt(ratio);
  const double s = random.between(0.03, 0.97), r = 3 * s / (1 - s);
  const double cosine = random.between(-1, 1), sine = std::sqrt(1 - cosine * cosine);
  const double angle = random.between(0, 2 * std::numbers::pi);
  const double unit = r * mu * load / (shear * a * b), wide = std::sqrt(std::cosh(std::log(ratio)));
  const double stiff = 4 * std::max(1.0, 0.3 * ratio);
  return {shear,
          poisson,
          mu,
          a,
          b,
          load,
          unit * sine * std::cos(angle) / stiff,
          unit * sine * std::sin(angle) / stiff,
          unit * cosine / (stiff * wide * size)};
}

Forces solve(const Input& in, double accuracy) {
  const closed_forms::Elastic steel{.shear = shear, .poisson = poisson};
  const double modulus = closed_forms::effective_modulus(steel, steel);
  const double p0 = 3 * load / (2 * std::numbers::pi * in[3] * in[4]);
  const auto hertz = closed_forms::hertz_from_axes(in[3], in[4], p0, modulus);
  scenes::RollingPair pair(steel, steel);
  pair.gap_quadratic(hertz.A, hertz.B).load(load).friction(mu).creep(in[6], in[7], in[8]);
  pair.option("frame_accuracy", accuracy);
  pair.solve();
  const auto s = pair.solution();
  return {s.force[0], s.force[1], s.moment[2]};
}

/// On n x n cells; c: C11, C22, C23.
Forces fastsim(const Input& in, const std::array<double, 3>& c, int n) {
  const double a = in[3], b = in[4];
  const double flex[3] = {8 * a / (3 * shear * c[0]), 8 * a / (3 * shear * c[1]),
                          std::numbers::pi * a * std::sqrt(a / b) / (4 * shear * c[2])};
  Forces f{};
  const double dy = 2 * b / n;
  for (int j = 0; j < n; ++j) {
    const double y = -b + (j + 0.5) * dy, half = a * std::sqrt(1 - y * y / (b * b)), dx = 2 * half / n;
    double p[2] = {0, 0};
    for (int i = 0; i < n; ++i) {
      const double x = half - (i + 0.5) * dx;
      p[0] -= dx * (in[6] / flex[0] - in[8] * y / flex[2]);
      p[1] -= dx * (in[7] / flex[1] + in[8] * x / flex[2]);
      const double bound =
          mu * 2 * load / (std::numbers::pi * a * b) * std::max(0.0, 1 - x * x / (a * a) - y * y / (b * b));
      const double size = std::hypot(p[0], p[1]), part = size > bound ? bound / size : 1;
      p[0] *= part;
      p[1] *= part;
      f[0] += p[0] * dx * dy;
      f[1] += p[1] * dx * dy;
      f[2] += (x * p[1] - y * p[0]) * dx * dy;
    }
  }
  return f;
}

struct Errors {
  std::vector<double> force, moment;
  void add(const Forces& f, const Forces& exact, const Input& in) {
    const double bound = mu * load, arm = std::sqrt(in[3] * in[4]);
    force.push_back(std::hypot(f[0] - exact[0], f[1] - exact[1]) / bound);
    moment.push_back(std::abs(f[2] - exact[2]) / (bound * arm));
  }
  static double rms(const std::vector<double>& v) {
    double sum = 0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum / static_cast<double>(v.size()));
  }
  static double quantile(std::vector<double> v, double part) {
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(part * static_cast<double>(v.size() - 1))];
  }
};

void emit(Runner& runner, const char* method, const Errors& e, double seconds, double seconds_derivatives) {
  Record r{.case_name = "creep_table", .method = method};
  r.model = "steel on steel";
  r.mesh = "random Hertzian cases";
  r.quantity = "root mean square error of the force over mu Fn";
  r.against = "frames of the library";
  r.value = r.error = Errors::rms(e.force);
  r.moment_error = Errors::rms(e.moment);
  r.seconds = seconds;
  r.extra = {{"cases", static_cast<double>(e.force.size())},  {"force_99", Errors::quantile(e.force, 0.99)},
             {"force_worst", Errors::quantile(e.force, 1)},   {"moment_99", Errors::quantile(e.moment, 0.99)},
             {"moment_worst", Errors::quantile(e.moment, 1)}, {"seconds_with_derivatives", seconds_derivatives}};
  runner.emit(r);
}

void run(Runner& runner) {
  rollcon_context* context = nullptr;
  rollcon_table* table = nullptr;
  rollcon_context_create(ROLLCON_ABI, &context);
  if (rollcon_table_standard(context, &table) != ROLLCON_OK) return;
  const int count = runner.quick ? 40 : 1000;
  frames::Random random(20261124);
  std::vector<Input> in;
  for (int i = 0; i < count; ++i) in.push_back(draw(random));
  Errors by_table, by_fastsim;
  double table_seconds = 0, derivative_seconds = 0, fastsim_seconds = 0;
  for (const Input& one : in) {
    const Forces exact = solve(one, runner.quick ? 0.01 : 0.003);
    Forces f{}, rest_force{};
    double by[27];
    double began = cpu_seconds();
    constexpr int repeats = 200;
    for (int k = 0; k < repeats; ++k) rollcon_table_evaluate(table, 1, one.data(), f.data());
    table_seconds += (cpu_seconds() - began) / repeats;
    began = cpu_seconds();
    for (int k = 0; k < repeats; ++k) rollcon_table_evaluate_derivatives(table, 1, one.data(), f.data(), by);
    derivative_seconds += (cpu_seconds() - began) / repeats;
    by_table.add(f, exact, one);
    Input rest = one;
    rest[6] = rest[7] = rest[8] = 0;
    rollcon_table_evaluate_derivatives(table, 1, rest.data(), rest_force.data(), by);
    const double area = one[3] * one[4];
    const std::array<double, 3> c{-by[6] / (shear * area), -by[9 + 7] / (shear * area),
                                  -by[9 + 8] / (shear * area * std::sqrt(area))};
    began = cpu_seconds();
    f = fastsim(one, c, 50);
    fastsim_seconds += cpu_seconds() - began;
    by_fastsim.add(f, exact, one);
  }
  emit(runner, "table", by_table, table_seconds / count, derivative_seconds / count);
  emit(runner, "FASTSIM, 50 x 50", by_fastsim, fastsim_seconds / count, 0);
  rollcon_table_release(table);
  rollcon_context_release(context);
}

}  // namespace

std::vector<Case> creep_table_cases() {
  return {{"creep_table", "creep-force tables and FASTSIM beside solved cases", run}};
}

}  // namespace rollcon::bench
