// Measures solving again: after a change of creepage (dense systems), along a table of creepages, and along a creep
// curve. The cost of a Newton iteration is set against LAPACK's time for its own system.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>

#include "bench.hpp"
#include "linalg/lapack.hpp"
#include "support/example1.hpp"
#include "support/example3.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::bench {
namespace {

using closed_forms::Elastic;

/// Returns the seconds of a factorisation and one right side in double precision, the least of several.
double lapack_seconds(int n) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> entry(-1, 1);
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> matrix(size * size), b(size, 1.0);
  for (double& v : matrix) v = entry(generator);
  for (std::size_t i = 0; i < size; ++i) matrix[i * (size + 1)] += n;
  std::vector<double> factors;
  std::vector<int> pivot(size);
  double least = INFINITY;
  for (int k = 0; k < (n > 600 ? 5 : 20); ++k) {
    factors = matrix;
    const int one = 1;
    int info = 0;
    const double began = now();
    dgetrf_(&n, &n, factors.data(), &n, pivot.data(), &info);
    dgetrs_("T", &n, &one, factors.data(), &n, pivot.data(), b.data(), &n, &info);
    least = std::min(least, now() - began);
  }
  return least;
}

struct Scene {
  std::string model, mesh;
  std::unique_ptr<scenes::RollingPair> pair;
  std::array<double, 3> creep{};  ///< creepages of the solution that all changes start from
};

std::vector<Scene> resolved_scenes(const Runner& runner) {
  namespace example1 = scenes::example1;
  namespace example3 = scenes::example3;
  namespace rolling = scenes::steady_rolling;
  std::vector<Scene> all;
  {
    auto pair = std::make_unique<scenes::RollingPair>(rolling::steel, rolling::steel, runner.threads);
    rolling::prepare(*pair, rolling::grid(13), "b");
    all.push_back({"identical half-spaces", "13 x 13", std::move(pair)});
  }
  {
    const Elastic soft{.shear = 41000, .poisson = 0.45};
    auto pair = std::make_unique<scenes::RollingPair>(rolling::steel, soft, runner.threads);
    rolling::prepare(*pair, rolling::grid(13), "b");
    pair->load(0.7 * rolling::hertz.load);
    all.push_back({"dissimilar half-spaces", "13 x 13", std::move(pair)});
  }
  {
    const int parts = runner.quick ? 6 : 12;
    auto pair = example1::pair(example1::bem_ring(parts), ElementType::quad4, "characteristic", runner.threads);
    const std::string n = std::to_string(parts);
    all.push_back({"BEM rings", "zone " + n + " x " + n, std::move(pair)});
  }
  if (runner.quick) return all;
  auto pair = example3::pair(example3::frame(673).mesh, "characteristic", runner.threads);
  all.push_back({"half-space on rigid", "673 quad4", std::move(pair)});
  return all;
}

/// Measures one change of creepage, there and back, the least of several.
void resolve(Runner& runner, Scene& scene, double change, double tolerance) {
  scenes::RollingPair& pair = *scene.pair;
  char what[80];
  std::snprintf(what, sizeof what, "seconds of a re-solve after %g %%, tolerance %.0e", 100 * change, tolerance);
  Record record{.case_name = "resolve", .method = "", .model = scene.model};
  record.mesh = scene.mesh;
  record.threads = runner.threads;
  record.quantity = what;
  record.against = "none";
  pair.option("tolerance", tolerance).option("warm_start", std::int64_t{1});
  double least = INFINITY, prepare = 0, newton = 0, linear = 0, iterations = 0, gmres = 0, factorizations = 0;
  const int rounds = runner.quick ? 6 : 24;
  for (int k = 0; k < rounds; ++k) {
    const double factor = k % 2 == 0 ? 1 + change : 1;
    pair.creep(factor * scene.creep[0], factor * scene.creep[1], factor * scene.creep[2]);
    const double began = now();
    record.status = pair.solve();
    const double seconds = now() - began;
    if (k < 2) continue;
    iterations += pair.stat("iterations");
    gmres += pair.stat("linear_iterations");
    factorizations += pair.stat("factorizations");
    if (!(seconds < least)) continue;
    least = seconds;
    newton = pair.stat("seconds_newton");
    linear = pair.stat("seconds_linear");
    prepare = pair.stat("seconds_total") - newton;
    record.iterations = static_cast<std::int64_t>(pair.stat("iterations"));
  }
  const double per_solve = 1.0 / (rounds - 2);
  const int unknowns = static_cast<int>(pair.stat("system_unknowns"));
  const double lapack = lapack_seconds(unknowns);
  record.value = record.seconds = least;
  record.unknowns = unknowns;
  record.pairs = static_cast<std::int64_t>(pair.stat("nodes_contact"));
  record.nodes = static_cast<std::int64_t>(pair.solution().nodes());
  record.phase_seconds = {{"prepare", prepare}, {"newton", newton}, {"linear", linear}};
  const double least_iterations = static_cast<double>(std::max<std::int64_t>(1, record.iterations));
  record.extra = {{"iterations_mean", iterations * per_solve},
                  {"linear_iterations_mean", gmres * per_solve},
                  {"factorizations_mean", factorizations * per_solve},
                  {"system_unknowns", static_cast<double>(unknowns)},
                  {"newton_ms", 1e3 * newton},
                  {"linear_ms", 1e3 * linear},
                  {"prepare_ms", 1e3 * prepare},
                  {"lapack_ms", 1e3 * lapack},
                  {"iteration_over_lapack", newton / least_iterations / lapack}};
  runner.emit(record);
}

/// Measures all five derivatives after a re-solve, in Newton iterations of that solve.
void derive(Runner& runner, Scene& scene) {
  scenes::RollingPair& pair = *scene.pair;
  Record record{.case_name = "resolve", .method = "", .model = scene.model};
  record.mesh = scene.mesh;
  record.threads = runner.threads;
  record.quantity = "five derivatives over a Newton iteration";
  record.against = "none";
  pair.option("tolerance", 1e-10);
  record.value = INFINITY;
  for (int k = 0; k < 12; ++k) {
    const double factor = k % 2 == 0 ? 1.01 : 1;
    pair.creep(factor * scene.creep[0], factor * scene.creep[1], factor * scene.creep[2]);
    record.status = pair.solve();
    const double newton = pair.stat("seconds_newton"), iterations = pair.stat("iterations");
    for (std::int32_t p = ROLLCON_LONGITUDINAL; p <= ROLLCON_FRICTION; ++p)
      rollcon_contact_get_sensitivity(pair.handle(), p, nullptr, nullptr, nullptr, nullptr);
    const double seconds = pair.stat("seconds_sensitivity");
    if (k < 2 || !(iterations > 0) || !(seconds * iterations / newton < record.value)) continue;
    record.value = seconds * iterations / newton;
    record.seconds = seconds;
    record.iterations = static_cast<std::int64_t>(iterations);
    const auto unknowns = static_cast<int>(pair.stat("system_unknowns"));
    record.extra = {{"sensitivity_ms", 1e3 * seconds},
                    {"iteration_ms", 1e3 * newton / iterations},
                    {"lapack_ms", 1e3 * lapack_seconds(unknowns)},
                    {"right_sides", pair.stat("sensitivity_right_sides")},
                    {"factorizations", pair.stat("sensitivity_factorizations")},
                    {"linear_iterations", pair.stat("sensitivity_linear_iterations")}};
  }
  runner.emit(record);
}

void run_resolve(Runner& runner) {
  for (Scene& scene : resolved_scenes(runner)) {
    scene.pair->solve();
    scene.creep = scene.pair->solution().creep;
    for (const std::int32_t direction : {ROLLCON_LONGITUDINAL, ROLLCON_LATERAL, ROLLCON_SPIN})
      rollcon_contact_prescribe(scene.pair->handle(), direction, ROLLCON_BY_MOTION, 0);
    for (const double change : {0.001, 0.01, 0.1})
      for (const double tolerance : {1e-6, 1e-10}) resolve(runner, scene, change, tolerance);
    derive(runner, scene);
  }
}

/// Solves 3000 creepages on a grid of nodes, one after the other, like three nested loops; every other line goes
/// backwards so that each scene neighbours the one before.
void table(Runner& runner, int nodes, const std::string& model, const Elastic& body2, double tolerance, bool turning) {
  namespace rolling = scenes::steady_rolling;
  scenes::RollingPair pair(rolling::steel, body2, runner.threads);
  const auto hertz = closed_forms::hertz_from_axes(rolling::radius, rolling::radius, 1000,
                                                   closed_forms::effective_modulus(rolling::steel, body2));
  pair.frame(rolling::grid(nodes)).gap_quadratic(hertz.A, hertz.B).load(hertz.load);
  pair.friction(rolling::mu).option("tolerance", tolerance);
  const int n1 = 20, n2 = 15, n3 = runner.quick ? 1 : 10;
  // Full sliding comes near 0.75 of mu F / (G a^2); tables are finer at small creepages.
  const double unit = 0.7 * rolling::mu * hertz.load / (rolling::steel.shear * rolling::radius * rolling::radius);
  const auto graded = [](double t) { return t * std::abs(t); };
  Record record{.case_name = "table", .method = turning ? "turning" : "rewinding", .model = model};
  record.mesh = std::to_string(nodes) + " x " + std::to_string(nodes) + " nodes";
  record.threads = runner.threads;
  char what[80];
  std::snprintf(what, sizeof what, "ms per scene, tolerance %.0e", tolerance);
  record.quantity = what;
  record.against = "none";
  double iterations = 0, gmres = 0, factorizations = 0, fallbacks = 0, sliding = 0;
  int failures = 0;
  std::vector<double> least(static_cast<std::size_t>(n1 * n2 * n3), INFINITY);
  for (int pass = 0; pass < 4; ++pass) {
    iterations = gmres = factorizations = fallbacks = sliding = 0;
    std::size_t scene = 0;
    for (int k = 0; k < n3; ++k)
      for (int j = 0; j < n2; ++j)
        for (int i = 0; i < n1; ++i, ++scene) {
          const int jj = turning && k % 2 == 1 ? n2 - 1 - j : j;
          const int ii = turning && (k * n2 + j) % 2 == 1 ? n1 - 1 - i : i;
          pair.creep(unit * graded(2.0 * ii / (n1 - 1) - 1), unit * graded(jj / (n2 - 1.0)),
                     unit / rolling::radius * graded(k / 9.0));
          const double began = now();
          const std::int32_t status = pair.solve();
          least[scene] = std::min(least[scene], now() - began);
          failures += status != ROLLCON_OK && status != ROLLCON_RIM_CONTACT;
          iterations += pair.stat("iterations");
          gmres += pair.stat("linear_iterations");
          factorizations += pair.stat("factorizations");
          fallbacks += pair.stat("fallbacks");
          if (pass == 0) continue;
          sliding += pair.stat("nodes_slip") / pair.stat("nodes_contact");
        }
  }
  const double most = *std::max_element(least.begin(), least.end());
  const double seconds = std::accumulate(least.begin(), least.end(), 0.0);
  const double scenes = n1 * n2 * n3;
  record.status = failures > 0 ? ROLLCON_NOT_CONVERGED : ROLLCON_OK;
  record.seconds = seconds;
  record.value = 1e3 * seconds / scenes;
  record.pairs = static_cast<std::int64_t>(pair.stat("nodes_contact"));
  record.unknowns = static_cast<std::int64_t>(pair.stat("unknowns"));
  record.extra = {{"iterations_mean", iterations / scenes},
                  {"linear_iterations_mean", gmres / scenes},
                  {"factorizations_mean", factorizations / scenes},
                  {"fallbacks", fallbacks},
                  {"failures", static_cast<double>(failures)},
                  {"slowest_ms", 1e3 * most},
                  {"sliding_mean", sliding / scenes},
                  {"nodes_contact", static_cast<double>(record.pairs)}};
  runner.emit(record);
}

void run_table(Runner& runner) {
  namespace rolling = scenes::steady_rolling;
  const Elastic soft{.shear = 41000, .poisson = 0.45};
  // The frames have as many nodes as CONTACT has elements, and 11 x 11 elements.
  for (const int nodes : {11, 12})
    for (const double tolerance : {1e-6, 1e-10})
      for (const bool turning : {true, false}) {
        table(runner, nodes, "identical half-spaces", rolling::steel, tolerance, turning);
        table(runner, nodes, "dissimilar half-spaces", soft, tolerance, turning);
      }
}

/// Runs a time loop of a vehicle: load and creepages vary slowly, each with periods of its own.
void loop(Runner& runner, const std::string& model, const Elastic& body2, double tolerance, bool prediction) {
  namespace rolling = scenes::steady_rolling;
  scenes::RollingPair pair(rolling::steel, body2, runner.threads);
  rolling::prepare(pair, rolling::grid(13), "b");
  pair.option("tolerance", tolerance).option("warm_start", std::int64_t{prediction ? 2 : 1});
  Record record{.case_name = "loop", .method = prediction ? "predicted" : "", .model = model};
  record.mesh = "13 x 13";
  record.threads = runner.threads;
  char what[80];
  std::snprintf(what, sizeof what, "iterations per step, tolerance %.0e", tolerance);
  record.quantity = what;
  record.against = "none";
  const int steps = runner.quick ? 200 : 2000;
  double iterations = 0, predictions = 0, fallbacks = 0, most = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = 0.002 * k;
    pair.load(0.8 * rolling::hertz.load * (1 + 0.2 * std::sin(9 * t)));
    pair.creep(rolling::creepage * std::sin(5 * t), 0.3 * rolling::creepage * std::cos(3 * t),
               rolling::spin * std::sin(2 * t + 1));
    const double began = now();
    const std::int32_t status = pair.solve();
    record.seconds += now() - began;
    if (status != ROLLCON_OK && status != ROLLCON_RIM_CONTACT) record.status = status;
    iterations += pair.stat("iterations");
    most = std::max(most, pair.stat("iterations"));
    predictions += pair.stat("predictions");
    fallbacks += pair.stat("fallbacks");
  }
  record.value = iterations / steps;
  record.iterations = static_cast<std::int64_t>(iterations);
  record.pairs = static_cast<std::int64_t>(pair.stat("nodes_contact"));
  record.extra = {{"ms_per_step", 1e3 * record.seconds / steps},
                  {"predictions", predictions},
                  {"fallbacks", fallbacks},
                  {"most_iterations", most}};
  runner.emit(record);
}

void run_loop(Runner& runner) {
  namespace rolling = scenes::steady_rolling;
  const Elastic soft{.shear = 41000, .poisson = 0.45};
  for (const double tolerance : {1e-6, 1e-10})
    for (const bool prediction : {false, true}) {
      loop(runner, "identical half-spaces", rolling::steel, tolerance, prediction);
      loop(runner, "dissimilar half-spaces", soft, tolerance, prediction);
    }
}

/// Solves 100 creepages from stick to full sliding on the paper's two rings.
void run_curve(Runner& runner) {
  namespace example1 = scenes::example1;
  const int parts = runner.quick ? 6 : 12;
  auto pair = example1::pair(example1::bem_ring(parts), ElementType::quad4, "characteristic", runner.threads);
  pair->solve();
  rollcon_contact_prescribe(pair->handle(), ROLLCON_LONGITUDINAL, ROLLCON_BY_MOTION, 0);
  Record record{.case_name = "curve", .method = "", .model = "BEM rings"};
  record.mesh = "zone " + std::to_string(parts) + " x " + std::to_string(parts);
  record.threads = runner.threads;
  record.quantity = "seconds of 100 points";
  record.against = "none";
  const double most = 3 * std::abs(example1::carter_creepage);
  double least = INFINITY, iterations = 0, gmres = 0, factorizations = 0;
  for (int pass = 0; pass < 3; ++pass) {
    pair->creep(0, 0, 0);
    pair->solve();
    iterations = gmres = factorizations = 0;
    const double began = now();
    for (int k = 1; k <= 100; ++k) {
      pair->creep(-most * k / 100, 0, 0);
      record.status = std::max(record.status, pair->solve());
      iterations += pair->stat("iterations");
      gmres += pair->stat("linear_iterations");
      factorizations += pair->stat("factorizations");
    }
    least = std::min(least, now() - began);
  }
  record.seconds = record.value = least;
  record.pairs = static_cast<std::int64_t>(pair->stat("nodes_contact"));
  record.iterations = static_cast<std::int64_t>(iterations);
  record.extra = {{"iterations_mean", iterations / 100},
                  {"linear_iterations_mean", gmres / 100},
                  {"factorizations_mean", factorizations / 100}};
  runner.emit(record);
}

}  // namespace

std::vector<Case> resolve_cases() {
  return {{"resolve", "solving again after a change of creepage, and derivatives", run_resolve},
          {"table", "3000 creepages on 11 x 11 nodes and elements", run_table},
          {"loop", "iterations along a slowly varying time loop", run_loop},
          {"curve", "creep curve of 100 points on the paper's two rings", run_curve}};
}

}  // namespace rollcon::bench
