/// Tests every way in which a volume mesh can be wrong, with the words that the caller reads; and good ones, however
/// slender, small or large.

#include "mesh/refusals.hpp"
#include "mesh/volume_boundary.hpp"
#include "mesh/volume_shape.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {
namespace {

using volumes::all_types;
using volumes::Mesh;
using volumes::name_of;

using surfaces::at;

void expect_refused(const Mesh& mesh, const std::string& words, std::int32_t index_base = 1) {
  expect_error_text([&] { check_volume(mesh.surface.node, mesh.volume, index_base); }, words);
}

void expect_accepted(const Mesh& mesh, const std::string& what) {
  expect_no_error([&] { check_volume(mesh.surface.node, mesh.volume, 0); }, what);
}

void add(Mesh& mesh, VolumeType type, const std::vector<std::int32_t>& nodes) {
  volumes::add_element(mesh.volume, type, nodes);
}

Mesh cube(VolumeType type, int n = 2, double size = 1) {
  return volumes::block(surfaces::brick({n, n, n}, {size, size, size}), type);
}

/// Puts the reference element in space.
Mesh alone(VolumeType type) {
  Mesh mesh;
  const auto nodes = reference_nodes(type);
  mesh.surface.node.assign(nodes.begin(), nodes.end());
  std::vector<std::int32_t> all(nodes.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
  add(mesh, type, all);
  return mesh;
}

/// Puts b beside a, its nodes on a's where they coincide.
Mesh join(Mesh a, const Mesh& b, const Vec3& shift = {0, 0, 0}) {
  std::vector<std::int32_t> number;
  const std::size_t own = a.surface.node.size();
  for (const Vec3& y : b.surface.node) {
    const Vec3 x = y + shift;
    std::size_t k = 0;
    while (k < own && length(a.surface.node[k] - x) > 1e-9) ++k;
    number.push_back(static_cast<std::int32_t>(k < own ? k : a.surface.node.size()));
    if (k == own) a.surface.node.push_back(x);
  }
  for (std::int64_t e = 0; e < b.volume.elements(); ++e) {
    std::vector<std::int32_t> nodes;
    for (const std::int32_t k : b.volume.element(e)) nodes.push_back(number[at(k)]);
    add(a, b.volume.type[at(e)], nodes);
  }
  return a;
}

/// Mirrors element e into the form that a caller with the other convention would give.
void mirror(Mesh& mesh, std::int64_t e) {
  const VolumeType type = mesh.volume.type[at(e)];
  const auto nodes = mesh.volume.element(e);
  const std::vector<std::int32_t> old(nodes.begin(), nodes.end());
  const auto reference = reference_nodes(type);
  for (std::size_t i = 0; i < old.size(); ++i) {
    Vec3 x = reference[i];
    if (corner_count(type) == 4)
      std::swap(x[0], x[1]);
    else
      x[2] = -x[2];
    const auto from = std::find(reference.begin(), reference.end(), x) - reference.begin();
    mesh.volume.connectivity[at(mesh.volume.offset[at(e)]) + i] = old[at(from)];
  }
}

TEST(VolumeCheck, SoundBodiesPass) {
  for (const VolumeType type : all_types) {
    const std::string name = name_of(type);
    expect_accepted(alone(type), "one " + name);
    expect_accepted(cube(type, 3), "cube " + name);
    expect_accepted(volumes::distort(cube(type, 4), 0.15, 11), "distorted cube " + name);
    expect_accepted(volumes::ring({.around = 42}, type), "ring " + name);
    expect_accepted(cube(type, 2, 1e-9), "small cube " + name);
    expect_accepted(cube(type, 2, 1e9), "large cube " + name);
    expect_accepted(volumes::block(surfaces::brick({3, 3, 3}, {1, 1, 1e-7}), type), "thin sheet " + name);
    expect_accepted(volumes::transform(cube(type),
                                       [](const Vec3& x) {
                                         return x + Vec3{1e6, -1e6, 3e5};
                                       }),
                    "far away " + name);
  }
  for (const bool quadratic : {false, true})
    expect_accepted(volumes::mixed_block(surfaces::brick({3, 3, 3}, {1, 1, 1}), quadratic), "mixed block");
}

TEST(VolumeCheck, NoElements) {
  expect_refused({}, "the volume has no elements");
}

TEST(VolumeCheck, Connectivity) {
  for (const VolumeType type : all_types) {
    const std::string name = name_of(type);
    Mesh mesh = cube(type);
    const auto last = static_cast<long long>(mesh.surface.node.size());
    mesh.volume.connectivity[at(mesh.volume.offset[1]) + 2] = static_cast<std::int32_t>(last);
    expect_refused(mesh, "an element refers to a node that does not exist; 1 such in the volume; first: element 2 (" +
                             name + "), node " + std::to_string(last + 1) + " of 1.." + std::to_string(last));
    mesh.volume.connectivity[at(mesh.volume.offset[1]) + 2] = -1;
    expect_refused(mesh, "element 1 (" + name + "), node -1 of 0.." + std::to_string(last - 1), 0);

    mesh = cube(type);
    auto first = mesh.volume.connectivity.begin() + mesh.volume.offset[2];
    first[3] = first[1];
    expect_refused(mesh, "a node is repeated within an element; 1 such in the volume; first: element 3 (" + name +
                             "), node " + std::to_string(first[1] + 1));

    mesh = cube(type);
    const auto nodes = mesh.volume.element(1);
    add(mesh, type, {nodes.begin(), nodes.end()});
    mirror(mesh, mesh.volume.elements() - 1);
    expect_refused(mesh, "the same element is given twice; 1 such in the volume; first: elements 2 and " +
                             std::to_string(mesh.volume.elements()));

    mesh = cube(type);
    mesh.surface.node.push_back({5, 5, 5});
    expect_refused(mesh, "a node belongs to no element; 1 such in the volume; first: node " + std::to_string(last + 1));
  }
}

TEST(VolumeCheck, InvertedElements) {
  const std::string words =
      "element turned inside out: its Jacobian is negative; mirror the order of its nodes (exchange the bottom and the "
      "top face of wedges and hexahedra, the second and the third corner of tetrahedra, and their midside nodes with "
      "them); ";
  for (const VolumeType type : all_types) {
    Mesh mesh = volumes::distort(cube(type), 0.1, 2);
    mirror(mesh, 1);
    expect_refused(mesh, words + "1 such in the volume; first: element 2 (" + name_of(type) + ")");
    mirror(mesh, 1);
    expect_accepted(mesh, "mirrored twice");
    for (std::int64_t e = 0; e < mesh.volume.elements(); ++e) mirror(mesh, e);
    expect_refused(mesh, words + std::to_string(mesh.volume.elements()) + " such");
  }
}

TEST(VolumeCheck, FlatElements) {
  for (const VolumeType type : all_types) {
    Mesh mesh = alone(type);
    for (Vec3& x : mesh.surface.node) {
      const double u = x[0] + 0.3 * x[2], v = x[1] + 0.4 * x[2];
      x = {u, v, 0.1 * u + 0.2 * v};
    }
    expect_refused(
        mesh, "degenerate element: it has no volume; 1 such in the volume; first: element 1 (" + name_of(type) + ")");
  }
  // Four corners lie nearly in a plane: a sliver is allowed until rounding decides.
  Mesh mesh = alone(VolumeType::tet4);
  mesh.surface.node[3] = {0.4, 0.3, 1e-8};
  expect_accepted(mesh, "sliver");
  mesh.surface.node[3][2] = 1e-11;
  expect_refused(mesh, "it has no volume");
}

TEST(VolumeCheck, CoincidingNodes) {
  for (const VolumeType type : all_types) {
    Mesh mesh = cube(type);
    const auto nodes = mesh.volume.element(0);
    mesh.surface.node[at(nodes[1])] = mesh.surface.node[at(nodes[3])];
    expect_refused(mesh, "degenerate element: two of its nodes coincide;");
    expect_refused(mesh, "first: element 1 (" + name_of(type) + "), nodes " + std::to_string(nodes[1] + 1) + " and " +
                             std::to_string(nodes[3] + 1));
  }
  // Two cubes stand side by side, each with its own nodes.
  const Mesh one = cube(VolumeType::hex8, 1);
  Mesh two = one;
  const auto n = static_cast<std::int32_t>(one.surface.node.size());
  std::vector<std::int32_t> nodes;
  for (const std::int32_t k : one.volume.element(0)) nodes.push_back(k + n);
  for (const Vec3& x : one.surface.node) two.surface.node.push_back(x + Vec3{1, 0, 0});
  add(two, VolumeType::hex8, nodes);
  expect_refused(
      two, "two nodes lie at the same place: give the elements one node there; 4 such in the volume; first: nodes ");
}

const std::string folded =
    "degenerate element: its Jacobian is not positive everywhere (folded, corners of 180 degrees or more, nodes in a "
    "wrong order, or a midside node at or beyond the quarter of its edge); 1 such in the volume; first: element 1 (";

TEST(VolumeCheck, FoldedElements) {
  // A corner is pushed through the element.
  for (const VolumeType type : {VolumeType::wedge6, VolumeType::hex8}) {
    Mesh mesh = alone(type);
    mesh.surface.node.back() = {0.1, 0.1, -0.9};
    expect_refused(mesh, folded + name_of(type) + ") at node ");
  }
  // The top corners begin at the wrong one.
  Mesh mesh = alone(VolumeType::hex8);
  auto top = mesh.volume.connectivity.begin() + 4;
  std::rotate(top, top + 2, top + 4);
  expect_refused(mesh, folded + "hex8)");
  // A midside node lies beyond the quarter of its edge; at the third it is good.
  for (const VolumeType type : {VolumeType::tet10, VolumeType::wedge15, VolumeType::hex20}) {
    const auto edge = edges_of(type)[0];
    for (const double place : {0.2, 0.25, 0.26, 1.0 / 3}) {
      mesh = alone(type);
      auto& node = mesh.surface.node;
      node[at(corner_count(type))] = node[at(edge[0])] + place * (node[at(edge[1])] - node[at(edge[0])]);
      if (place <= 0.25)
        expect_refused(mesh, folded + name_of(type) + ") at node 1");
      else
        expect_accepted(mesh, "midside node at " + std::to_string(place));
    }
  }
}

/// Returns the smallest Jacobian at the nodes and at the points of the stiffness's rule.
double least_jacobian(const Mesh& mesh) {
  const VolumeType type = mesh.volume.type[0];
  std::vector<Vec3> points = volume_rule(type, is_quadratic(type) ? 5 : 2).point;
  const auto nodes = reference_nodes(type);
  points.insert(points.end(), nodes.begin(), nodes.end());
  double least = 1e9;
  for (const Vec3& at : points) {
    VolumeShape s;
    evaluate_shape(type, at, s);
    Vec3 u{0, 0, 0}, v = u, w = u;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      u = u + s.d[i][0] * mesh.surface.node[i];
      v = v + s.d[i][1] * mesh.surface.node[i];
      w = w + s.d[i][2] * mesh.surface.node[i];
    }
    least = std::min(least, dot(u, cross(v, w)));
  }
  return least;
}

TEST(VolumeCheck, ElementsThatFoldInside) {
  // The element is sound at all nodes and at the points of the stiffness's rule, but not between them: a bar twisted by
  // half a turn has no width at its middle.
  for (const double angle : {2.8, 3.14159265358979}) {
    Mesh mesh = alone(VolumeType::hex8);
    for (std::size_t i = 4; i < 8; ++i) {
      const Vec3 x = mesh.surface.node[i];
      mesh.surface.node[i] = {std::cos(angle) * x[0] - std::sin(angle) * x[1],
                              std::sin(angle) * x[0] + std::cos(angle) * x[1], x[2]};
    }
    EXPECT_GT(least_jacobian(mesh), 0.1);
    if (angle < 3)
      expect_accepted(mesh, "less than half a turn");
    else
      expect_refused(mesh, folded + "hex8) at xi = ");
  }
  // These elements were found among many with nodes displaced at random.
  const std::pair<VolumeType, std::uint32_t> found[] = {{VolumeType::hex20, 613}, {VolumeType::wedge15, 568}};
  for (const auto& [type, seed] : found) {
    Mesh mesh = alone(type);
    frames::Random random(seed);
    for (Vec3& x : mesh.surface.node)
      for (double& c : x) c += 0.35 * random();
    EXPECT_GT(least_jacobian(mesh), 0.1);
    expect_refused(mesh, folded + name_of(type) + ") at xi = ");
  }
}

TEST(VolumeCheck, FacesOfMoreThanTwoElements) {
  Mesh mesh = alone(VolumeType::tet4);
  mesh.surface.node.push_back({0.2, 0.2, 2});
  add(mesh, VolumeType::tet4, {0, 1, 2, 4});
  mesh.surface.node.push_back({0.2, 0.2, -1});
  add(mesh, VolumeType::tet4, {0, 2, 1, 5});
  expect_refused(
      mesh, "more than two elements share a face; 1 such in the volume; first: face 1-2-3 of 3 elements (1, 2, 3)");
}

TEST(VolumeCheck, FacesThatDoNotMatch) {
  const auto column = [](VolumeType type) { return volumes::block(surfaces::brick({1, 1, 1}, {1, 1, 1}), type); };
  // Linear elements stand on quadratic ones: the corners are common, the midside nodes are not.
  expect_refused(join(column(VolumeType::hex8), column(VolumeType::hex20), {0, 0, 1}),
                 "two elements share a face but not its midside nodes; 1 such in the volume; first: face 5-6-7-8 of "
                 "elements 1 (hex8) and 2 (hex20)");
  expect_refused(join(column(VolumeType::tet10), column(VolumeType::tet4), {0, 0, 1}),
                 "two elements share a face but not its midside nodes; 2 such in the volume");
  // One midside node of a common face is given twice.
  Mesh mesh = join(column(VolumeType::hex20), column(VolumeType::hex20), {0, 0, 1});
  const std::int32_t own = mesh.volume.element(0)[12];
  mesh.surface.node.push_back(mesh.surface.node[at(own)] + Vec3{0, 0, 0.05});
  mesh.volume.connectivity[12] = static_cast<std::int32_t>(mesh.surface.node.size()) - 1;
  expect_refused(mesh, "two elements share a face but not its midside nodes; 1 such in the volume");
  // A quadrilateral stands on the two triangles of wedges or tetrahedra.
  for (const VolumeType other : {VolumeType::wedge6, VolumeType::tet4})
    expect_refused(join(column(VolumeType::hex8), column(other), {0, 0, 1}),
                   "a quadrilateral face lies on triangles of its neighbours: elements on both sides of a face must "
                   "share all of its nodes; 1 such in the volume; first: face 5-6-7-8 of element 1 (hex8) on element ");
  expect_refused(join(column(VolumeType::hex20), column(VolumeType::wedge15), {0, 0, 1}),
                 "a quadrilateral face lies on triangles of its neighbours");
  // A quadratic face stands on four linear ones.
  expect_refused(join(column(VolumeType::hex20),
                      volumes::block(surfaces::brick({2, 2, 2}, {1, 1, 1}), VolumeType::hex8), {0, 0, 1}),
                 "a midside node of one element is a corner of another: elements on both sides of a face must share "
                 "all of its nodes; 4 such in the volume; first: node ");
}

TEST(VolumeCheck, PartsThatShareNoFace) {
  for (const VolumeType type : all_types) {
    const Mesh one = cube(type, 2);
    const auto second = std::to_string(one.volume.elements() + 1);
    const std::string words =
        "the volume consists of 2 parts that share no face; join them by common nodes or give each its own body; first "
        "element of the second part: element " +
        second + " (" + name_of(type) + ")";
    expect_refused(join(one, one, {3, 0, 0}), words);  // apart
    expect_refused(join(one, one, {1, 1, 0}), words);  // along an edge
    expect_refused(join(one, one, {1, 1, 1}), words);  // at a corner
    expect_accepted(join(one, one, {1, 0, 0}), "face to face");
  }
}

// The mesh has 6e9 pairs of nodes: looked at one by one, they would outlast the test's limit of time.
TEST(VolumeCheck, DoesNotCompareAllNodes) {
  const Mesh mesh = volumes::distort(cube(VolumeType::hex20, 30), 0.1, 3);
  EXPECT_NO_THROW(check_volume(mesh.surface.node, mesh.volume, 0));
}

}  // namespace
}  // namespace rollcon
