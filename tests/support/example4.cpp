#include "support/example4.hpp"

#include <cmath>

namespace rollcon::scenes::example4 {

namespace {

/// Part of a cylinder along x whose top is the origin, normal upwards; quad8.
SurfaceMesh rail_head(double half_length, double half_width, int n) {
  SurfaceMesh mesh;
  mesh.offset.push_back(0);
  const int side = 2 * n + 1;
  std::vector<std::int32_t> id(static_cast<std::size_t>(side * side), -1);
  const auto node = [&](int i, int j) {
    std::int32_t& k = id[static_cast<std::size_t>(j * side + i)];
    if (k < 0) {
      const double x = half_length * (static_cast<double>(i) / n - 1);
      const double angle = half_width / rail * (static_cast<double>(j) / n - 1);
      k = static_cast<std::int32_t>(mesh.node.size());
      mesh.node.push_back({x, rail * std::sin(angle), rail * (std::cos(angle) - 1)});
    }
    return k;
  };
  for (int i = 0; i < side - 1; i += 2)
    for (int j = 0; j < side - 1; j += 2) {
      for (const auto& [a, b] : {std::pair{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}})
        mesh.connectivity.push_back(node(i + a, j + b));
      mesh.type.push_back(ElementType::quad8);
      mesh.tag.push_back(1);
      mesh.offset.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
    }
  return mesh;
}

}  // namespace

std::unique_ptr<RollingPair> pair(ElementType type, const char* scheme, int threads) {
  MeshedBody wheel;
  wheel.mesh = surfaces::wheel(0, type);
  wheel.material = material;
  wheel.held_tag = {3, 6, 7};
  wheel.contact_tag = {1, 2};
  return pair(wheel, scheme, threads);
}

std::unique_ptr<RollingPair> pair(const MeshedBody& wheel, const char* scheme, int threads) {
  MeshedBody head;
  head.mesh = rail_head(10, 20, 8);
  auto p = std::make_unique<RollingPair>(wheel, head, threads);
  // The wheel stands on its top: the rail lies above it, tilted like the cone.
  const double c = 1 / std::hypot(1, cone), s = cone * c;
  p->axes({0, 0, radius}, {1, 0, 0}, {0, s, c});
  p->pose(2, {{{1, 0, 0}, {0, -c, -s}, {0, s, -c}}}, {0, 0, radius});
  p->frame_from_body(1, 2).friction(mu).approach(depth).speed(speed);
  p->option("convection", scheme);
  return p;
}

MeshedBody part_of_wheel(const surfaces::ZoneBlock& block) {
  const auto bend = [](const Vec3& x) {
    const double r = radius + x[2] - cone * x[1], angle = x[0] / radius;
    return Vec3{r * std::sin(angle), x[1], r * std::cos(angle)};
  };
  const SurfaceMesh flat = surfaces::zone_block(block, ElementType::quad4);
  MeshedBody wheel = meshed(surfaces::transform(flat, bend), material);
  wheel.held_tag = {3, 4, 5};
  wheel.contact_tag = {1, 2};
  return wheel;
}

}  // namespace rollcon::scenes::example4
