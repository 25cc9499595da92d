#include "mesh/coarsen.hpp"

#include "contact/operators/traction_space.hpp"
#include "support/frames.hpp"
#include "support/graded_disc.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

struct NamedMesh {
  std::string name;
  SurfaceMesh mesh;
};

std::vector<NamedMesh> meshes() {
  using namespace frames;
  const auto u = uniform_lines(-1, 1, 12);
  std::vector<NamedMesh> all;
  for (ElementType type :
       {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    const std::string id = std::to_string(static_cast<int>(type));
    all.push_back({"rectangle " + id, rectangle(type, u, u)});
    all.push_back({"random " + id, perturb(rectangle(type, u, u), 0.25, 3)});
    all.push_back({"stretched 1:100 " + id, stretch(rectangle(type, u, u), 1, 0.01)});
  }
  all.push_back({"paper's disc", paper_disc(ElementType::tri3, 1.3)});
  all.push_back({"O-grid", o_grid(ElementType::quad8, 16, 6, 2, 1)});
  all.push_back({"graded rings", scenes::graded_disc(1, 2, 10)});
  return all;
}

double twice_area(const Frame& f, const CoarseMesh& m, const std::array<std::int32_t, 3>& t) {
  const auto x = [&](std::size_t i) {
    const auto k = static_cast<std::size_t>(m.node[static_cast<std::size_t>(t[i])]);
    return std::array{f.x[k], f.y[k]};
  };
  const auto a = x(0), b = x(1), c = x(2);
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

TEST(Coarsen, TrianglesCoverTheFrameWithFewerNodes) {
  for (const NamedMesh& m : meshes()) {
    const Frame frame = build_frame(m.mesh, Axes{});
    const CoarseMesh coarse = coarsen(frame);
    double area = 0;
    for (const auto& t : coarse.corner) {
      const double twice = twice_area(frame, coarse, t);
      EXPECT_GT(twice, 0) << m.name;
      area += twice / 2;
    }
    // Straight edges between the corner nodes of a curved rim cut nothing off, because all of them stay.
    expect_error(m.name + ": area", area / frame.area - 1, 1e-12);
    const double share = static_cast<double>(coarse.node.size()) / static_cast<double>(frame.nodes());
    std::printf("%-30s %5zu of %5lld nodes, share %.2f (0.2 to 0.5)\n", m.name.c_str(), coarse.node.size(),
                static_cast<long long>(frame.nodes()), share);
    EXPECT_GT(share, 0.2) << m.name;
    EXPECT_LT(share, 0.5) << m.name;
  }
}

TEST(Coarsen, GridKeepsEverySecondNodeOfEverySecondLine) {
  const auto lines = frames::uniform_lines(0, 12, 12);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, lines, lines), Axes{});
  const CoarseMesh coarse = coarsen(frame);
  EXPECT_EQ(coarse.node.size(), 49U);
  EXPECT_EQ(coarse.corner.size(), 72U);
  for (const std::int32_t k : coarse.node) {
    EXPECT_EQ(std::fmod(frame.x[static_cast<std::size_t>(k)], 2.0), 0);
    EXPECT_EQ(std::fmod(frame.y[static_cast<std::size_t>(k)], 2.0), 0);
  }
}

TEST(Coarsen, OneElementStaysWhole) {
  const std::vector<double> line{0, 1};
  for (const ElementType type : {ElementType::tri3, ElementType::quad4}) {
    const Frame frame = build_frame(frames::rectangle(type, line, line), Axes{});
    EXPECT_EQ(coarsen(frame).node.size(), 4U);
  }
}

TEST(CoarseSpace, InterpolatesLinearTractionsExactly) {
  for (const NamedMesh& m : meshes()) {
    const Frame frame = build_frame(m.mesh, Axes{});
    const TractionSpace space = coarse_space(frame);
    std::vector<double> field;
    for (std::size_t k = 0; k < frame.x.size(); ++k) field.push_back(2 + frame.x[k] - 3 * frame.y[k]);
    const std::vector<double> again = spread(space, pick(space, field));
    double worst = 0;
    for (std::size_t k = 0; k < field.size(); ++k)
      if (frame.used[k]) worst = std::max(worst, std::abs(again[k] - field[k]));
    expect_error(m.name + ": linear field", worst, 1e-12);
    // Forces of tractions in the space are sums over its nodes.
    const std::vector<double> weight = gather(space, frame.weight);
    double fine = 0, coarse = 0;
    for (std::size_t k = 0; k < field.size(); ++k) fine += frame.weight[k] * field[k];
    for (std::size_t i = 0; i < weight.size(); ++i)
      coarse += weight[i] * field[static_cast<std::size_t>(space.node[i])];
    expect_error(m.name + ": force", coarse / fine - 1, 1e-12);
  }
}

// Nodes of an almost straight rim make flat triangles, which on a curved frame stand steeply.
TEST(CoarseSpace, OfACurvedFrameWithAnAlmostStraightRim) {
  const auto along = frames::uniform_lines(-1, 1, 10), across = frames::uniform_lines(-1, 1, 8);
  for (const ElementType type : {ElementType::tri3, ElementType::quad4}) {
    const SurfaceMesh mesh = frames::transform(frames::rectangle(type, along, across), [](const Vec3& p) {
      return Vec3{p[0] * (1 - 1e-3 * p[1] * p[1]), p[1], -0.4 * p[1] * p[1]};
    });
    const Frame frame = build_frame(mesh, Axes{});
    const TractionSpace space = coarse_space(frame);
    EXPECT_LT(space.node.size(), 6 * frame.x.size() / 10);
    expect_error("area in the projection", space.frame.area / frame.area - 1, 1e-12);
  }
}

}  // namespace
}  // namespace rollcon
