#include "mesh/frame.hpp"

#include "support/frames.hpp"
#include "support/surface_meshes.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double pi = std::numbers::pi;

double sum(const std::vector<double>& v) {
  return std::accumulate(v.begin(), v.end(), 0.0);
}

int count(const std::vector<std::uint8_t>& v) {
  return std::accumulate(v.begin(), v.end(), 0);
}

TEST(Frame, SizesOfThePapersThirdExample) {
  using namespace frames;
  const Frame quad4 = build_frame(o_grid(ElementType::quad4, 16, 6, 1.3, 1.3), Axes{});
  const Frame quad8 = build_frame(o_grid(ElementType::quad8, 16, 6, 1.3, 1.3), Axes{});
  const Frame tri3 = build_frame(paper_disc(ElementType::tri3, 1.3), Axes{});
  const Frame tri6 = build_frame(paper_disc(ElementType::tri6, 1.3), Axes{});
  EXPECT_EQ(quad4.nodes(), 673);
  EXPECT_EQ(quad4.elements(), 640);
  EXPECT_EQ(quad8.nodes(), 1985);
  EXPECT_EQ(quad8.elements(), 640);
  EXPECT_EQ(tri3.nodes(), 703);
  EXPECT_EQ(tri3.elements(), 1340);
  EXPECT_EQ(tri6.nodes(), 2745);
  EXPECT_EQ(tri6.elements(), 1340);
  EXPECT_EQ(count(tri3.rim), 64);
  EXPECT_EQ(count(tri6.rim), 128);
  // The area is that of a regular polygon with 64 sides.
  const double area = 0.5 * 64 * 1.3 * 1.3 * std::sin(2 * pi / 64);
  for (const Frame* frame : {&quad4, &quad8, &tri3, &tri6})
    expect_error("area of the 64-sided disc", frame->area / area - 1, 1e-13);
}

TEST(Frame, WeightsIntegrateTheFieldsOfTheirElements) {
  // The sum of w_i f(x_i) is exact for f linear on all straight elements, quadratic on quadratic ones.
  const auto u = frames::uniform_lines(-1, 2, 5);
  for (ElementType type :
       {ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8, ElementType::quad9}) {
    const Frame frame = build_frame(frames::rectangle(type, u, u), Axes{});
    double linear = 0, quadratic = 0;
    for (std::size_t k = 0; k < frame.x.size(); ++k) {
      linear += frame.weight[k] * (1 + 2 * frame.x[k] - frame.y[k]);
      quadratic += frame.weight[k] * (frame.x[k] * frame.x[k] + frame.x[k] * frame.y[k]);
    }
    const std::string id = ", type " + std::to_string(static_cast<int>(type));
    expect_error("integral of a linear field" + id, linear / 13.5 - 1, 1e-14);
    if (is_quadratic(type)) expect_error("integral of a quadratic field" + id, quadratic / (9 + 2.25) - 1, 1e-14);
  }
}

TEST(Frame, CurvedElementsApproachTheDisc) {
  // Midside nodes lie on the circle, so the area's error falls like h^4 from a chord polygon's h^2.
  double error[2];
  for (int k = 0; k < 2; ++k) {
    const int core = 4 << k;
    SurfaceMesh mesh = frames::o_grid(ElementType::quad9, core, 2, 1, 1);
    const Frame straight = build_frame(mesh, Axes{});
    for (std::size_t i = 0; i < mesh.node.size(); ++i)
      if (straight.rim[i]) {
        const double r = std::hypot(mesh.node[i][0], mesh.node[i][1]);
        mesh.node[i] = {mesh.node[i][0] / r, mesh.node[i][1] / r, 0};
      }
    const Frame frame = build_frame(mesh, Axes{});
    error[k] = frame.area / pi - 1;
    expect_error("sum of weights on curved elements", sum(frame.weight) / frame.area - 1, 1e-14);
  }
  expect_order("area of the disc by curved elements", observed_order(error[0], error[1], 2, 1), 3.8);
}

TEST(Frame, ProjectsOnTheAxes) {
  const auto u = frames::uniform_lines(-1, 1, 4);
  const SurfaceMesh flat = frames::rectangle(ElementType::quad8, u, u);
  // The triad is turned about all three axes, and its mesh placed in space.
  Axes axes;
  const double s = std::sqrt(0.5);
  axes.origin = {10, -20, 5};
  axes.t1 = {s, s, 0};
  axes.t2 = {0, 0, 1};
  axes.n = {s, -s, 0};
  SurfaceMesh mesh = frames::transform(flat, [&](const Vec3& p) {
    Vec3 r = axes.origin;
    for (std::size_t i = 0; i < 3; ++i) r[i] += p[0] * axes.t1[i] + p[1] * axes.t2[i] + 0.1 * p[0] * p[0] * axes.n[i];
    return r;
  });
  const Frame frame = build_frame(mesh, axes);
  double error = 0;
  for (std::size_t k = 0; k < frame.x.size(); ++k)
    error = std::max({error, std::abs(frame.x[k] - flat.node[k][0]), std::abs(frame.y[k] - flat.node[k][1]),
                      std::abs(frame.z[k] - 0.1 * flat.node[k][0] * flat.node[k][0])});
  expect_error("coordinates in turned axes", error, 1e-14);
  expect_error("projected area of a curved frame", frame.area - 4, 1e-13);
}

TEST(Frame, UnitsDoNotMatter) {
  const SurfaceMesh mesh = frames::bend_midsides(frames::paper_disc(ElementType::tri6, 1), 0.05, 2);
  const Frame one = build_frame(mesh, Axes{});
  for (double size : {1e-9, 1e-3, 1e9}) {
    const Frame frame = build_frame(frames::stretch(mesh, size, size), Axes{});
    double error = std::abs(frame.area / (size * size * one.area) - 1);
    for (std::size_t k = 0; k < one.x.size(); ++k)
      error = std::max({error, std::abs(frame.cell_area[k] / (size * size * one.cell_area[k]) - 1),
                        std::abs(frame.weight[k] / (size * size) - one.weight[k])});
    expect_error("areas and weights, size " + std::to_string(size), error, 1e-12);
  }
}

TEST(Frame, FarFromTheOriginOfSpace) {
  SurfaceMesh mesh = frames::transform(frames::paper_disc(ElementType::tri3, 1), [](const Vec3& p) {
    return Vec3{p[0] + 1e6, p[1] - 1e6, p[2] + 1e6};
  });
  Axes axes;
  axes.origin = {1e6, -1e6, 1e6};
  const Frame frame = build_frame(mesh, axes);
  const Frame near = build_frame(frames::paper_disc(ElementType::tri3, 1), Axes{});
  // Coordinates of 1e6 carry a rounding of 1e-10.
  expect_error("area at 1e6 from the origin", frame.area / near.area - 1, 1e-9);
}

TEST(Frame, NodesOfNoElementCarryNothing) {
  SurfaceMesh mesh = frames::paper_disc(ElementType::tri3, 1);
  mesh.node.push_back({5, 5, 5});
  const Frame frame = build_frame(mesh, Axes{});
  EXPECT_EQ(frame.used.back(), 0);
  EXPECT_EQ(frame.rim.back(), 0);
  EXPECT_EQ(frame.weight.back(), 0);
  EXPECT_EQ(frame.cell_area.back(), 0);
  EXPECT_EQ(count(frame.used), 703);
}

TEST(Frame, AHoleIsAllowed) {
  const auto u = frames::uniform_lines(0, 3, 3);
  // The mesh is a ring of eight squares with a rim inside.
  const SurfaceMesh ring =
      surfaces::only(frames::rectangle(ElementType::quad4, u, u), [](std::int64_t e) { return e != 4; });
  const Frame frame = build_frame(ring, Axes{});
  expect_error("area of a frame with a hole", frame.area - 8, 1e-14);
  EXPECT_EQ(count(frame.rim), 16);
}

TEST(Frame, GeneratorsAreReproducible) {
  const SurfaceMesh disc = frames::paper_disc(ElementType::tri6, 1);
  const SurfaceMesh a = frames::bend_midsides(frames::perturb(disc, 0.2, 5), 0.05, 6);
  const SurfaceMesh b = frames::bend_midsides(frames::perturb(disc, 0.2, 5), 0.05, 6);
  const SurfaceMesh c = frames::bend_midsides(frames::perturb(disc, 0.2, 7), 0.05, 6);
  EXPECT_EQ(a.node, b.node);
  EXPECT_NE(a.node, c.node);
  // The generator's first number is checked, so that meshes do not change with the platform.
  EXPECT_EQ(frames::Random(1)(), -0.34276425093412399);
}

TEST(Frame, RingsGradedToTheContactsEdge) {
  const auto radius = frames::contact_radii(2, 8, 2.6);
  for (int k = 1; k <= 8; ++k)
    expect_error("ring " + std::to_string(k), radius[static_cast<std::size_t>(k - 1)] - 2 * std::sin(pi * k / 16),
                 1e-15);
  EXPECT_EQ(radius.back(), 2.6);
  for (std::size_t k = 1; k < radius.size(); ++k) EXPECT_GT(radius[k], radius[k - 1]);
  const Frame frame = build_frame(frames::ring_disc(ElementType::tri3, radius, frames::ring_counts(radius)), Axes{});
  const int rim = frames::ring_counts(radius).back();
  expect_error("area of the polygon on the outer ring",
               frame.area / (0.5 * rim * 2.6 * 2.6 * std::sin(2 * pi / rim)) - 1, 1e-13);
}

}  // namespace
}  // namespace rollcon
