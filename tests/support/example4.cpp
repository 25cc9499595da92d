#include "support/example4.hpp"

#include <cmath>

#include "support/frames.hpp"

namespace rollcon::scenes::example4 {

namespace {

/// Makes the part of a cylinder along x whose top is the origin, normal upwards, of quad8.
SurfaceMesh rail_head(double half_length, double half_width, int n) {
  const double angle = half_width / rail;
  const SurfaceMesh flat = frames::rectangle(ElementType::quad8, frames::uniform_lines(-half_length, half_length, n),
                                             frames::uniform_lines(-angle, angle, n));
  return frames::transform(flat, [](const Vec3& x) {
    return Vec3{x[0], rail * std::sin(x[1]), rail * (std::cos(x[1]) - 1)};
  });
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
