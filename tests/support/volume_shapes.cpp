// Bodies whose elements are the images of one block's.

#include <cmath>
#include <numbers>

#include "support/frames.hpp"
#include "support/volume_meshes.hpp"

// The examples' own grading; not all that they offer is needed here.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "../../examples/ring_mesh.h"
#pragma GCC diagnostic pop

namespace rollcon::volumes {
namespace {

constexpr double pi = std::numbers::pi;

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Mesh ring(const surfaces::Ring& shape, VolumeType type) {
  Block b;
  std::vector<double> angle(at(shape.around) + 1), y(at(shape.across) + 1);
  lines_with_zone(angle.data(), shape.around, shape.sector > 0 ? shape.sector / 2 : pi, shape.zone_around,
                  shape.zone / 2 / shape.outer, shape.largest / shape.outer);
  for (int k = 0; k <= shape.across; ++k) {
    const double t = 2.0 * k / shape.across - 1;
    y[at(k)] = shape.width / 2 * (t + shape.side_grading * (std::sin(pi / 2 * t) - t));
  }
  const double layer = shape.top_layer > 0 ? shape.top_layer : (shape.outer - shape.inner) / shape.deep;
  b.line = {angle, y, surfaces::graded_to(shape.deep, shape.inner, shape.outer, layer)};
  b.ring = shape.sector <= 0;
  b.tag = {6, 7, 4, 5, 3, 1};
  b.zone_from = {(shape.around - shape.zone_around) / 2, 0};
  b.zone_to = {b.zone_from[0] + shape.zone_around, shape.across};
  b.zone_tag = 2;
  b.map = [](const Vec3& q) { return Vec3{q[2] * std::sin(q[0]), q[1], q[2] * std::cos(q[0])}; };
  return block(b, type);
}

Mesh zone_block(const surfaces::ZoneBlock& shape, VolumeType type) {
  Block b;
  const int across = shape.n + 2 * shape.grade;
  std::vector<double> line(at(across) + 1);
  lines_with_zone(line.data(), across, shape.side / 2, shape.n, shape.zone / 2, 0);
  b.line[0] = b.line[1] = line;
  b.line[2] = surfaces::graded_to(shape.deep, -shape.depth, 0, shape.zone / shape.n);
  b.tag = {4, 5, 6, 7, 3, 1};
  b.zone_from = {shape.grade, shape.grade};
  b.zone_to = {shape.grade + shape.n, shape.grade + shape.n};
  b.zone_tag = 2;
  return block(b, type);
}

Mesh cylinder(const Cylinder& shape, VolumeType type) {
  Block b;
  b.ring = shape.angle <= 0;
  const double angle = b.ring ? 2 * pi : shape.angle;
  const double first = shape.first > 0 ? shape.first : (shape.outer - shape.inner) / shape.deep;
  b.line = {frames::uniform_lines(0, angle, shape.around), frames::uniform_lines(0, shape.height, shape.along),
            surfaces::graded(shape.deep, shape.inner, shape.outer, first)};
  b.map = [](const Vec3& q) { return Vec3{q[2] * std::cos(q[0]), q[2] * std::sin(q[0]), q[1]}; };
  b.tag = {5, 6, 3, 4, 2, 1};
  return block(b, type);
}

Mesh beam(const Beam& shape, VolumeType type) {
  Block b;
  b.line = {frames::uniform_lines(0, shape.length, shape.n[0]),
            frames::uniform_lines(-shape.width / 2, shape.width / 2, shape.n[1]),
            frames::uniform_lines(-shape.height / 2, shape.height / 2, shape.n[2])};
  return block(b, type);
}

}  // namespace rollcon::volumes
