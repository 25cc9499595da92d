// The ring of the paper's first example under loads on a patch of its outer surface, against
// Fourier series with high-order elements in the section (relative accuracy 1e-5).

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "support/static_solution.hpp"
#include "support/surface_meshes.hpp"
#include "validation/report.hpp"

namespace rollcon {
namespace {

using statics::StaticBody;
using validation::expect_error;
using validation::relative;

constexpr double pi = std::numbers::pi, young = 1e4, inner = 25, outer = 50, side = 4, load = 100;
constexpr double none = 0;  ///< not listed, or zero by symmetry

enum class Load { normal, tangential };

/// At (s, y) = (0,0), (1,0), (2,0), (0,2), (0,3.9), (0,4), and the mean over the patch |s| <= 1.
struct Row {
  Load load;
  double poisson;
  char component;  ///< n inwards, s, y
  std::array<double, 7> value;
};
constexpr Row rows[] = {
    {Load::normal,
     0.3,
     'n',
     {.0474826, .0394575, .0283727, .0480571, .0517939, .0522833, .0462414}},
    {Load::normal, 0.3, 's', {none, -.0049983, -.0048333, none, none, none, none}},
    {Load::normal, 0.3, 'y', {none, none, none, .0045073, .0124102, .0129436, none}},
    {Load::tangential,
     0.3,
     's',
     {.0754808, .0673031, .0558447, .0755530, .0733572, .0726928, .0729445}},
    {Load::tangential, 0.3, 'n', {none, .0045039, .0040242, none, none, none, none}},
    {Load::normal, 0.49, 'n', {.0440806, .0372047, .0275117, .0453897, none, .0541693, .0443127}}};
constexpr const char* point_names[] = {"(0,0)",   "(1,0)", "(2,0)", "(0,2)",
                                       "(0,3.9)", "(0,4)", "mean"};
constexpr std::pair<double, double> points[] = {{0, 0}, {1, 0}, {2, 0}, {0, 2}, {0, 3.9}, {0, 4}};

Vec3 outward(const Vec3& x) {
  const double r = std::hypot(x[0], x[2]);
  return {x[0] / r, 0, x[2] / r};
}
Vec3 around(const Vec3& x) {
  const Vec3 n = outward(x);
  return {n[2], 0, -n[0]};
}

bool on_patch(const SurfaceMesh& mesh, std::int64_t e) {
  for (const std::int32_t k : mesh.element(e)) {
    const Vec3& x = mesh.node[static_cast<std::size_t>(k)];
    if (std::abs(std::hypot(x[0], x[2]) - outer) > 1e-9 || x[2] < 0 ||
        std::abs(outer * std::atan2(x[0], x[2])) > 1 + 1e-9)
      return false;
  }
  return true;
}

std::vector<std::int64_t> patch_of(const SurfaceMesh& mesh) {
  std::vector<std::int64_t> patch;
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    if (on_patch(mesh, e)) patch.push_back(e);
  return patch;
}

/// Displacements of the outer surface near the patch, and their mean over the patch.
struct Answer {
  std::vector<std::int32_t> node;
  std::vector<Vec3> u;
  const SurfaceMesh* mesh = nullptr;
  Vec3 mean{0, 0, 0};  ///< local components s, y, n (inwards)

  Vec3 local(std::size_t k) const {
    const Vec3& x = mesh->node[static_cast<std::size_t>(node[k])];
    return {dot(u[k], around(x)), u[k][1], -dot(u[k], outward(x))};
  }
  /// Between nodes of the line s = 0: the polynomial of its last element.
  Vec3 at(double s, double y) const {
    std::map<double, std::size_t> line;
    for (std::size_t k = 0; k < node.size(); ++k) {
      const Vec3& x = mesh->node[static_cast<std::size_t>(node[k])];
      if (std::abs(outer * std::atan2(x[0], x[2]) - s) > 1e-9) continue;
      if (std::abs(x[1] - y) < 1e-9) return local(k);
      line[x[1]] = k;
    }
    std::vector<std::pair<double, std::size_t>> last(line.rbegin(), line.rend());
    last.resize(is_quadratic(mesh->type.front()) ? 3 : 2);
    Vec3 sum{0, 0, 0};
    for (const auto& [yi, k] : last) {
      double weight = 1;
      for (const auto& [yj, unused] : last)
        if (yj != yi) weight *= (y - yj) / (yi - yj);
      sum = sum + weight * local(k);
    }
    return sum;
  }
};

/// How the whole ring is made of what is meshed.
enum class Part { whole, quarter };

SurfaceMesh ring_mesh(Part part, ElementType type, int zone, int far, int across, int deep) {
  if (part == Part::whole)
    return surfaces::ring({.zone = 4,
                           .around = 2 * (zone + far),
                           .zone_around = 2 * zone,
                           .across = 2 * across,
                           .deep = deep,
                           .largest = 0,
                           .top_layer = 2.0 / zone,
                           .side_grading = 1},
                          type);
  // Half of the circumference and half of the width, between planes of (anti)symmetry.
  surfaces::Block b;
  for (int k = 0; k <= zone; ++k) b.line[0].push_back(2.0 / outer * k / zone);
  const auto rest = surfaces::graded(far, 2.0 / outer, pi, 2.0 / outer / zone);
  b.line[0].insert(b.line[0].end(), rest.begin() + 1, rest.end());
  for (int k = 0; k <= across; ++k) b.line[1].push_back(side * std::sin(pi / 2 * k / across));
  b.line[2] = surfaces::graded_to(deep, inner, outer, 2.0 / zone);
  b.map = [](const Vec3& q) { return Vec3{q[2] * std::sin(q[0]), q[1], q[2] * std::cos(q[0])}; };
  b.tag = {1, 2, 3, 4, 5, 6};
  return surfaces::block(b, type);
}

/// The factorised ring for one kind of load (the quarter's supports depend on it).
std::unique_ptr<StaticBody> held_ring(Part part, SurfaceMesh mesh, Load kind, double poisson) {
  auto body = std::make_unique<StaticBody>(std::move(mesh), young, poisson);
  if (part == Part::whole) {
    body->hold_tags({3});
  } else {
    body->hold_tags({5}).hold_tags({1, 2}, kind == Load::normal ? 1 : 6).hold_tags({3}, 2);
  }
  body->solve();
  return body;
}

Answer loaded(StaticBody& body, Load kind) {
  const SurfaceMesh& mesh = body.mesh();
  Answer a;
  a.mesh = &mesh;
  a.node = surfaces::nodes_where(mesh, [](const Vec3& x) {
    return x[2] > 0 && std::abs(std::hypot(x[0], x[2]) - outer) < 1e-9 &&
           std::abs(outer * std::atan2(x[0], x[2])) < 2 + 1e-9;
  });
  std::vector<std::int32_t> patch_node;
  const SurfaceMesh patch = surfaces::part_of(mesh, patch_of(mesh), patch_node);
  const auto rows_of_layer = body.body().response()->layer(patch, a.node, 1);
  std::vector<double> t;
  for (const Vec3& x : patch.node) {
    const Vec3 value = load * (kind == Load::normal ? -1.0 * outward(x) : around(x));
    t.insert(t.end(), value.begin(), value.end());
  }
  std::vector<double> u(3 * a.node.size());
  multiply(rows_of_layer->u.data(), rows_of_layer->u.rows(), rows_of_layer->u.columns(), t.data(),
           0, u.data());
  for (std::size_t k = 0; k < a.node.size(); ++k)
    a.u.push_back({u[3 * k], u[3 * k + 1], u[3 * k + 2]});
  // Mean over the patch: by the shape functions of its elements, all of whose nodes are known.
  std::map<std::int32_t, std::size_t> place;
  for (std::size_t k = 0; k < a.node.size(); ++k) place[a.node[k]] = k;
  double area = 0;
  const auto weights = surfaces::nodal_areas(patch);
  for (std::size_t k = 0; k < patch_node.size(); ++k) {
    a.mean = a.mean + weights[k] * a.local(place.at(patch_node[k]));
    area += weights[k];
  }
  a.mean = (1 / area) * a.mean;
  return a;
}

double component(const Vec3& local, char name) {
  return local[name == 's' ? 0 : name == 'y' ? 1 : 2];
}

/// Every listed value; errors against the largest displacement of the row's load for the small
/// components, against the value itself for the component of the load.
void expect_rows(Part part, ElementType type, const SurfaceMesh& mesh, Load kind, double poisson,
                 double bound) {
  const auto body = held_ring(part, mesh, kind, poisson);
  const Answer a = loaded(*body, kind);
  for (const Row& row : rows) {
    if (row.load != kind || row.poisson != poisson) continue;
    for (std::size_t p = 0; p < 7; ++p) {
      if (row.value[p] == none) continue;
      const double value =
          component(p < 6 ? a.at(points[p].first, points[p].second) : a.mean, row.component);
      const bool main = row.component == (kind == Load::normal ? 'n' : 's');
      const double scale = main ? row.value[p] : kind == Load::normal ? .0474826 : .0754808;
      expect_error(surfaces::name_of(type) + (part == Part::whole ? " ring, " : " quarter ring, ") +
                       std::to_string(mesh.nodes()) + " nodes, " +
                       (kind == Load::normal ? "normal" : "tangential") + " load, nu " +
                       std::to_string(poisson).substr(0, 4) + ": u_" + row.component + " at " +
                       point_names[p],
                   (value - row.value[p]) / scale, bound);
    }
  }
}

struct Case {
  Part part;
  ElementType type;
  int zone, far, across, deep;  ///< elements: half of the zone |s| <= 2, half of the rest, ...
  double bound;
};

class PatchLoad : public ::testing::TestWithParam<Case> {};

TEST_P(PatchLoad, moves_the_ring_as_listed) {
  const Case c = GetParam();
  const SurfaceMesh mesh = ring_mesh(c.part, c.type, c.zone, c.far, c.across, c.deep);
  expect_rows(c.part, c.type, mesh, Load::normal, 0.3, c.bound);
  expect_rows(c.part, c.type, mesh, Load::tangential, 0.3, c.bound);
  expect_rows(c.part, c.type, mesh, Load::normal, 0.49, c.bound);
}

// Bounds: 2 % (linear) and 0.5 % (quadratic) as asked of meshes that fit 4000 nodes; coarser ones
// as measured. Wholes of 2816 nodes (quad4) and 3456 (quad8), too long for here: 0.7 % and 0.4 %.
INSTANTIATE_TEST_SUITE_P(
    Ring, PatchLoad,
    ::testing::Values(Case{Part::whole, ElementType::quad4, 4, 16, 3, 8, 0.018},
                      Case{Part::whole, ElementType::quad8, 2, 8, 3, 5, 0.0085},
                      Case{Part::quarter, ElementType::tri3, 6, 20, 3, 12, 0.02},
                      Case{Part::quarter, ElementType::quad4, 6, 20, 3, 12, 0.02},
                      Case{Part::quarter, ElementType::tri6, 2, 8, 3, 6, 0.0075},
                      Case{Part::quarter, ElementType::quad8, 4, 10, 3, 8, 0.005},
                      Case{Part::quarter, ElementType::quad9, 2, 8, 3, 6, 0.0075}),
    [](const auto& param) {
      return surfaces::name_of(param.param.type) +
             (param.param.part == Part::whole ? "_whole" : "_quarter");
    });

// Three ways to the same load: nodal tractions on the body's faces, on a mesh of its own laid on
// them, and the body's own load by tag.
TEST(RingLoads, by_faces_by_a_layer_and_by_tag_agree) {
  for (const ElementType type : surfaces::all_types) {
    SurfaceMesh mesh = ring_mesh(Part::quarter, type, 2, 6, 3, 3);
    const auto patch = patch_of(mesh);
    for (const std::int64_t e : patch) mesh.tag[static_cast<std::size_t>(e)] = 9;
    StaticBody body(mesh, young, 0.3);
    const Vec3 t{30, 10, -80};
    body.hold_tags({5}).traction(9, t).solve();
    const statics::Loaded faces =
        statics::load_faces(body.body(), patch, [&](const Vec3&) { return t; });
    std::vector<std::int32_t> node;
    const SurfaceMesh part = surfaces::part_of(mesh, patch, node);
    const auto layer = body.body().response()->layer(part, faces.node, 1);
    std::vector<double> loads, u(3 * faces.node.size());
    for (std::size_t k = 0; k < part.node.size(); ++k)
      loads.insert(loads.end(), t.begin(), t.end());
    multiply(layer->u.data(), layer->u.rows(), layer->u.columns(), loads.data(), 0, u.data());
    double by_layer = 0, by_tag = 0, size = 0;
    for (std::size_t k = 0; k < faces.node.size(); ++k) {
      size = std::max(size, length(faces.u[k]));
      by_layer =
          std::max(by_layer, length(faces.u[k] - Vec3{u[3 * k], u[3 * k + 1], u[3 * k + 2]}));
      by_tag = std::max(by_tag, length(faces.u[k] - body.displacement(faces.node[k])));
    }
    expect_error(surfaces::name_of(type) + " ring, layer against faces", by_layer / size, 1e-6);
    expect_error(surfaces::name_of(type) + " ring, tag against faces", by_tag / size, 1e-6);
  }
}

TEST(RingMaterials, displacements_are_smooth_up_to_incompressible) {
  const SurfaceMesh mesh = ring_mesh(Part::quarter, ElementType::quad8, 4, 6, 3, 3);
  const auto middle = [&](double poisson) {
    const auto body = held_ring(Part::quarter, mesh, Load::normal, poisson);
    return loaded(*body, Load::normal).at(0, 0)[2];
  };
  const double u49 = middle(0.49), u499 = middle(0.499), u5 = middle(0.5);
  // A straight line through 0.49 and 0.499 misses 0.5 by the curvature only.
  expect_error("u_n at nu = 0.5 against extrapolation", relative(u5, u499 + (u499 - u49) / 9),
               1e-3);
  expect_error("nu = 0.5 against 0.499", relative(u5, u499), 0.02);
}

}  // namespace
}  // namespace rollcon
