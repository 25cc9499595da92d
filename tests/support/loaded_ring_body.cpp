#include "support/loaded_ring_body.hpp"

#include "linalg/dense.hpp"

namespace rollcon::statics::loaded_ring {

void hold_quarter(StaticBody& body, Load kind) {
  constexpr std::int32_t x = 1, y = 2, z = 4;
  body.hold_tags({5}).hold_tags({1, 2}, kind == Load::tangential ? y | z : x);
  body.hold_tags({3}, kind == Load::axial ? x | z : y).solve();
}

Answer loaded(StaticBody& body, Load kind) {
  const SurfaceMesh& mesh = body.mesh();
  std::vector<std::int32_t> patch_node;
  const SurfaceMesh patch = surfaces::part_of(mesh, patch_of(mesh), patch_node);
  Answer a;
  a.mesh = &mesh;
  a.node = nodes_near_patch(mesh);
  const auto rows_of_layer = body.body().response()->rows({{}, patch, a.node}, 1);
  std::vector<double> t;
  for (const Vec3& x : patch.node) {
    const Vec3 value = traction(kind, x);
    t.insert(t.end(), value.begin(), value.end());
  }
  std::vector<double> u(3 * a.node.size());
  multiply(rows_of_layer->u.data(), rows_of_layer->u.rows(), rows_of_layer->u.columns(), t.data(), 0, u.data());
  for (std::size_t k = 0; k < a.node.size(); ++k) a.u.push_back({u[3 * k], u[3 * k + 1], u[3 * k + 2]});
  a.find_mean();
  return a;
}

std::vector<ListedError> listed_errors(StaticBody& body, Load kind, double poisson) {
  return listed_errors(loaded(body, kind), kind, poisson);
}

}  // namespace rollcon::statics::loaded_ring
