// Measures the paper's figure 16: the time of each way of solving on example 3.

#include <cmath>

#include "procedures.hpp"
#include "support/example3.hpp"

namespace rollcon::bench {
namespace {

namespace example3 = scenes::example3;

struct Mesh {
  int core, rings;
};
constexpr Mesh paper_mesh{16, 6};

/// Solves with every procedure on one frame; differences are from the first one.
void solve_all(Runner& runner, const char* name, const Mesh& mesh, const char* scheme,
               const std::vector<Procedure>& procedures, int repeats) {
  const double reach = 1.3 * example3::hertz().a;
  const SurfaceMesh frame = frames::o_grid(ElementType::quad4, mesh.core, mesh.rings, reach, reach);
  auto pair = example3::pair(frame, scheme, runner.threads);
  pair->solve();  // makes the compliance
  scenes::Solution standard;
  for (const Procedure& procedure : procedures) {
    Record record{.case_name = name, .model = scheme};
    record.mesh = std::to_string(frame.nodes()) + " quad4";
    record.threads = runner.threads;
    const scenes::Solution s = solve_by(procedure, *pair, record, repeats);
    if (standard.nodes() == 0) standard = s;
    record.quantity = "seconds without compliance and convection";
    record.against = "tractions of " + procedures.front().name();
    record.value = record.status < 0 ? NAN : solving_seconds(*pair);
    record.error = record.status < 0 ? NAN : traction_difference(standard, s);
    runner.emit(record);
  }
}

/// Solves for figure 16(a) everything on the paper's frame of linear quadrilaterals.
void one_mesh(Runner& runner) {
  const Mesh mesh = runner.quick ? Mesh{8, 3} : paper_mesh;
  for (const char* scheme : {"godunov", "least_squares"}) {
    std::vector<Procedure> procedures;
    for (const char* system : systems)
      for (const Procedure& p : procedures_by_solver(system)) {
        if (scheme == std::string("godunov"))
          procedures.push_back(p);
        else if (p.system == "condensed" && p.linear_solver == "lu")
          procedures.push_back(
              {.jacobian = p.jacobian, .slip_estimate = p.slip_estimate, .linear_solver = "lu", .max_iterations = 600});
      }
    solve_all(runner, "procedures_example3", mesh, scheme, procedures, runner.quick ? 1 : 2);
    if (runner.quick) break;
  }
}

/// Solves for figure 16(b) with linear solvers relative to LU over the density of the mesh.
void densities(Runner& runner) {
  std::vector<Mesh> meshes{{8, 3}, {10, 4}, {12, 5}, {14, 5}, {16, 6}, {18, 7}};
  if (runner.quick) meshes.resize(2);
  std::vector<Procedure> procedures{Procedure{}};
  for (const char* jacobian : {"b_derivative", "simplified", "reduced"})
    for (const char* solver : linear_solvers)
      procedures.push_back({.jacobian = jacobian,
                            .slip_estimate = jacobian == std::string("reduced") ? "jacobi" : "auto",
                            .linear_solver = solver});
  for (const Mesh& mesh : meshes) {
    // These are slow there, and show nothing new.
    if (mesh.core > paper_mesh.core)
      std::erase_if(procedures, [](const Procedure& p) { return p.jacobian == "simplified"; });
    solve_all(runner, "procedures_density", mesh, "godunov", procedures, runner.quick ? 1 : 2);
  }
}

}  // namespace

std::vector<Case> procedure_example3_cases() {
  return {{"procedures_example3", "sphere on a plane: every solution procedure, figure 16(a)", one_mesh},
          {"procedures_density", "the same over the density of the mesh, figure 16(b)", densities}};
}

}  // namespace rollcon::bench
