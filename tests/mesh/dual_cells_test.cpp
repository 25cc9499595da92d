#include "mesh/dual_cells.hpp"

#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

struct NamedMesh {
  std::string name;
  SurfaceMesh mesh;
};

std::vector<NamedMesh> meshes() {
  using namespace frames;
  const auto u = uniform_lines(-1, 1, 8);
  std::vector<NamedMesh> all;
  for (ElementType type :
       {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    const std::string id = std::to_string(static_cast<int>(type));
    all.push_back({"rectangle " + id, rectangle(type, u, u)});
    all.push_back({"random " + id, perturb(rectangle(type, u, u), 0.25, 3)});
    all.push_back({"stretched 1:100 " + id, stretch(perturb(rectangle(type, u, u), 0.2, 5), 1, 0.01)});
    all.push_back({"bent midsides " + id, bend_midsides(rectangle(type, u, u), 0.08, 5)});
    if (corner_count(type) == 3)
      all.push_back({"paper's disc " + id, paper_disc(type, 1.3)});
    else
      all.push_back({"elliptic O-grid " + id, o_grid(type, 16, 6, 2, 1)});
  }
  return all;
}

TEST(DualCells, FacesAndRimClose) {
  for (const NamedMesh& m : meshes()) {
    const Frame frame = build_frame(m.mesh, Axes{});
    const LinearCells cells = split_elements(frame.mesh);
    const DualCells dual = build_dual_cells(cells, frame.x, frame.y);
    const auto n = static_cast<std::size_t>(frame.nodes());
    std::vector<double> sx(n, 0), sy(n, 0), girth(n, 0);
    auto add = [&](std::int32_t node, double nx, double ny) {
      const auto k = static_cast<std::size_t>(node);
      sx[k] += nx;
      sy[k] += ny;
      girth[k] += std::hypot(nx, ny);
    };
    for (const DualFace& f : dual.face) add(f.from, f.nx, f.ny), add(f.to, -f.nx, -f.ny);
    for_each_edge(sorted_sides(cells), [&](const Side& s, std::size_t count) {
      if (count != 1) return;
      const auto a = static_cast<std::size_t>(s.from), b = static_cast<std::size_t>(s.to);
      const double nx = 0.5 * (frame.y[b] - frame.y[a]), ny = -0.5 * (frame.x[b] - frame.x[a]);
      add(s.from, nx, ny);
      add(s.to, nx, ny);
    });
    double error = 0;
    for (std::size_t k = 0; k < n; ++k) error = std::max(error, std::hypot(sx[k], sy[k]) / girth[k]);
    expect_error("sum of normals over girth, " + m.name, error, 1e-14);
  }
}

TEST(DualCells, TileTheArea) {
  for (const NamedMesh& m : meshes()) {
    const Frame frame = build_frame(m.mesh, Axes{});
    const double sum = std::accumulate(frame.cell_area.begin(), frame.cell_area.end(), 0.0);
    const double weights = std::accumulate(frame.weight.begin(), frame.weight.end(), 0.0);
    // The rims are straight between neighbouring nodes in all of these meshes.
    expect_error("sum of cell areas, " + m.name, sum / frame.area - 1, 1e-13);
    expect_error("sum of nodal weights, " + m.name, weights / frame.area - 1, 1e-13);
    for (double a : frame.cell_area) ASSERT_GT(a, 0) << m.name;
  }
}

TEST(DualCells, SquaresShareTheirAreaEqually) {
  const auto u = frames::uniform_lines(0, 4, 4);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, u, u), Axes{});
  expect_error("inner cell of unit squares", frame.cell_area[6] - 1, 1e-15);
  expect_error("rim cell of unit squares", frame.cell_area[1] - 0.5, 1e-15);
  expect_error("corner cell of unit squares", frame.cell_area[0] - 0.25, 1e-15);
}

TEST(DualCells, QuadraticElementsSplitAsInThePaper) {
  const std::vector<double> one = {0, 1};
  auto parts = [&](ElementType type) { return split_elements(frames::rectangle(type, one, one)).size(); };
  EXPECT_EQ(parts(ElementType::tri6), 2 * 4);
  EXPECT_EQ(parts(ElementType::quad9), 8);
  EXPECT_EQ(parts(ElementType::quad8), 4 + 1);
  EXPECT_EQ(parts(ElementType::quad4), 1);
}

}  // namespace
}  // namespace rollcon
