#include "mesh/lattice.hpp"

#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

SurfaceMesh grid(int nx, int ny, double dx, double dy) {
  return frames::rectangle(ElementType::quad4, frames::uniform_lines(-3, -3 + nx * dx, nx),
                           frames::uniform_lines(2, 2 + ny * dy, ny));
}

Frame frame_of(SurfaceMesh mesh) {
  return build_frame(std::move(mesh), Axes{});
}

/// Renumbers nodes, and puts elements in another order, each beginning at another corner.
SurfaceMesh shuffled(const SurfaceMesh& mesh) {
  SurfaceMesh out = mesh;
  const auto n = static_cast<std::size_t>(mesh.nodes()), m = static_cast<std::size_t>(mesh.elements());
  const auto number = [&](std::int32_t k) { return static_cast<std::int32_t>(static_cast<std::size_t>(k) * 7919 % n); };
  for (std::size_t k = 0; k < n; ++k)
    out.node[static_cast<std::size_t>(number(static_cast<std::int32_t>(k)))] = mesh.node[k];
  for (std::size_t e = 0; e < m; ++e)
    for (std::size_t i = 0; i < 4; ++i)
      out.connectivity[e * 7907 % m * 4 + i] = number(mesh.connectivity[4 * e + (i + e) % 4]);
  return out;
}

void expect_lattice(const Frame& frame, std::int64_t nx, std::int64_t ny, double dx, double dy) {
  const std::optional<Lattice> found = find_lattice(frame);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->nx, nx);
  EXPECT_EQ(found->ny, ny);
  EXPECT_NEAR(found->dx, dx, 1e-12 * dx);
  EXPECT_NEAR(found->dy, dy, 1e-12 * dy);
  EXPECT_GT(found->ex, 0);
  EXPECT_NEAR(std::hypot(found->ex, found->ey), 1, 1e-14);
  EXPECT_LE(std::abs(found->ey), found->ex * (1 + 1e-6));
  std::vector<int> seen(frame.x.size(), 0);
  double off = 0;
  for (std::int64_t iy = 0; iy < ny; ++iy)
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      const auto k = static_cast<std::size_t>(found->node[static_cast<std::size_t>(iy * nx + ix)]);
      ++seen[k];
      const double u = static_cast<double>(ix) * found->dx, v = static_cast<double>(iy) * found->dy;
      off = std::max({off, std::abs(frame.x[k] - found->x0 - u * found->ex + v * found->ey),
                      std::abs(frame.y[k] - found->y0 - u * found->ey - v * found->ex)});
    }
  EXPECT_LT(off, 1e-12 * (dx * static_cast<double>(nx) + dy * static_cast<double>(ny)));
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
}

TEST(Lattice, Aligned) {
  const Frame frame = frame_of(grid(7, 4, 0.3, 0.5));
  expect_lattice(frame, 8, 5, 0.3, 0.5);
  const std::optional<Lattice> found = find_lattice(frame);
  EXPECT_EQ(found->ex, 1);
  EXPECT_EQ(found->ey, 0);
  EXPECT_NEAR(found->x0, -3, 1e-15 * 3);
  EXPECT_NEAR(found->y0, 2, 1e-15 * 3);
  EXPECT_NEAR(found->spacing_along_flow(), 0.3, 1e-15);
}

TEST(Lattice, OneCellAndOneRow) {
  expect_lattice(frame_of(grid(1, 1, 0.3, 0.5)), 2, 2, 0.3, 0.5);
  expect_lattice(frame_of(grid(9, 1, 0.3, 0.5)), 10, 2, 0.3, 0.5);
  expect_lattice(frame_of(grid(1, 9, 0.3, 0.5)), 2, 10, 0.3, 0.5);
}

TEST(Lattice, TurnedAndRenumbered) {
  for (const double angle : {0.0, 0.3, 0.7, 0.78539816339744831, 1.0, 1.6, 3.0, -0.5, -2.2}) {
    SCOPED_TRACE(angle);
    const Frame frame = frame_of(shuffled(frames::rotate(grid(11, 6, 0.03, 0.05), angle)));
    // The angle decides which side is closer to t1.
    const bool swapped = std::abs(std::cos(angle)) < std::abs(std::sin(angle)) - 1e-9;
    const bool tie = std::abs(std::abs(std::cos(angle)) - std::abs(std::sin(angle))) < 1e-9;
    const std::optional<Lattice> found = find_lattice(frame);
    ASSERT_TRUE(found.has_value());
    if (swapped || (tie && found->nx == 7))
      expect_lattice(frame, 7, 12, 0.05, 0.03);
    else
      expect_lattice(frame, 12, 7, 0.03, 0.05);
    if (tie) {
      EXPECT_GT(found->ey, 0);
    }
  }
}

TEST(Lattice, SpacingAlongFlowIsThatOfTurnedCells) {
  // Squares turned by half a right angle meet the flow along their diagonals.
  const Frame frame = frame_of(frames::rotate(grid(5, 5, 0.2, 0.2), 0.78539816339744831));
  EXPECT_NEAR(find_lattice(frame)->spacing_along_flow(), 0.2 / std::sqrt(2.0), 1e-12);
}

TEST(Lattice, LargeAndFarFromTheOrigin) {
  SurfaceMesh mesh = frames::rotate(grid(300, 200, 0.01, 0.02), 0.2);
  for (Vec3& x : mesh.node) x = {x[0] + 100, x[1] - 50, x[2]};
  const Frame frame = frame_of(std::move(mesh));
  const std::optional<Lattice> found = find_lattice(frame);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->nx, 301);
  EXPECT_EQ(found->ny, 201);
}

TEST(Lattice, RoundingIsForgivenJitterIsNot) {
  for (const double size : {1e-12, 1e-6, 1e-3}) {
    SurfaceMesh mesh = frames::rotate(grid(8, 8, 1, 1), 0.4);
    frames::Random random(5);
    for (Vec3& x : mesh.node) x = {x[0] + size * random(), x[1] + size * random(), x[2]};
    std::string why;
    const std::optional<Lattice> found = find_lattice(frame_of(std::move(mesh)), &why);
    EXPECT_EQ(found.has_value(), size < lattice_tolerance);
    if (!found) {
      EXPECT_NE(why.find("off its place"), std::string::npos) << why;
      continue;
    }
    EXPECT_LE(found->misfit, 3 * size + 1e-14);
    EXPECT_NEAR(found->dx, 1, size);
    EXPECT_NEAR(found->dy, 1, size);
  }
}

TEST(Lattice, SinglePrecisionIsALatticeAndStaysAligned) {
  for (const int cells : {64, 300}) {
    SurfaceMesh mesh = frames::rectangle(ElementType::quad4, frames::uniform_lines(-1.3, 1.3, 64),
                                         frames::uniform_lines(-1.1, 1.1, cells));
    for (Vec3& x : mesh.node)
      x = {static_cast<double>(static_cast<float>(x[0])), static_cast<double>(static_cast<float>(x[1])), 0};
    const std::optional<Lattice> found = find_lattice(frame_of(std::move(mesh)));
    ASSERT_TRUE(found.has_value()) << cells;
    EXPECT_EQ(found->ey, 0);
    EXPECT_NEAR(found->dx, 2.6 / 64, 1e-8);
    EXPECT_NEAR(found->dy, 2.2 / cells, 1e-9);
    EXPECT_GT(found->misfit, 1e-8);
  }
}

TEST(Lattice, SlenderCellsMayBeTurned) {
  SurfaceMesh mesh = frames::rotate(grid(40, 60, 1, 1e-5), 1.4);
  expect_lattice(frame_of(std::move(mesh)), 61, 41, 1e-5, 1);
}

void erase_element(SurfaceMesh& mesh, std::size_t e) {
  const auto at = mesh.connectivity.begin() + static_cast<std::ptrdiff_t>(4 * e);
  mesh.connectivity.erase(at, at + 4);
  mesh.type.pop_back();
  mesh.tag.pop_back();
  mesh.offset.pop_back();
}

TEST(Lattice, CellsMayLackAndNodesLieLoose) {
  SurfaceMesh mesh = grid(6, 5, 0.5, 0.4);
  // The cells removed are the four around node (2, 2), the corner cell, and one inside.
  for (const std::size_t gone : {15u, 14u, 13u, 8u, 7u, 0u}) erase_element(mesh, gone);
  mesh.node.push_back({20, 20, 0});
  const std::optional<Lattice> found = find_lattice(frame_of(mesh));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->nx, 7);
  EXPECT_EQ(found->ny, 6);
  EXPECT_EQ(found->frame_nodes(), mesh.nodes());
  EXPECT_EQ(found->loose, (std::vector<std::int32_t>{0, 16, 42}));
  const auto cells = [&](std::size_t ix, std::size_t iy) { return found->cells[iy * 7 + ix]; };
  EXPECT_EQ(found->node[0], -1);
  EXPECT_EQ(found->node[2 * 7 + 2], -1);
  EXPECT_EQ(cells(0, 0), 0);
  EXPECT_EQ(cells(1, 0), Lattice::high_high);
  EXPECT_EQ(cells(2, 2), 0);
  EXPECT_EQ(cells(5, 4), Lattice::all);
  EXPECT_EQ(cells(6, 5), Lattice::low_low);
  EXPECT_EQ(cells(1, 1), Lattice::high_low | Lattice::low_high);
  EXPECT_NEAR(found->dx, 0.5, 1e-15);
  // The grid has too few nodes.
  SurfaceMesh ring = grid(40, 40, 1, 1);
  for (std::size_t e = 1600; e-- > 0;) {
    const std::size_t i = e % 40, j = e / 40;
    if (i > 0 && i < 39 && j > 0 && j < 39) erase_element(ring, e);
  }
  std::string why;
  EXPECT_FALSE(find_lattice(frame_of(ring), &why).has_value());
  EXPECT_NE(why.find("fill"), std::string::npos) << why;
}

TEST(Lattice, RefusesWhatIsNone) {
  const auto found = [](SurfaceMesh mesh) { return find_lattice(frame_of(std::move(mesh))).has_value(); };
  // These grids have one node off its place, one line off its place, graded lines, or sheared cells.
  EXPECT_FALSE(found(frames::perturb(grid(6, 6, 1, 1), 0.01, 1)));
  SurfaceMesh corner = grid(6, 6, 1, 1);
  corner.node[0] = {corner.node[0][0] - 1e-3, corner.node[0][1], 0};
  EXPECT_FALSE(found(corner));
  const std::vector<double> even = frames::uniform_lines(0, 1, 6), graded = frames::cosine_lines(1, 6);
  EXPECT_FALSE(found(frames::rectangle(ElementType::quad4, graded, even)));
  EXPECT_FALSE(found(frames::rectangle(ElementType::quad4, even, graded)));
  EXPECT_FALSE(found(frames::transform(grid(6, 6, 1, 1), [](const Vec3& x) {
    return Vec3{x[0] + 1e-3 * x[1], x[1], x[2]};
  })));
  // Other elements make no lattice.
  for (const ElementType type : {ElementType::quad8, ElementType::quad9, ElementType::tri3, ElementType::tri6})
    EXPECT_FALSE(found(frames::rectangle(type, even, even)));
  EXPECT_FALSE(found(frames::o_grid(ElementType::quad4, 4, 2, 1, 1)));
}

TEST(Lattice, CurvedFramesHaveNone) {
  Frame frame = frame_of(grid(6, 6, 1, 1));
  std::vector<Vec3> normal(frame.x.size());
  for (std::size_t k = 0; k < normal.size(); ++k) normal[k] = {0.01 * frame.x[k], 0, 1};
  curve_frame(frame, normal);
  ASSERT_TRUE(frame.curved());
  EXPECT_FALSE(find_lattice(frame).has_value());
}

}  // namespace
}  // namespace rollcon
