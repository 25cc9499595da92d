// Measures boundary elements: point evaluations of Kelvin's T and U with all shape functions per second, of the far
// kernel alone for each instruction set, and of a body's whole assembly.

#include <algorithm>
#include <string>
#include <vector>

#include "bench.hpp"
#include "bodies/bem/kelvin.hpp"
#include "bodies/bem/near_field.hpp"
#include "bodies/bem/rule_tables.hpp"
#include "support/example1.hpp"

namespace rollcon::bench {
namespace {

namespace example1 = scenes::example1;
using rollcon::InstructionSet;

constexpr double wanted = 1e8;

Record record_of(const Runner& runner, std::string method, std::string model, ElementType type) {
  Record record{.case_name = "bem_kernel", .method = std::move(method), .model = std::move(model)};
  record.element = surfaces::name_of(type);
  record.threads = runner.threads;
  record.quantity = "point evaluations per second (error: over 1e8 per thread, less 1)";
  record.against = "1e8 per second and core";
  return record;
}

/// Takes eight points far from the elements of a sphere: 2 x 2 points on linear quadrilaterals, 3 x 3 on quadratic
/// ones, a rule of degree 4 on triangles.
double far_rate(ElementType type, InstructionSet set, double least_seconds) {
  const SurfaceMesh mesh = surfaces::cube_sphere(type, 4, 1);
  std::vector<bem::ElementGeometry> elements;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) elements.push_back(bem::element_geometry(mesh, e, 1));
  const bem::Kernels& kernels = bem::kelvin_kernels(set);
  const bem::KelvinConstants constants(0.3);
  const int n = corner_count(type) == 3 ? 4 : is_quadratic(type) ? 3 : 2;
  const bem::RuleTable& table = bem::rule_table(type, n, n);
  bem::PointPack pack;
  for (int p = 0; p < bem::pack_points; ++p) {
    pack.x[0][p] = 5 + 0.1 * p;
    pack.x[1][p] = 0.2;
    pack.x[2][p] = 0.3;
    pack.mask[p] = 1;
  }
  constexpr std::size_t block = 9 * bem::pack_points;
  std::vector<double> h(block * mesh.node.size()), g(h.size());
  bem::FarPoints points;
  const auto sweep = [&] {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      double *hp[max_element_nodes], *gp[max_element_nodes];
      const auto nodes = mesh.element(static_cast<std::int64_t>(e));
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        hp[k] = h.data() + block * static_cast<std::size_t>(nodes[k]);
        gp[k] = g.data() + block * static_cast<std::size_t>(nodes[k]);
      }
      kernels.place(table, elements[e].nodes, elements[e].node, points);
      kernels.far(points, table, elements[e].nodes, pack, constants, bem::both_layers, hp, gp);
    }
    return static_cast<double>(mesh.elements() * table.n * bem::pack_points);
  };
  // The best of ten runs counts, because others use the machine as well.
  double best = 0;
  for (int k = 0; k < 10; ++k) {
    double evaluations = 0;
    const double began = now();
    while (now() - began < least_seconds / 10) evaluations += sweep();
    best = std::max(best, evaluations / (now() - began));
  }
  return best;
}

void far_kernels(Runner& runner) {
  const std::pair<const char*, InstructionSet> sets[] = {
      {"baseline", InstructionSet::baseline}, {"avx2", InstructionSet::avx2}, {"avx512", InstructionSet::avx512}};
  for (const ElementType type :
       {ElementType::tri3, ElementType::quad4, ElementType::tri6, ElementType::quad8, ElementType::quad9})
    for (const auto& [name, set] : sets) {
      if (set > rollcon::best_instruction_set()) continue;
      Record record = record_of(runner, name, "far kernel, T and U", type);
      record.threads = 1;
      record.mesh = surfaces::name_of(type) + ", sphere seen from afar";
      record.seconds = runner.quick ? 0.05 : 1;
      record.value = far_rate(type, set, record.seconds);
      record.error = record.value / wanted - 1;
      runner.emit(record);
    }
}

/// Assembles with the near field, the choice of rules, and the matrix.
void assemblies(Runner& runner) {
  for (const ElementType type : {ElementType::quad4, ElementType::quad8}) {
    Record record = record_of(runner, "assembly", "ring of example 1, T and U of the hub", type);
    const double began = now();
    auto pair = example1::pair(example1::bem_ring(is_quadratic(type) ? 6 : 12), type, "characteristic", runner.threads);
    timed_solve(*pair, record, began);
    const double evaluations = pair->body_stat(1, "kernel_evaluations");
    const double seconds = pair->body_stat(1, "seconds_assembly");
    record.mesh =
        surfaces::name_of(type) + ", " + std::to_string(std::lround(pair->body_stat(1, "unknowns") / 3)) + " nodes";
    record.value = evaluations / seconds;
    record.error = record.value / (wanted * runner.threads) - 1;
    record.extra = {{"kernel_evaluations", evaluations}, {"seconds_assembly", seconds}};
    runner.emit(record);
  }
}

void run(Runner& runner) {
  far_kernels(runner);
  assemblies(runner);
}

}  // namespace

std::vector<Case> bem_kernel_cases() {
  return {{"bem_kernel", "boundary-element point evaluations per second", run}};
}

}  // namespace rollcon::bench
