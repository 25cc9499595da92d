/// Tests every way in which a body's surface can be wrong, with the words that the caller reads; and good surfaces,
/// however slender, small or large.

#include "mesh/surface_check.hpp"

#include "mesh/refusals.hpp"
#include "mesh/shape.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using surfaces::add_element;
using surfaces::all_types;
using surfaces::one_element;

void expect_refused(const SurfaceMesh& mesh, const std::string& words, SurfaceKind kind = SurfaceKind::closed) {
  expect_error_text([&] { check_surface(mesh, kind); }, words);
}

void expect_accepted(const SurfaceMesh& mesh, const std::string& what, SurfaceKind kind = SurfaceKind::closed) {
  expect_no_error([&] { check_surface(mesh, kind); }, what);
}

/// Reverses an element on unchanged nodes, corners and midsides, to the other sense round.
void reverse(SurfaceMesh& mesh, std::size_t e) {
  const auto corners = corner_count(mesh.type[e]);
  auto at = mesh.connectivity.begin() + mesh.offset[e];
  std::reverse(at + 1, at + corners);
  if (is_quadratic(mesh.type[e])) std::reverse(at + corners, at + 2 * corners);
}

void drop(SurfaceMesh& mesh, std::int64_t e) {
  mesh = surfaces::only(mesh, [e](std::int64_t i) { return i != e; });
}

SurfaceMesh join(SurfaceMesh a, const SurfaceMesh& b, const Vec3& shift = {0, 0, 0}) {
  const auto n = static_cast<std::int32_t>(a.nodes());
  for (const Vec3& x : b.node) a.node.push_back(x + shift);
  for (std::int64_t e = 0; e < b.elements(); ++e) {
    std::vector<std::int32_t> nodes(b.element(e).begin(), b.element(e).end());
    for (std::int32_t& k : nodes) k += n;
    add_element(a, b.type[static_cast<std::size_t>(e)], nodes);
  }
  return a;
}

SurfaceMesh tetrahedron() {
  SurfaceMesh mesh;
  mesh.node = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const std::array<std::int32_t, 3>& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
    add_element(mesh, ElementType::tri3, face);
  return mesh;
}

SurfaceMesh moved(const SurfaceMesh& mesh, const Vec3& by, double unit = 1) {
  return surfaces::transform(mesh, [&](const Vec3& x) { return unit * (x + by); });
}

SurfaceMesh cube(ElementType type, int n = 2, double size = 1) {
  return surfaces::block(surfaces::brick({n, n, n}, {size, size, size}), type);
}

TEST(SurfaceCheck, SoundBodiesPass) {
  expect_accepted(tetrahedron(), "tetrahedron");
  for (ElementType type : all_types) {
    const std::string name = std::to_string(static_cast<int>(type));
    expect_accepted(cube(type, 1), "cube " + name);
    expect_accepted(surfaces::cube_sphere(type, 2, 1), "sphere " + name);
    expect_accepted(surfaces::distort(cube(type, 4), 0.3, 11), "distorted cube " + name);
    expect_accepted(surfaces::ring({}, type), "ring " + name);
    expect_accepted(surfaces::wheel(300, type), "wheel " + name);
  }
  for (ElementType type : {ElementType::tri3, ElementType::tri6})
    expect_accepted(surfaces::icosphere(type, 3, 1), "icosphere");
  for (bool quadratic : {false, true})
    expect_accepted(surfaces::mixed_block(surfaces::brick({3, 4, 5}, {1, 1, 1}), quadratic), "mixed");
}

TEST(SurfaceCheck, CavitiesLookInwards) {
  for (ElementType type : all_types) {
    const SurfaceMesh one = surfaces::with_cavity(cube(type, 3, 4), moved(cube(type), {1, 1, 1}));
    expect_accepted(one, "cavity");
    expect_accepted(surfaces::with_cavity(one, moved(cube(type, 1, 0.5), {3, 3, 3})), "two cavities side by side");
    // The wall is thin: a sphere in a sphere, closer than the sagitta of the elements' facets.
    if (is_quadratic(type))
      expect_accepted(surfaces::with_cavity(surfaces::cube_sphere(type, 3, 1), surfaces::cube_sphere(type, 3, 0.99)),
                      "thin wall");
  }
}

TEST(SurfaceCheck, SlenderSmallAndLargeBodiesPass) {
  for (ElementType type : all_types)
    for (double unit : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
      for (const Vec3& size : {Vec3{1, 1, 1}, Vec3{1e4, 1, 1}, Vec3{1, 1e4, 1e4}, Vec3{1, 1e2, 1e4}})
        expect_accepted(surfaces::block(surfaces::brick({2, 2, 2}, unit * size), type), "slender brick");
      // The brick is sheared: slender in no direction of the axes.
      const auto sheared = [unit](const Vec3& x) { return unit * Vec3{x[0] + 1e4 * x[1], x[1], x[2]}; };
      expect_accepted(surfaces::transform(cube(type), sheared), "sheared cube");
      // The rounding of coordinates far from the origin is 1e-10 of the size.
      expect_accepted(moved(surfaces::cube_sphere(type, 3, 1), {1e6, -1e6, 1e6}, unit), "far away");
    }
}

TEST(SurfaceCheck, OpenSurfacesPassWhenTheyAreNotBodies) {
  SurfaceMesh mesh = cube(ElementType::quad8, 2);
  drop(mesh, 5);
  expect_accepted(mesh, "open", SurfaceKind::open);
  mesh.index_base = 1;
  expect_refused(
      mesh,
      "open edge: only one element has it, but a body's surface must be closed; 4 such in the surface; first: edge ");
  expect_refused(mesh, "edge 24-25 of element 5 (quad8)");
}

TEST(SurfaceCheck, ConnectivityIsCheckedFirst) {
  SurfaceMesh mesh;
  mesh.offset = {0};
  expect_refused(mesh, "no elements");
  mesh = tetrahedron();
  mesh.index_base = 1;
  mesh.connectivity[4] = 9;
  expect_refused(mesh, "does not exist; 1 such in the surface; first: element 2 (tri3), node 10 of 1..4");
  mesh = tetrahedron();
  mesh.connectivity[4] = 0;
  expect_refused(mesh, "a node is repeated within an element; 1 such in the surface; first: element 1 (tri3), node 0");
  mesh = tetrahedron();
  add_element(mesh, ElementType::tri3, {3, 1, 0});
  expect_refused(mesh, "the same element is given twice; 1 such in the surface; first: elements 1 and 4");
}

TEST(SurfaceCheck, NodesOfNoElement) {
  SurfaceMesh mesh = tetrahedron();
  mesh.index_base = 1;
  mesh.node.insert(mesh.node.begin() + 4, {{3, 3, 3}, {4, 4, 4}});
  expect_refused(mesh, "a node belongs to no element; 2 such in the surface; first: node 5");
}

TEST(SurfaceCheck, TwoNodesAtOnePlace) {
  for (double unit : {1e-9, 1.0, 1e9}) {
    // The six faces are meshed one by one, not merged: 8 corners with three nodes each.
    const SurfaceMesh whole = moved(cube(ElementType::quad4, 1), {0, 0, 0}, unit);
    SurfaceMesh mesh;
    for (std::int64_t e = 0; e < whole.elements(); ++e) {
      const auto n = static_cast<std::int32_t>(mesh.node.size());
      for (std::int32_t k : whole.element(e)) mesh.node.push_back(whole.node[static_cast<std::size_t>(k)]);
      add_element(mesh, ElementType::quad4, {n, n + 1, n + 2, n + 3});
    }
    expect_refused(
        mesh,
        "two nodes lie at the same place: give the elements one node there; 24 such in the surface; first: nodes ");
    // The nodes are as far apart as the digits of a text file leave them.
    for (std::size_t k = 0; k < mesh.node.size(); ++k) mesh.node[k][k % 3] *= 1 + 3e-7;
    expect_refused(mesh, "two nodes lie at the same place");
  }
  // A thin plate's faces are not one.
  expect_accepted(surfaces::block(surfaces::brick({4, 4, 1}, {1, 1, 1e-4}), ElementType::quad4), "thin plate");
}

TEST(SurfaceCheck, ManyNodesInOnePlaneTakeNoTime) {
  // The mesh has 60,000 nodes, a sixth of them with equal x: comparing all of those would take minutes.
  expect_accepted(cube(ElementType::quad4, 100), "fine cube");
}

TEST(SurfaceCheck, ElementsWithoutArea) {
  const auto open = SurfaceKind::open;
  expect_refused(one_element(ElementType::tri3, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
                 "degenerate element: its Jacobian vanishes (no area, a corner of 180 degrees, or a midside node at a "
                 "quarter of its edge); 1 such in the surface; first: element 0 (tri3)",
                 open);
  expect_refused(
      one_element(ElementType::tri3, {{0, 0, 0}, {1, 0, 0}, {1, 1e-15, 0}}),
      "degenerate element: two of its nodes coincide; 1 such in the surface; first: element 0 (tri3), nodes 1 and 2",
      open);
  // A corner of 180 degrees makes a linear element degenerate, and so does a quadratic element made of a disc's four
  // arcs.
  expect_refused(one_element(ElementType::quad4, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}),
                 "element 0 (quad4) at node 1", open);
  const double c = std::numbers::sqrt2 / 2;
  const std::vector<Vec3> disc = {{-c, -c, 0}, {c, -c, 0}, {c, c, 0},  {-c, c, 0}, {0, -1, 0},
                                  {1, 0, 0},   {0, 1, 0},  {-1, 0, 0}, {0, 0, 0}};
  expect_refused(one_element(ElementType::quad4, {{0, 0, 0}, {1, -1e-9, 0}, {2, 0, 0}, {1, 1, 0}}),
                 "its Jacobian vanishes", open);
  expect_accepted(one_element(ElementType::quad9, disc), "a disc: corners of 169 degrees", open);
}

TEST(SurfaceCheck, MidsideNodesStayWithinTheMiddleHalfOfTheirEdge) {
  const auto open = SurfaceKind::open;
  for (double at : {0.0, 0.2, 0.25, 0.26, 0.5, 0.74, 0.75, 0.8}) {
    const std::vector<Vec3> six = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {at, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}};
    const std::vector<Vec3> eight = {{0, 0, 0},  {1, 0, 0},   {1, 1, 0},   {0, 1, 0},
                                     {at, 0, 0}, {1, 0.5, 0}, {0.5, 1, 0}, {0, 0.5, 0}};
    const std::string node = at < 0.5 ? "at node 0" : "at node 1";
    for (const auto& [type, points] : {std::pair{ElementType::tri6, six}, std::pair{ElementType::quad8, eight}}) {
      for (double narrow : {1.0, 1e-4}) {
        std::vector<Vec3> nodes = points;
        for (Vec3& x : nodes) x = {x[0], 0.6 * narrow * x[1], 0.8 * narrow * x[1]};
        const SurfaceMesh mesh = one_element(type, nodes);
        if (at == 0)
          expect_refused(mesh, "two of its nodes coincide", open);
        else if (at == 0.25 || at == 0.75)
          expect_refused(mesh, "its Jacobian vanishes", open);
        else if (at < 0.25 || at > 0.75)
          expect_refused(mesh, "its normal turns over within it", open);
        else
          expect_accepted(mesh, "midside node at " + std::to_string(at), open);
        if (at != 0 && (at <= 0.25 || at >= 0.75)) expect_refused(mesh, node, open);
      }
    }
  }
}

TEST(SurfaceCheck, FoldedElements) {
  const auto open = SurfaceKind::open;
  expect_refused(one_element(ElementType::quad4, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
                 "degenerate element: its normal turns over within it (folded, concave, or ", open);
  expect_refused(one_element(ElementType::quad4, {{0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}}),
                 "first: element 0 (quad4) at node 2", open);
  // A warped element has none of these faults.
  expect_accepted(one_element(ElementType::quad4, {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0}, {0, 1, 0.5}}), "warped", open);
  // One quadratic element half round a cylinder is coarse, but sound.
  const auto half_round = [](const Vec3& r) {
    const double angle = 0.5 * std::numbers::pi * r[0];
    return Vec3{std::sin(angle), r[1], std::cos(angle)};
  };
  expect_accepted(one_element(ElementType::quad8, half_round), "half a cylinder", open);
}

TEST(SurfaceCheck, MoreThanTwoElementsOnAnEdge) {
  // Two cubes have a common edge; a fin stands on a cube.
  SurfaceMesh mesh = cube(ElementType::quad4, 1);
  mesh.node.push_back({-1, -1, -1});
  add_element(mesh, ElementType::tri3, {mesh.element(0)[0], mesh.element(0)[1], 8});
  for (SurfaceKind kind : {SurfaceKind::closed, SurfaceKind::open})
    expect_refused(mesh, "more than two elements share an edge; 1 such in the surface; first: edge 0-", kind);
}

TEST(SurfaceCheck, EdgesShareAllTheirNodes) {
  for (SurfaceKind kind : {SurfaceKind::closed, SurfaceKind::open}) {
    // A second midside node lies at the place of the first, moved aside a little.
    SurfaceMesh mesh = cube(ElementType::quad8, 1);
    mesh.node.push_back(mesh.node[static_cast<std::size_t>(mesh.connectivity[4])] + Vec3{0.01, 0.01, 0.01});
    mesh.connectivity[4] = static_cast<std::int32_t>(mesh.node.size() - 1);
    expect_refused(mesh, "two elements share an edge but not its midside node; 1 such in the surface; first: edge ",
                   kind);
    // One face is linear, which leaves its four edges.
    mesh = cube(ElementType::quad8, 1);
    const std::vector<std::int32_t> corners(mesh.connectivity.begin(), mesh.connectivity.begin() + 4);
    drop(mesh, 0);
    add_element(mesh, ElementType::quad4, corners);
    expect_refused(mesh, "two elements share an edge but not its midside node; 4 such in the surface", kind);
    expect_refused(mesh, "(quad4)", kind);
  }
  // One face of four linear elements: its edges only look closed.
  SurfaceMesh mesh = cube(ElementType::quad9, 1);
  const std::vector<std::int32_t> n(mesh.connectivity.begin(), mesh.connectivity.begin() + 9);
  drop(mesh, 0);
  for (std::size_t i = 0; i < 4; ++i) add_element(mesh, ElementType::quad4, {n[i], n[4 + i], n[8], n[4 + (i + 3) % 4]});
  expect_refused(mesh, "open edge: only one element has it, but a body's surface must be closed; 12 such");
}

TEST(SurfaceCheck, FlippedElementsAreCounted) {
  for (ElementType type : all_types) {
    const SurfaceMesh sound = surfaces::cube_sphere(type, 3, 1);
    const auto n = static_cast<std::size_t>(sound.elements());
    SurfaceMesh mesh = sound;
    mesh.index_base = 1;
    for (std::size_t e = 17; e < 30; ++e) reverse(mesh, e);
    expect_refused(mesh,
                   "flipped element: its normal looks into the body; reverse the order of its nodes (counter-clockwise "
                   "seen from outside); 13 such in the surface; first: element 18 (");
    // The majority is turned, but does not decide.
    mesh = sound;
    for (std::size_t e = 2; e < n; ++e) reverse(mesh, e);
    expect_refused(mesh, std::to_string(n - 2) + " such in the surface; first: element 2 (");
    expect_refused(surfaces::turn_inside_out(sound),
                   "the normals of all elements look into the body: reverse the order of their nodes "
                   "(counter-clockwise seen from outside); " +
                       std::to_string(n) + " such");
  }
  // The majority decides without an inside.
  SurfaceMesh open = cube(ElementType::quad4, 2);
  drop(open, 0);
  reverse(open, 4);
  expect_refused(open,
                 "flipped element: its normal is opposite to that of most elements it hangs together with; reverse the "
                 "order of its nodes; 1 such in the surface; first: element 4 (quad4)",
                 SurfaceKind::open);
}

TEST(SurfaceCheck, CavitiesThatLookTheWrongWay) {
  for (ElementType type : all_types) {
    const SurfaceMesh outer = surfaces::cube_sphere(type, 2, 1);
    const SurfaceMesh inner = surfaces::cube_sphere(type, 1, 0.5);
    const auto first = outer.elements(), n = inner.elements();
    SurfaceMesh hollow = surfaces::with_cavity(outer, inner);
    for (auto e = first; e < first + n / 3; ++e) reverse(hollow, static_cast<std::size_t>(e));
    expect_refused(hollow,
                   std::to_string(n / 3) + " such in the surface; first: element " + std::to_string(first) + " (");
    expect_refused(hollow, "on the wall of a cavity");
    // The whole might be a body as well. The order of the shells does not matter, nor that both are wrong.
    const std::string words = "the elements of a cavity look into the cavity";
    expect_refused(join(outer, inner), "those of elements 0 and " + std::to_string(first));
    expect_refused(join(outer, inner), words);
    expect_refused(join(inner, outer), "those of elements 0 and " + std::to_string(n));
    expect_refused(surfaces::turn_inside_out(join(surfaces::turn_inside_out(inner), outer)),
                   "the normals of all elements look into the body");
  }
}

TEST(SurfaceCheck, BodiesHangTogether) {
  for (ElementType type : all_types) {
    const SurfaceMesh ball = surfaces::cube_sphere(type, 1, 1);
    SurfaceMesh mesh = join(join(ball, ball, {5, 0, 0}), ball, {0, 5, 0});
    mesh.index_base = 1;
    const auto n = ball.elements();
    expect_refused(mesh, "the surface encloses several bodies that do not hang together, as those of elements 1 and " +
                             std::to_string(n + 1) + " (counting from 1): give each its own body");
    // Parts beside each other are several bodies, whichever way they look.
    expect_refused(join(ball, surfaces::turn_inside_out(ball), {5, 0, 0}), "encloses several bodies");
    // The third part is a ball that rattles in a cavity.
    mesh = join(surfaces::with_cavity(surfaces::cube_sphere(type, 2, 3), surfaces::cube_sphere(type, 2, 2)), ball);
    expect_refused(mesh, "encloses several bodies that do not hang together");
  }
}

TEST(SurfaceCheck, ClosedPartsWithoutVolume) {
  SurfaceMesh mesh = tetrahedron();
  mesh.node[3] = {0.3, 0.3, 1e-13};
  mesh.index_base = 1;
  expect_refused(mesh, "a closed part encloses no volume; 1 such in the surface; first: the one of element 1");
  mesh.node[3] = {0.3, 0.3, 1e-6};
  expect_accepted(mesh, "flat tetrahedron");
}

}  // namespace
}  // namespace rollcon
