// Measures creep-force tables: errors of force and spin moment over random Hertzian cases, by region, beside FASTSIM
// (J. J. Kalker, Vehicle System Dynamics 11 (1982) 1-13) on the same cases; unlike bodies; times of an evaluation.
// Errors are over mu Fn (moments over mu Fn sqrt(a b)).

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "bench.hpp"
#include "rolling_cases.hpp"
#include "statistics.hpp"
#include "support/closed_forms.hpp"

namespace rollcon::bench {
namespace {

using Input = std::array<double, 9>;
using closed_forms::Elastic;
using rolling_cases::load;
using rolling_cases::mu;
using rolling_cases::poisson;
using rolling_cases::shear;
using rolling_cases::steel;
constexpr const char* steel_on_steel = "steel on steel";
constexpr const char* poissons_ratio = "Poisson's ratio";
constexpr double pair_ratio = 5;  ///< greatest ratio of tables of a pair

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Returns FASTSIM's forces on n x n cells; c holds C11, C22, C23.
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
  /// Returns numbers that a fraction of all does not exceed, for each of 0 .. parts over parts.
  static std::vector<double> quantiles(std::vector<double> v, std::size_t parts) {
    std::sort(v.begin(), v.end());
    std::vector<double> q;
    for (std::size_t k = 0; k <= parts; ++k) q.push_back(v[k * (v.size() - 1) / parts]);
    return q;
  }
};

struct Times {
  double forces = 0, derivatives = 0;
  double table_cold = 0, all_cold = 0;  ///< seconds with the table in memory alone; with the code as well
};

void emit(Runner& runner, const char* method, const char* model, const std::string& region, const Errors& e,
          const Times& times) {
  if (e.force.empty()) return;
  constexpr std::size_t parts = 400;
  const bool steel_alone = std::string(model) == steel_on_steel, by_poisson = std::string(model) == poissons_ratio;
  Record r{.case_name = steel_alone  ? "creep_table"
                        : by_poisson ? "creep_table_poisson"
                                     : "creep_table_unlike",
           .method = method};
  r.model = model;
  r.mesh = region;
  r.quantity = "root mean square error of the force over mu Fn";
  r.against = steel_alone ? "finer strips" : by_poisson ? "strips as fine as the table's" : "frames of the library";
  r.value = r.error = rms(e.force);
  r.moment_error = rms(e.moment);
  r.seconds = times.forces;
  const auto force = Errors::quantiles(e.force, parts), moment = Errors::quantiles(e.moment, parts);
  r.extra = {{"cases", static_cast<double>(e.force.size())},
             {"force_99", force[parts * 99 / 100]},
             {"force_worst", force[parts]},
             {"moment_99", moment[parts * 99 / 100]},
             {"moment_worst", moment[parts]},
             {"seconds_with_derivatives", times.derivatives},
             {"seconds_table_cold", times.table_cold},
             {"seconds_all_cold", times.all_cold}};
  r.series = {{"force_quantiles", force}, {"moment_quantiles", moment}};
  runner.emit(r);
}

struct Region {
  const char* name;
  double least_ratio, ratio, least_magnitude, magnitude;
  bool holds(const RollingCase& d) const {
    return d.ratio >= least_ratio && d.ratio < ratio && d.magnitude >= least_magnitude && d.magnitude < magnitude;
  }
};
constexpr Region regions[] = {
    {"a/b below 0.2, r below 0.75", 0, 0.2, 0, 0.2},    {"a/b below 0.2, r 0.75 to 4.5", 0, 0.2, 0.2, 0.6},
    {"a/b below 0.2, r above 4.5", 0, 0.2, 0.6, 1},     {"a/b 0.2 to 5, r below 0.75", 0.2, 5, 0, 0.2},
    {"a/b 0.2 to 5, r 0.75 to 4.5", 0.2, 5, 0.2, 0.6},  {"a/b 0.2 to 5, r above 4.5", 0.2, 5, 0.6, 1},
    {"a/b above 5, r below 0.75", 5, HUGE_VAL, 0, 0.2}, {"a/b above 5, r 0.75 to 4.5", 5, HUGE_VAL, 0.2, 0.6},
    {"a/b above 5, r above 4.5", 5, HUGE_VAL, 0.6, 1}};

/// Returns the seconds of one evaluation on one of many copies of the standard table, in turn: code is in the caches,
/// the table is not.
double table_cold_seconds(const std::vector<RollingCase>& drawn) {
  rollcon_context* context = nullptr;
  rollcon_context_create(ROLLCON_ABI, &context);
  std::array<rollcon_table*, 80> copy{};
  for (auto& table : copy) rollcon_table_standard(context, &table);
  Forces f{};
  constexpr std::size_t rounds = 50;
  const double began = cpu_seconds();
  for (std::size_t i = 0; i < rounds * copy.size(); ++i)
    rollcon_table_evaluate(copy[i % copy.size()], 1, drawn[i % drawn.size()].input.data(), f.data());
  const double seconds = (cpu_seconds() - began) / static_cast<double>(rounds * copy.size());
  for (auto* table : copy) rollcon_table_release(table);
  rollcon_context_release(context);
  return seconds;
}

/// Returns the median seconds of one evaluation after other data has filled all caches.
double all_cold_seconds(const rollcon_table* table, const std::vector<RollingCase>& drawn) {
  std::vector<double> other(std::size_t{16} << 20), seconds;
  for (std::size_t i = 0; i < std::min<std::size_t>(drawn.size(), 40); ++i) {
    for (std::size_t k = 0; k < other.size(); k += 8) other[k] += 1;
    Forces f{};
    const double began = cpu_seconds();
    rollcon_table_evaluate(table, 1, drawn[i].input.data(), f.data());
    seconds.push_back(cpu_seconds() - began);
  }
  return quantile(seconds, 0.5);
}

Times time_table(const rollcon_table* table, const std::vector<RollingCase>& drawn) {
  Times times;
  const std::size_t cases = std::min<std::size_t>(drawn.size(), 1000);
  constexpr int repeats = 200;
  const double parts = static_cast<double>(repeats) * static_cast<double>(cases);
  Forces f{};
  double by[27];
  double began = cpu_seconds();
  for (int k = 0; k < repeats; ++k)
    for (std::size_t i = 0; i < cases; ++i) rollcon_table_evaluate(table, 1, drawn[i].input.data(), f.data());
  times.forces = (cpu_seconds() - began) / parts;
  began = cpu_seconds();
  for (int k = 0; k < repeats; ++k)
    for (std::size_t i = 0; i < cases; ++i)
      rollcon_table_evaluate_derivatives(table, 1, drawn[i].input.data(), f.data(), by);
  times.derivatives = (cpu_seconds() - began) / parts;
  times.table_cold = table_cold_seconds(drawn);
  times.all_cold = all_cold_seconds(table, drawn);
  return times;
}

/// Returns linear theory's coefficients of the table: C11, C22, C23.
std::array<double, 3> coefficients(const rollcon_table* table, Input rest) {
  Forces f{};
  double by[27];
  rest[6] = rest[7] = rest[8] = 0;
  rollcon_table_evaluate_derivatives(table, 1, rest.data(), f.data(), by);
  const double area = rest[3] * rest[4];
  return {-by[6] / (shear * area), -by[9 + 7] / (shear * area), -by[9 + 8] / (shear * area * std::sqrt(area))};
}

Errors table_errors(const rollcon_table* table, const std::vector<RollingCase>& drawn, const std::vector<Forces>& exact,
                    const Region* region) {
  Errors errors;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (region && !region->holds(drawn[i])) continue;
    Forces f{};
    rollcon_table_evaluate(table, 1, drawn[i].input.data(), f.data());
    errors.add(f, exact[i], drawn[i].input);
  }
  return errors;
}

/// Returns forces by frames finer than the table's, and once more by yet finer ones where these differ from the table,
/// and at every hundredth case, which tells their own error.
std::vector<Forces> references(Runner& runner, const rollcon_table* table, const std::vector<RollingCase>& drawn) {
  constexpr double differs = 0.002;
  constexpr std::size_t each = 100;
  std::vector<Forces> exact = rolling_cases::solve_on_strips(drawn, runner.quick ? 1 : 1.5, runner.threads);
  const Errors e = table_errors(table, drawn, exact, nullptr);
  std::vector<std::size_t> which;
  std::vector<RollingCase> again;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (i % each != 0 && std::max(e.force[i], e.moment[i]) < differs) continue;
    which.push_back(i);
    again.push_back(drawn[i]);
  }
  const auto finer = rolling_cases::solve_on_strips(again, runner.quick ? 1.5 : 2.2, runner.threads);
  Errors own;
  for (std::size_t k = 0; k < which.size(); ++k) {
    if (which[k] % each == 0) own.add(exact[which[k]], finer[k], again[k].input);
    exact[which[k]] = finer[k];
  }
  emit(runner, "the reference's frames", steel_on_steel, "every hundredth", own, {});
  return exact;
}

void run_steel(Runner& runner, const rollcon_table* table, std::size_t count) {
  const std::vector<RollingCase> drawn = rolling_cases::draw(count, 20261124, shear);
  const char* model = steel_on_steel;
  const std::vector<Forces> exact = references(runner, table, drawn);
  emit(runner, "table", model, "all", table_errors(table, drawn, exact, nullptr), time_table(table, drawn));
  for (const Region& region : regions)
    emit(runner, "table", model, region.name, table_errors(table, drawn, exact, &region), {});
  Errors by_fastsim;
  double seconds = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto c = coefficients(table, drawn[i].input);
    const double began = cpu_seconds();
    const Forces f = fastsim(drawn[i].input, c, 50);
    seconds += cpu_seconds() - began;
    by_fastsim.add(f, exact[i], drawn[i].input);
  }
  emit(runner, "FASTSIM, 50 x 50", model, "all", by_fastsim, {.forces = seconds / static_cast<double>(count)});
}

/// Compares the table at and beyond its Poisson's ratios with frames as fine as its own.
void run_poisson(Runner& runner, const rollcon_table* table, std::size_t count) {
  std::vector<RollingCase> drawn = rolling_cases::draw(count, 777, shear);
  for (const double ratio : {0.24, 0.25, 0.28, 0.31, 0.33, 0.34}) {
    for (RollingCase& d : drawn) d.input[1] = ratio;
    const std::vector<Forces> exact = rolling_cases::solve_on_strips(drawn, 1, runner.threads);
    emit(runner, "table", poissons_ratio, std::to_string(ratio), table_errors(table, drawn, exact, nullptr), {});
  }
}

/// Makes a table of these two bodies alone: ellipses 1 : 5 to 5 : 1, one coefficient of friction.
rollcon_table* table_of_pair(rollcon_context* context, const double (&young)[2], bool coarse) {
  const double poissons[2] = {poisson, poisson};
  rollcon_table* table = nullptr;
  rollcon_table_create(context, &table);
  rollcon_table_set_ratios(table, coarse ? 4 : 6, 1 / pair_ratio, pair_ratio);
  if (coarse) rollcon_table_set_resolution(table, 8, 4, 4);
  if (coarse) rollcon_table_set_frame(table, 6, 4);
  rollcon_table_set_bodies(table, young, poissons, 1, &mu);
  if (rollcon_table_make(table, 0, 1) == ROLLCON_OK) return table;
  rollcon_table_release(table);
  return nullptr;
}

/// Compares unlike bodies by the rule of rollcon_contact_get_equivalent_ellipse, and by a table of their own.
void run_unlike(Runner& runner, const rollcon_table* table, std::size_t count) {
  struct Pair {
    const char* name;
    Elastic body1;
    std::optional<Elastic> body2;
  };
  const Elastic soft{.shear = shear / 3, .poisson = poisson};
  rollcon_context* context = nullptr;
  rollcon_context_create(ROLLCON_ABI, &context);
  rollcon_context_set_threads(context, runner.threads);
  for (const Pair& bodies : {Pair{"moduli 3 : 1", steel, soft}, Pair{"on a rigid body", steel, std::nullopt}}) {
    const double flexible = 1 / bodies.body1.shear, other = bodies.body2 ? 1 / bodies.body2->shear : 0;
    std::vector<RollingCase> drawn = rolling_cases::draw(count, 20261125, 2 / (flexible + other));
    const auto exact =
        rolling_cases::solve(drawn, bodies.body1, bodies.body2, runner.quick ? 0.02 : 0.003, runner.threads);
    emit(runner, "table, like bodies", bodies.name, "all", table_errors(table, drawn, exact, nullptr), {});
    std::vector<RollingCase> strained = drawn;
    for (RollingCase& d : strained) {
      const double a = d.input[3], b = d.input[4], greatest = 3 * load / (2 * std::numbers::pi * a * b);
      d.input[6] += 0.75 * greatest * b / (a + b) * (1 - 2 * poisson) / 2 * (flexible - other);
    }
    emit(runner, "table, mean strain on top", bodies.name, "all", table_errors(table, strained, exact, nullptr), {});
    const double modulus = 2 * (1 + poisson), young[2] = {modulus * shear, other > 0 ? modulus / other : 0};
    if (rollcon_table* own = table_of_pair(context, young, runner.quick)) {
      const Region within{"0.2 to 5", 1 / pair_ratio, pair_ratio, 0, 1};
      emit(runner, "table, mean strain on top", bodies.name, within.name, table_errors(table, strained, exact, &within),
           {});
      emit(runner, "table of the pair", bodies.name, within.name, table_errors(own, drawn, exact, &within), {});
      rollcon_table_release(own);
    }
  }
  rollcon_context_release(context);
}

/// Calls `measure` with the standard table and the number of cases.
template <class Measure>
void with_standard(const Runner& runner, std::size_t usual, Measure measure) {
  rollcon_context* context = nullptr;
  rollcon_table* table = nullptr;
  rollcon_context_create(ROLLCON_ABI, &context);
  const std::size_t count = runner.scenes > 0 ? static_cast<std::size_t>(runner.scenes) : runner.quick ? 40 : usual;
  if (rollcon_table_standard(context, &table) == ROLLCON_OK) measure(table, count);
  rollcon_table_release(table);
  rollcon_context_release(context);
}

void run(Runner& runner) {
  with_standard(runner, 20000, [&](const rollcon_table* table, std::size_t count) { run_steel(runner, table, count); });
}

void run_pairs(Runner& runner) {
  with_standard(runner, 1000, [&](const rollcon_table* table, std::size_t count) { run_unlike(runner, table, count); });
}

void run_poissons(Runner& runner) {
  with_standard(runner, 400, [&](const rollcon_table* table, std::size_t count) { run_poisson(runner, table, count); });
}

}  // namespace

std::vector<Case> creep_table_cases() {
  return {{"creep_table", "creep-force tables and FASTSIM beside solved cases", run},
          {"creep_table_poisson", "the standard table at and beyond its Poisson's ratios", run_poissons},
          {"creep_table_unlike", "creep-force tables of unlike bodies beside solved cases", run_pairs}};
}

}  // namespace rollcon::bench
