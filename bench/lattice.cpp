// Measures regular frames on half-spaces by FFT: cases (a) and (b) up to 512 x 512, with creepages or forces given,
// alike and unlike bodies; time and memory over the number of nodes.

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshes.hpp"
#include "study.hpp"
#include "support/carter_strip.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::bench {
namespace {

namespace steady_rolling = scenes::steady_rolling;
using scenes::RollingPair;

constexpr double engineering = 1e-6;  // tolerance of the timed solves

struct Variant {
  const char* name;
  const char* which;  ///< "a" or "b"
  bool rigid;         ///< true for a rigid body 2, which couples normal and tangential problems
  bool forces;        ///< true if the forces of the creepage-driven solution are given instead
};

constexpr Variant variants[] = {{"a", "a", false, false},          {"a, forces", "a", false, true},
                                {"a, on rigid", "a", true, false}, {"a, on rigid, forces", "a", true, true},
                                {"b", "b", false, false},          {"b, forces", "b", false, true},
                                {"b, on rigid", "b", true, false}, {"b, on rigid, forces", "b", true, true}};

std::unique_ptr<RollingPair> make(const Runner& runner, const Variant& v, int n, const char* operators) {
  // A body half as stiff on a rigid one has the same contact.
  const scenes::Elastic half{.shear = steady_rolling::steel.shear / 2, .poisson = steady_rolling::steel.poisson};
  auto pair = v.rigid ? std::make_unique<RollingPair>(half, std::nullopt, runner.threads)
                      : std::make_unique<RollingPair>(steady_rolling::steel, steady_rolling::steel, runner.threads);
  steady_rolling::prepare(*pair, steady_rolling::grid(n), v.which);
  pair->option("tolerance", engineering).option("operators", operators);
  return pair;
}

/// Gives the force and spin moment of the variant's creepages.
void give_forces(RollingPair& pair, const scenes::Solution& s) {
  pair.tangential_force(ROLLCON_LONGITUDINAL, s.force[0]);
  pair.tangential_force(ROLLCON_LATERAL, s.force[1]);
}

void solve(Runner& runner, const Variant& v, int n, const char* operators) {
  Record record{.case_name = "lattice", .method = operators, .model = v.name};
  record.mesh = "grid " + std::to_string(n);
  record.element = "quad4";
  record.threads = runner.threads;
  record.quantity = "Fx/(mu Fn)";
  record.against = v.rigid ? "none" : "CONTACT extrapolated";
  scenes::Solution target;
  if (v.forces) {
    auto pair = make(runner, v, n, operators);
    pair->solve();
    target = pair->solution();
  }
  const Solved solved = cold_solve(runner, record, [&] {
    auto pair = make(runner, v, n, operators);
    if (v.forces) give_forces(*pair, target);
    return pair;
  });
  RollingPair& pair = *solved.pair;
  const scenes::Solution& s = solved.solution;
  record.value = s.force[0] / (steady_rolling::mu * steady_rolling::hertz.load);
  if (!v.rigid) record.judge(steady_rolling::errors(s, v.which));
  record.extra.emplace_back("n", n);
  record.extra.emplace_back("applications", pair.stat("operator_applications"));
  record.extra.emplace_back("bytes_per_node",
                            static_cast<double>(record.peak_bytes) / static_cast<double>(record.nodes));
  if (!v.forces) {
    const double spin = v.which[0] == 'b' ? steady_rolling::spin : 0;
    record.extra.emplace_back("warm_seconds", warm_solve(runner, pair, {steady_rolling::creepage, 0, spin}));
    record.extra.emplace_back("warm_iterations", pair.stat("iterations"));
  }
  if (!v.rigid && !v.forces && n >= 16 && n <= 256)
    record.extra.emplace_back("contact_seconds", closed_forms::steady_rolling(v.which, "seconds_" + std::to_string(n)));
  runner.emit(record);
}

void run(Runner& runner) {
  for (const Variant& v : variants)
    for (const int n : {16, 32, 64, 128, 256, 512}) {
      if (runner.quick && n > 32) continue;
      if (n > 256 && v.forces) continue;
      solve(runner, v, n, "fft");
      if (n <= 64) solve(runner, v, n, "dense");
    }
}

// Makes triangles whose inner nodes are off by a fifth of an edge; graded: a third as wide in the middle as outside.
SurfaceMesh triangles(int n, bool graded) {
  const double half = 1.2 * steady_rolling::radius;
  const auto lines = frames::uniform_lines(-half, half, n);
  const SurfaceMesh even = frames::perturb(frames::rectangle(ElementType::tri3, lines, lines), 0.2, 3);
  const auto place = [&](double t) { return t * (0.55 + 0.45 * t * t / (half * half)); };
  return graded ? frames::transform(even, [&](const Vec3& x) { return Vec3{place(x[0]), place(x[1]), 0}; }) : even;
}

void run_irregular(Runner& runner) {
  for (const bool graded : {false, true})
    for (const int n : {44, 70, 100, 150, 250})
      for (const char* operators : {"dense", "hierarchical"}) {
        const bool dense = operators[0] == 'd';
        if ((runner.quick && n > 44) || (dense && n > 70)) continue;
        const SurfaceMesh mesh = triangles(n, graded);
        Record record{.case_name = "irregular", .method = operators, .model = graded ? "graded 1 : 3" : "even"};
        record.mesh = std::to_string(mesh.nodes()) + " nodes";
        record.element = "tri3";
        record.threads = runner.threads;
        record.quantity = "Fx/(mu Fn)";
        record.against = "CONTACT extrapolated";
        const Solved solved = cold_solve(runner, record, [&] {
          auto pair = std::make_unique<RollingPair>(steady_rolling::steel, steady_rolling::steel, runner.threads);
          steady_rolling::prepare(*pair, mesh, "b");
          pair->option("tolerance", engineering).option("operators", operators);
          return pair;
        });
        RollingPair& pair = *solved.pair;
        record.value = solved.solution.force[0] / (steady_rolling::mu * steady_rolling::hertz.load);
        record.judge(steady_rolling::errors(solved.solution, "b"));
        record.extra.emplace_back("n", mesh.nodes());
        record.extra.emplace_back("applications", pair.stat("operator_applications"));
        record.extra.emplace_back("each", pair.stat("linear_iterations") / pair.stat("right_sides"));
        record.extra.emplace_back("warm_seconds",
                                  warm_solve(runner, pair, {steady_rolling::creepage, 0, steady_rolling::spin}));
        runner.emit(record);
      }
}

}  // namespace

std::vector<Case> lattice_cases() {
  return {
      {"lattice", "regular frames on half-spaces by FFT: time and memory up to 512 x 512", run},
      {"irregular", "triangles on half-spaces: dense and hierarchical operators up to 63,000 nodes", run_irregular}};
}

}  // namespace rollcon::bench
