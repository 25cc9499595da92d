#include "meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/graded_disc.hpp"

namespace rollcon::bench {

SurfaceMesh frame_over(const FrameKind& kind, int across, double a, double b, double reach) {
  if (kind.rings) return scenes::graded_disc(a, b, is_quadratic(kind.type) ? across / 4 : across / 2, kind.type);
  const int steps = 2 * static_cast<int>(std::ceil(0.5 * across * reach - 1e-9));
  const double half = static_cast<double>(steps) / across;
  const auto lines = frames::uniform_lines(-half, half, is_quadratic(kind.type) ? steps / 2 : steps);
  return frames::stretch(frames::rectangle(kind.type, lines, lines), a, b);
}

std::vector<BodyKind> boundary_elements() {
  std::vector<BodyKind> kinds;
  for (const ElementType type :
       {ElementType::quad4, ElementType::tri3, ElementType::quad8, ElementType::quad9, ElementType::tri6})
    kinds.push_back({surfaces::name_of(type), false, is_quadratic(type), type, {}});
  return kinds;
}

std::vector<BodyKind> finite_elements() {
  std::vector<BodyKind> kinds;
  for (const VolumeType type : {VolumeType::hex8, VolumeType::wedge6, VolumeType::tet4, VolumeType::hex20,
                                VolumeType::wedge15, VolumeType::tet10})
    kinds.push_back({volumes::name_of(type), true, is_quadratic(type), {}, type});
  return kinds;
}

scenes::MeshedBody meshed_block(const surfaces::Block& shape, const BodyKind& kind, const scenes::Elastic& material) {
  if (kind.volume) return scenes::meshed(volumes::block(shape, kind.volume_type), material);
  return scenes::meshed(surfaces::block(shape, kind.surface_type), material);
}

scenes::MeshedBody meshed_ring(const surfaces::Ring& shape, const BodyKind& kind, const scenes::Elastic& material) {
  if (kind.volume) return scenes::meshed(volumes::ring(shape, kind.volume_type), material);
  return scenes::meshed(surfaces::ring(shape, kind.surface_type), material);
}

surfaces::Ring ring_shape(double zone, int parts, bool volume) {
  surfaces::Ring shape;
  shape.zone = zone;
  shape.zone_around = shape.across = parts;
  const int rest = 2 * std::max(7, parts);
  shape.around = parts + rest;
  shape.deep = volume ? std::max(4, parts) : std::max(3, parts / 3);
  shape.top_layer = volume ? zone / parts : std::max(1.2, zone / parts);
  // A lower bound makes a few of them leap to it.
  shape.largest = std::max(40.0, 4 * std::numbers::pi * shape.outer / rest);
  return shape;
}

scenes::MeshedBody meshed_zone_block(const surfaces::ZoneBlock& shape, const BodyKind& kind,
                                     const scenes::Elastic& material) {
  if (kind.volume) return scenes::meshed(volumes::zone_block(shape, kind.volume_type), material);
  return scenes::meshed(surfaces::zone_block(shape, kind.surface_type), material);
}

SurfaceMesh graded_strip(double a, double width, int lines) {
  std::vector<double> x = frames::cosine_lines(a, lines);
  const std::vector<double> y = frames::cosine_lines(width / 2, lines / 2);
  const double step = x[1] - x[0];
  x.insert(x.begin(), {x[0] - 3 * step, x[0] - step});
  x.insert(x.end(), {x.back() + step, x.back() + 3 * step});
  return frames::rectangle(ElementType::quad4, x, y);
}

std::vector<double> lines_with_zone(double half, int parts, int beyond, double end) {
  const double h = 2 * half / parts;
  std::vector<double> line = surfaces::graded_to(beyond, -end, -half, h);
  for (int k = 1; k < parts; ++k) line.push_back(-half + k * h);
  const auto rest = surfaces::graded(beyond, half, end, h);
  line.insert(line.end(), rest.begin(), rest.end());
  return line;
}

}  // namespace rollcon::bench
