// Tests what the compliance inherits from the half-space: reflections, scale, reciprocity.

#include "bodies/halfspace/halfspace.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// Returns all nine blocks at points, [3 i + j][p * nodes + k].
std::vector<std::vector<double>> matrix(const Frame& frame, HalfspaceConstants c, double tolerance,
                                        std::span<const double> x, std::span<const double> y) {
  const auto compliance = make_halfspace_compliance(frame, c, tolerance, 1);
  const auto n = static_cast<std::size_t>(frame.nodes());
  std::vector<std::vector<double>> a(9, std::vector<double>(x.size() * n));
  ComplianceBlock block;
  block.stride = static_cast<std::ptrdiff_t>(n);
  for (std::size_t k = 0; k < 9; ++k) block.a[k / 3][k % 3] = a[k].data();
  compliance->block({x, y}, block);
  return a;
}

/// Reflects a frame at x = 0 with the same node numbers: every element is turned around.
SurfaceMesh reflected(SurfaceMesh mesh) {
  for (Vec3& node : mesh.node) node[0] = -node[0];
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto first = mesh.connectivity.begin() + mesh.offset[static_cast<std::size_t>(e)];
    const int corners = corner_count(mesh.type[static_cast<std::size_t>(e)]);
    std::reverse(first + 1, first + corners);
    if (is_quadratic(mesh.type[static_cast<std::size_t>(e)])) std::reverse(first + corners, first + 2 * corners);
  }
  return mesh;
}

class Symmetry : public ::testing::TestWithParam<ElementType> {
 protected:
  SurfaceMesh mesh() const {
    const auto lines = frames::uniform_lines(-1, 1, 4);
    SurfaceMesh m = frames::perturb(frames::rectangle(GetParam(), lines, lines), 0.1, 7);
    return is_quadratic(GetParam()) ? frames::bend_midsides(std::move(m), 0.04, 5) : m;
  }
};

TEST_P(Symmetry, reflection_changes_signs_and_nothing_else) {
  const Frame frame = build_frame(mesh(), Axes{});
  const Frame mirror = build_frame(reflected(mesh()), Axes{});
  const HalfspaceConstants c{1, 0.4, 0.2};
  const auto a = matrix(frame, c, 1e-6, frame.x, frame.y);
  const auto b = matrix(mirror, c, 1e-6, mirror.x, mirror.y);
  double error = 0, size = 0;
  for (std::size_t k = 0; k < 9; ++k) {
    const double sign = (k / 3 == 0) == (k % 3 == 0) ? 1 : -1;  // components along x change sign
    for (std::size_t m = 0; m < a[k].size(); ++m) {
      size = std::max(size, std::abs(a[k][m]));
      error = std::max(error, std::abs(a[k][m] - sign * b[k][m]));
    }
  }
  std::printf("%d nodes: reflection error %.1e (bound 1e-13)\n", node_count(GetParam()), error / size);
  EXPECT_LE(error / size, 1e-13);
}

TEST_P(Symmetry, scale_of_length_is_the_scale_of_the_integrals) {
  const Frame frame = build_frame(mesh(), Axes{});
  const HalfspaceConstants c{1, 0.4, 0.2};
  const auto a = matrix(frame, c, 1e-6, frame.x, frame.y);
  double error = 0, size = 0;
  for (const double scale : {1e-6, 1e6}) {
    const Frame scaled = build_frame(frames::stretch(mesh(), scale, scale), Axes{});
    const auto b = matrix(scaled, c, 1e-6, scaled.x, scaled.y);
    for (std::size_t k = 0; k < 9; ++k)
      for (std::size_t m = 0; m < a[k].size(); ++m) {
        size = std::max(size, std::abs(a[k][m]));
        error = std::max(error, std::abs(a[k][m] - b[k][m] / scale));
      }
  }
  std::printf("%d nodes: scale 1e-6 and 1e6, error %.1e (bound 1e-12)\n", node_count(GetParam()), error / size);
  EXPECT_LE(error / size, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(types, Symmetry,
                         ::testing::Values(ElementType::tri3, ElementType::tri6, ElementType::quad4, ElementType::quad8,
                                           ElementType::quad9),
                         [](const auto& info) { return std::to_string(node_count(info.param)); });

TEST(reciprocity, work_of_two_loads_is_mutual_as_the_outer_rule_refines) {
  // The integrals of t1 . u2 and t2 . u1 agree, the outer integrals by Gauss rules on each element of a grid.
  const auto lines = frames::uniform_lines(-1, 1, 3);
  const Frame frame = build_frame(frames::rectangle(ElementType::quad4, lines, lines), Axes{});
  const auto n = static_cast<std::size_t>(frame.nodes());
  const auto compliance = make_halfspace_compliance(frame, {1, 0.4, 0.2}, 1e-9, 1);
  frames::Random random(11);
  std::vector<double> t1(3 * n), t2(3 * n);
  for (double& t : t1) t = random();
  for (double& t : t2) t = random();
  double error[2], h = 2.0 / 3;
  for (int refinement = 0; refinement < 2; ++refinement) {
    const int parts = refinement == 0 ? 8 : 16;
    double work12 = 0, work21 = 0;
    std::vector<double> x, y, f1, f2;
    for (int ex = 0; ex < 3; ++ex)
      for (int ey = 0; ey < 3; ++ey)
        for (int i = 0; i < parts; ++i)
          for (int j = 0; j < parts; ++j) {
            const double s = (i + 0.5) / parts, t = (j + 0.5) / parts;
            x.push_back(-1 + (ex + s) * h);
            y.push_back(-1 + (ey + t) * h);
            const auto node = frame.mesh.element(0).size();
            ASSERT_EQ(node, 4u);
            // Values are interpolated bilinearly from the four nodes at the element's corners.
            for (int c = 0; c < 3; ++c) {
              double v1 = 0, v2 = 0;
              for (std::size_t k = 0; k < n; ++k) {
                const double nx = 1 - std::abs(x.back() - frame.x[k]) / h;
                const double ny = 1 - std::abs(y.back() - frame.y[k]) / h;
                if (nx <= 0 || ny <= 0) continue;
                v1 += nx * ny * t1[3 * k + static_cast<std::size_t>(c)];
                v2 += nx * ny * t2[3 * k + static_cast<std::size_t>(c)];
              }
              f1.push_back(v1);
              f2.push_back(v2);
            }
          }
    std::vector<double> u1(f1.size()), u2(f2.size());
    compliance->apply({x, y}, t1.data(), u1.data());
    compliance->apply({x, y}, t2.data(), u2.data());
    double size = 0;
    for (std::size_t k = 0; k < f1.size(); ++k) {
      work12 += f1[k] * u2[k];
      work21 += f2[k] * u1[k];
      size += std::abs(f1[k] * u2[k]);
    }
    error[refinement] = std::abs(work12 - work21) / size;
  }
  std::printf("reciprocity: error %.1e, %.1e (bounds 2e-4, and a third of the first)\n", error[0], error[1]);
  EXPECT_LE(error[0], 2e-4);
  EXPECT_LE(error[1], error[0] / 3);
}

}  // namespace
}  // namespace rollcon
