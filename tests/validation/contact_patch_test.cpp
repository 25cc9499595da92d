// Runs the contact patch test: two blocks with different meshes are pressed on each other, and a uniform pressure must
// pass.

#include <string>
#include <vector>

#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

const Elastic soft{.shear = 400, .poisson = 0.3}, stiff{.shear = 900, .poisson = 0.2};
constexpr double pressure = 2;

/// Describes [0, 1]^2 x [0, height] between planes of symmetry x = 0, y = 0 and z = 0, with contact at its top.
struct Half {
  std::array<int, 3> parts;
  double height = 1;
  surfaces::Block shape() const { return surfaces::brick(parts, {1, 1, height}); }
};

MeshedBody between_planes(MeshedBody body, std::int64_t between_nodes) {
  body.slide = {{1, 1}, {3, 2}, {5, 4}};
  body.contact_tag = {6};
  body.int_option = {{"between_nodes", between_nodes}};
  if (body.volume.elements() == 0) body.option = {{"accuracy", 1e-10}};
  return body;
}

/// Moves midside nodes of the surface to the middle of their edges.
SurfaceMesh straighten(SurfaceMesh mesh) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    if (!is_quadratic(type)) continue;
    const auto nodes = mesh.element(e);
    const auto corners = static_cast<std::size_t>(corner_count(type));
    const auto at = [&](std::size_t i) -> Vec3& { return mesh.node[static_cast<std::size_t>(nodes[i])]; };
    for (std::size_t i = 0; i < corners; ++i) at(corners + i) = 0.5 * (at(i) + at((i + 1) % corners));
  }
  return mesh;
}

/// Describes the edges of the faces; curved ones stay within the planes of the block.
enum class Edges { straight, curved };

MeshedBody half(VolumeType type, const Half& h, const Elastic& material, Edges edges) {
  volumes::Mesh mesh = volumes::distort(volumes::block(h.shape(), type), 0.15, 5);
  if (edges == Edges::straight) mesh.surface = straighten(std::move(mesh.surface));
  return meshed(std::move(mesh), material);
}

MeshedBody half(ElementType type, const Half& h, const Elastic& material, Edges edges) {
  SurfaceMesh mesh = surfaces::distort(surfaces::block(h.shape(), type), 0.15, 5);
  if (edges == Edges::straight) mesh = straighten(std::move(mesh));
  return meshed(std::move(mesh), material);
}

struct Case {
  std::string name;
  MeshedBody lower, upper;
  bool own_frame = false;  ///< true for a third mesh, no finer than either
  double bound = 1e-10;
};

std::vector<Case> cases() {
  const Half coarse{{2, 3, 2}}, fine{{5, 4, 3}, 0.7};
  std::vector<Case> all;
  const auto add = [&](auto lower, auto upper, const std::string& name, Edges edges = Edges::straight) {
    all.push_back({name, half(lower, coarse, soft, edges), half(upper, fine, stiff, edges)});
    if (edges == Edges::curved) all.back().bound = 1e-3;
  };
  const auto add_with_frame = [&](auto lower, auto upper, const std::string& name) {
    all.push_back({name, half(lower, fine, soft, Edges::straight), half(upper, fine, stiff, Edges::straight), true});
  };
  add(VolumeType::hex8, VolumeType::hex8, "hex8 on hex8");
  add(VolumeType::hex20, VolumeType::hex20, "hex20 on hex20");
  add(VolumeType::tet10, VolumeType::tet10, "tet10 on tet10");
  add(VolumeType::hex20, VolumeType::tet4, "hex20 on tet4");
  add(VolumeType::wedge15, VolumeType::hex8, "wedge15 on hex8");
  add(VolumeType::hex8, ElementType::quad4, "hex8 on quad4 (boundary elements)");
  add(VolumeType::hex20, ElementType::tri6, "hex20 on tri6 (boundary elements)");
  add(ElementType::quad8, VolumeType::wedge15, "quad8 (boundary elements) on wedge15");
  add(VolumeType::hex20, VolumeType::hex20, "hex20 on hex20, curved edges", Edges::curved);
  add(VolumeType::tet10, VolumeType::tet10, "tet10 on tet10, curved edges", Edges::curved);
  add_with_frame(VolumeType::hex8, VolumeType::hex20, "hex8 on hex20, frame of its own");
  add_with_frame(VolumeType::hex20, ElementType::quad8, "hex20 on quad8 (boundary elements), frame of its own");
  return all;
}

/// Returns the largest deviation of the nodal pressures from the uniform one, relative.
double deviation(const Case& c, std::int64_t between_nodes) {
  RollingPair pair(between_planes(c.lower, between_nodes), between_planes(c.upper, between_nodes), 1);
  // The upper block stands on its head: x -> y keeps the planes of symmetry where they are.
  pair.pose(2, {{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}}, {0, 0, 1.7});
  pair.axes({0.5, 0.5, 1}, {1, 0, 0}, {0, 0, 1}).friction(0).load(pressure);
  if (c.own_frame) {
    SurfaceMesh frame = frames::perturb(
        frames::rectangle(ElementType::tri3, frames::uniform_lines(0, 1, 3), frames::uniform_lines(0, 1, 4)), 0.1, 7);
    for (Vec3& x : frame.node) x[2] = 1;
    pair.frame(frame);
  } else {
    pair.frame_from_body(1, 6);
  }
  EXPECT_GE(pair.solve(), 0);
  double worst = 0;
  for (const double p : pair.solution().pressure) worst = std::max(worst, std::abs(p / pressure - 1));
  return worst;
}

class ContactPatch : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ContactPatch, a_uniform_pressure_passes) {
  const Case c = cases()[GetParam()];
  expect_error(c.name + ": pressure, by shape functions between nodes", deviation(c, 1), c.bound);
  report(c.name + ": pressure, by a half-space between nodes", deviation(c, 0));
}

INSTANTIATE_TEST_SUITE_P(Pairs, ContactPatch, ::testing::Range(std::size_t{0}, cases().size()), [](const auto& param) {
  std::string name = cases()[param.param].name;
  std::erase_if(name, [](char c) { return c == ',' || c == '(' || c == ')'; });
  for (char& c : name)
    if (c == ' ') c = '_';
  return name;
});

}  // namespace
}  // namespace rollcon::validation
