// Tests nodes of which only one neighbour lies upstream, beside the path: least squares then take the difference to it,
// along the path that leads there.

#include "contact/convection/convection.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

TEST(convection, last_resort_is_the_difference_along_the_only_neighbour) {
  frames::Random random(17);
  int met = 0;
  double error = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    SurfaceMesh mesh;
    for (int k = 0; k < 3; ++k) mesh.node.push_back({random(), random(), 0});
    const Vec3 a = mesh.node[0], b = mesh.node[1], c = mesh.node[2];
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area < 0.01) continue;
    mesh.type = {ElementType::tri3};
    mesh.offset = {0, 3};
    mesh.connectivity = {0, 1, 2};
    const Frame frame = build_frame(mesh, Axes{});
    const double angle = 3.2 * random(), ex = std::cos(angle), ey = std::sin(angle);
    const SparseRows rows = least_squares(frame, ex, ey), flux = godunov(frame, ex, ey);
    for (std::size_t i = 0; i < 3; ++i) {
      if (flux.start[i] != flux.start[i + 1] || rows.start[i] == rows.start[i + 1]) continue;
      if (!rows.fallback[i] || rows.start[i + 1] - rows.start[i] != 2) continue;
      ++met;
      for (auto k = static_cast<std::size_t>(rows.start[i]); k < static_cast<std::size_t>(rows.start[i + 1]); ++k) {
        const auto j = static_cast<std::size_t>(rows.column[k]);
        if (j == i) continue;
        const double s = (frame.x[j] - frame.x[i]) * ex + (frame.y[j] - frame.y[i]) * ey;
        error = std::max(error, std::abs(rows.value[k] * s + 1));
      }
    }
  }
  std::printf("%d nodes with one neighbour upstream: error %.1e (bound 1e-12)\n", met, error);
  EXPECT_GT(met, 20);
  EXPECT_LE(error, 1e-12);
}

}  // namespace
}  // namespace rollcon
