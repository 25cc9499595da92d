// Compares the strongly singular block with its free term, from rigid-body motion in the library, with Guiggiani's
// direct evaluation plus the known free term: 1/2 at smooth points, flat and curved; at a cube's edges and corners c_ij
// = integral over the directions into the body of ((1-2nu) d_ij + 3 e_i e_j)/(8 pi (1-nu)).

#include "bodies/bem/integrals/assembled_rows.hpp"
#include "bodies/bem/integrals/guiggiani.hpp"
#include "mesh/shape.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using element_reference::Integrals;
using element_reference::Reference;

constexpr double poisson = 0.3, tolerance = 1e-9;

SurfaceMesh extract(const SurfaceMesh& mesh, std::int64_t e) {
  SurfaceMesh one;
  one.type = {mesh.type[static_cast<std::size_t>(e)]};
  one.tag = {0};
  one.offset = {0};
  for (const std::int32_t node : mesh.element(e)) {
    one.connectivity.push_back(static_cast<std::int32_t>(one.node.size()));
    one.node.push_back(mesh.node[static_cast<std::size_t>(node)]);
  }
  one.offset.push_back(static_cast<std::int64_t>(one.node.size()));
  return one;
}

/// Returns the blocks of all nodes for the point, without the free term: elements with `at` directly, the others by
/// brute force. on[e] says where the point lies on element e, or is empty.
std::vector<std::array<double, 9>> direct_row(const SurfaceMesh& mesh, const Vec3& x,
                                              const std::function<const Reference*(std::int64_t)>& on) {
  std::vector<std::array<double, 9>> row(mesh.node.size(), std::array<double, 9>{});
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const SurfaceMesh one = extract(mesh, e);
    const Reference* at = on(e);
    const Integrals part =
        at ? guiggiani::finite_part(one, *at, poisson) : element_reference::integrate(one, x, poisson);
    const auto nodes = mesh.element(e);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t i = 0; i < 9; ++i) row[static_cast<std::size_t>(nodes[k])][i] += part.t[i][k];
  }
  return row;
}

/// Returns the largest difference of the library's row from the direct one, free term c[3 * c + i] times share[node]
/// included.
double compare(const SurfaceMesh& mesh, const bem::CollocationPoint& point, std::vector<std::array<double, 9>> direct,
               const std::array<double, 9>& c, const std::vector<double>& share) {
  const bem::BoundaryIntegrals integrals(mesh, poisson, tolerance);
  const auto h = assembled_rows::assemble(integrals, mesh, {&point, 1}, true, false).h;
  double worst = 0;
  for (std::size_t j = 0; j < mesh.node.size(); ++j)
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(3 * k + i);
        const double d = std::abs(h(0, i, j, k) - direct[j][at] - c[at] * share[j]);
        worst = d <= worst ? worst : d;
      }
  return worst;
}

constexpr std::array<double, 9> half{0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5};

class StrongSingularity : public ::testing::TestWithParam<ElementType> {};

TEST_P(StrongSingularity, inside_an_element) {
  const Reference at = corner_count(GetParam()) == 3 ? Reference{0.3, 0.25} : Reference{0.35, -0.2};
  for (const bool curved : {false, true}) {
    const SurfaceMesh mesh = curved ? surfaces::cube_sphere(GetParam(), 2, 1)
                                    : surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), GetParam());
    const std::int32_t element = 3;
    bem::CollocationPoint point{{}, -1, element, at.xi, at.eta};
    point.x = element_reference::position(extract(mesh, element), at);
    std::vector<double> share(mesh.node.size(), 0.0);
    Shape s;
    evaluate_shape(GetParam(), at.xi, at.eta, s);
    const auto nodes = mesh.element(element);
    for (std::size_t k = 0; k < nodes.size(); ++k) share[static_cast<std::size_t>(nodes[k])] = s.value[k];
    const double error =
        compare(mesh, point, direct_row(mesh, point.x, [&](std::int64_t e) { return e == element ? &at : nullptr; }),
                half, share);
    std::printf("%s, %s: error %.1e (bound %.0e)\n", surfaces::name_of(GetParam()).c_str(), curved ? "curved" : "flat",
                error, tolerance);
    EXPECT_LE(error, tolerance);
  }
}

/// Returns the free term of a cube's node; the body lies to the side `into[axis]` (0: both sides).
std::array<double, 9> free_term(const std::array<int, 3>& into) {
  constexpr double pi = std::numbers::pi;
  int planes = 0;
  for (const int side : into) planes += side != 0;
  const double solid_angle = 4 * pi / (1 << planes);
  std::array<double, 9> c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // The integrals are those of e_i e_j over a half (0 off the diagonal), quarter (2/3) or eighth (1/3).
      const double mixed = into[i] * into[j] * (planes == 2 ? 2.0 / 3 : 1.0 / 3);
      c[3 * i + j] = i == j ? solid_angle / (4 * pi) : 3 * mixed / (8 * pi * (1 - poisson));
    }
  return c;
}

TEST_P(StrongSingularity, nodes_of_a_cube) {
  const SurfaceMesh mesh = surfaces::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), GetParam());
  const struct {
    const char* what;
    Vec3 x;
    std::array<int, 3> into;
  } cases[] = {
      {"face", {0.5, 0.5, 1}, {0, 0, -1}}, {"edge", {1, 0.5, 0}, {-1, 0, 1}}, {"corner", {1, 0, 1}, {-1, 1, -1}}};
  for (const auto& point : cases) {
    const std::int32_t node = surfaces::node_at(mesh, point.x);
    std::vector<double> share(mesh.node.size(), 0.0);
    share[static_cast<std::size_t>(node)] = 1;
    Reference at{};
    auto on = [&](std::int64_t e) -> const Reference* {
      const auto nodes = mesh.element(e);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (nodes[k] == node) {
          const ReferencePoint r = reference_nodes(GetParam())[k];
          at = {r.xi, r.eta};
          return &at;
        }
      return nullptr;
    };
    const double error =
        compare(mesh, {point.x, node, -1, 0, 0}, direct_row(mesh, point.x, on), free_term(point.into), share);
    std::printf("%s, cube's %s: error %.1e (bound %.0e)\n", surfaces::name_of(GetParam()).c_str(), point.what, error,
                tolerance);
    EXPECT_LE(error, tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(types, StrongSingularity, ::testing::ValuesIn(surfaces::all_types),
                         [](const auto& info) { return surfaces::name_of(info.param); });

}  // namespace
}  // namespace rollcon
