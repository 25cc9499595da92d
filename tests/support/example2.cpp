#include "support/example2.hpp"

#include <cmath>

#include "support/carter_strip.hpp"
#include "support/dissimilar_strip.hpp"
#include "support/example1.hpp"

namespace rollcon::scenes::example2 {
namespace {

constexpr double side = 80, depth = 40;
constexpr int zone_parts = 12, parts_ahead = 2, parts_aside = 3, parts_deep = 2;

/// Returns lines of `parts` equal elements in [-half, half], and `beyond` on either side to half of the block's side.
std::vector<double> lines(double half, int parts, int beyond) {
  const double h = 2 * half / parts;
  std::vector<double> line = surfaces::graded_to(beyond, -side / 2, -half, 2 * h);
  for (int k = 1; k < parts; ++k) line.push_back(-half + k * h);
  const auto rest = surfaces::graded(beyond, half, side / 2, 2 * h);
  line.insert(line.end(), rest.begin(), rest.end());
  return line;
}

}  // namespace

double plane_creepage() {
  DissimilarStrip strip(ring, ground, radius, load / width, graded_nodes(50), "least_squares");
  return strip.roll(mu, force_ratio).creep[0];
}

surfaces::Ring ring_of(int parts) {
  surfaces::Ring shape = example1::fem_ring(parts);
  shape.zone = 3;
  shape.top_layer = shape.zone / parts;
  shape.deep = parts / 2;
  return shape;
}

SurfaceMesh ground_block(ElementType type) {
  surfaces::Block b;
  b.line[0] = lines(ring_of().zone / 2, zone_parts, parts_ahead);
  b.line[1] = lines(width / 2, zone_parts, parts_aside);
  b.line[2] = surfaces::graded_to(parts_deep, -depth, 0, 1);
  b.tag = {4, 5, 6, 7, 3, 1};
  b.zone_from = {parts_ahead, parts_aside};
  b.zone_to = {parts_ahead + zone_parts, parts_aside + zone_parts};
  b.zone_tag = 2;
  return surfaces::block(b, type);
}

MeshedBody ring_body(const surfaces::Ring& shape, VolumeType type) {
  MeshedBody body = meshed(volumes::ring(shape, type), ring);
  body.held_tag = {3};
  body.contact_tag = {1, 2};
  return body;
}

std::unique_ptr<RollingPair> pair(const surfaces::Ring& shape, VolumeType type, Ground on, int threads) {
  AnyBody body2 = HalfspaceBody{ground};
  if (on == Ground::block) {
    MeshedBody block = meshed(ground_block(ElementType::quad4), ground);
    block.held_tag = {3};
    block.contact_tag = {1, 2};
    body2 = block;
  }
  auto p = std::make_unique<RollingPair>(ring_body(shape, type), body2, threads);
  // The ring stands on its top, the ground lies above it.
  if (on == Ground::block) p->pose(2, {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {0, 0, radius});
  p->axes({0, 0, radius}, {1, 0, 0}, {0, 0, 1}).frame_from_body(1, 2);
  p->friction(mu).load(load).speed(speed);
  p->tangential_force(ROLLCON_LONGITUDINAL, force_ratio * mu * load);
  return p;
}

}  // namespace rollcon::scenes::example2
