// Measures Krylov iterations per linear system over the size of the mesh, for every preconditioner.

#include <algorithm>
#include <cmath>

#include "procedures.hpp"
#include "support/example1.hpp"
#include "support/steady_rolling.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;
namespace steady_rolling = scenes::steady_rolling;

constexpr double tolerance = 1e-6;  ///< tolerance of GMRES, relative to the residual

/// Finer meshes take minutes.
constexpr int largest_plain_grid = 32;
bool plain(const std::string& preconditioner) {
  return preconditioner == "none" || preconditioner == "diagonal";
}

void solve(Runner& runner, scenes::RollingPair& pair, const std::string& model, const std::string& mesh,
           const char* system, const char* preconditioner) {
  Record record{.case_name = "preconditioners", .model = model};
  record.threads = runner.threads;
  record.mesh = mesh;
  pair.option("linear_tolerance", 0.0);
  const Procedure procedure{
      .system = system, .jacobian = "b_derivative", .linear_solver = "gmres", .preconditioner = preconditioner};
  apply(procedure, pair);
  pair.option("linear_tolerance", tolerance);
  solve_by(procedure, pair, record);
  record.series.clear();
  record.quantity = "Krylov iterations per linear system";
  record.against = "none";
  record.value =
      static_cast<double>(record.linear_iterations) / static_cast<double>(std::max<std::int64_t>(1, record.iterations));
  record.error = NAN;
  runner.emit(record);
}

void run(Runner& runner) {
  std::vector<int> grids{12, 16, 24, 32, 40};
  if (runner.quick) grids.resize(2);
  for (const int n : grids) {
    scenes::RollingPair pair(steady_rolling::steel, std::nullopt, runner.threads);
    steady_rolling::prepare(pair, steady_rolling::grid(n), "b");
    pair.option("convection", "least_squares");
    for (const char* preconditioner : {"none", "diagonal", "kept_lu"})
      if (n <= largest_plain_grid || !plain(preconditioner))
        solve(runner, pair, "half-space on rigid, condensed", "grid " + std::to_string(n), "condensed", preconditioner);
  }
  std::vector<int> rings{4, 6, 8, 10, 12};
  if (runner.quick) rings.resize(1);
  for (const int n : rings)
    for (const bool finite : {false, true}) {
      if (n == 12 && !finite) continue;
      const scenes::MeshedBody ring = finite ? example1::ring_body(example1::fem_ring(n), VolumeType::hex8)
                                             : example1::ring_body(example1::bem_ring(n), ElementType::quad4);
      const auto pair = example1::pair(ring, scenes::TwinBody{}, "least_squares", runner.threads);
      for (const char* system : systems)
        for (const char* preconditioner : {"none", "diagonal", "bodies", "kept_lu"}) {
          const bool eliminated = system == std::string("condensed");
          if (preconditioner == std::string(eliminated ? "bodies" : "kept_lu")) continue;
          if (!eliminated && plain(preconditioner) && n > (finite ? 6 : 8)) continue;
          solve(runner, *pair, std::string(finite ? "FEM on FEM, " : "BEM on BEM, ") + system,
                "zone " + std::to_string(n) + " x " + std::to_string(n), system, preconditioner);
        }
    }
}

}  // namespace

std::vector<Case> preconditioner_cases() {
  return {{"preconditioners", "Krylov iterations over the size of the mesh", run}};
}

}  // namespace rollcon::bench
