#include "mesh/volume_search.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/volume_shape.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double tolerance = 1e-6;  ///< beyond faces, of the reference element

/// Returns how far the point is outside of the reference element; negative inside.
double outside(VolumeType type, const Vec3& r) {
  switch (corner_count(type)) {
    case 4:
      return std::max({-r[0], -r[1], -r[2], r[0] + r[1] + r[2] - 1});
    case 6:
      return std::max({-r[0], -r[1], r[0] + r[1] - 1, std::abs(r[2]) - 1});
    default:
      return std::max({std::abs(r[0]), std::abs(r[1]), std::abs(r[2])}) - 1;
  }
}

/// Finds the reference point by Newton's method from the middle. Returns false if it does not end, which happens far
/// from curved elements.
bool find_reference(VolumeType type, std::span<const std::int32_t> nodes, std::span<const Vec3> node, const Vec3& point,
                    double size, Vec3& r) {
  VolumeShape shape;
  r = corner_count(type) == 8 ? Vec3{0, 0, 0} : corner_count(type) == 6 ? Vec3{1. / 3, 1. / 3, 0} : Vec3{.25, .25, .25};
  for (int step = 0; step < 30; ++step) {
    evaluate_shape(type, r, shape);
    Vec3 miss = point, d[3] = {};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Vec3& x = node[at(nodes[k])];
      miss = miss - shape.value[k] * x;
      for (std::size_t a = 0; a < 3; ++a) d[a] = d[a] + shape.d[k][a] * x;
    }
    const double det = dot(d[0], cross(d[1], d[2]));
    if (det == 0) return false;
    const Vec3 change{dot(miss, cross(d[1], d[2])) / det, dot(d[0], cross(miss, d[2])) / det,
                      dot(d[0], cross(d[1], miss)) / det};
    r = r + change;
    if (!(length(r) < 10)) return false;
    if (length(change) < 1e-12 || (step > 3 && length(miss) < 1e-15 * size)) return true;
  }
  return false;
}

}  // namespace

VolumeSearch::VolumeSearch(std::span<const Vec3> node, const VolumeElements& volume) : node_(node), volume_(volume) {
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    Box box = box_of(node, volume.element(e));
    // The margin is for faces of quadratic elements, which bulge beyond their nodes.
    const double margin = (is_quadratic(volume.type[at(e)]) ? 0.25 : 1e-5) * box.longest();
    for (std::size_t c = 0; c < 3; ++c) box.low[c] -= margin, box.high[c] += margin;
    tree_.add(box);
  }
  tree_.build();
}

std::optional<VolumePoint> VolumeSearch::find(const Vec3& point) const {
  std::optional<VolumePoint> best;
  double least = tolerance;
  tree_.walk([&](const Box& box) { return box.holds(point) ? 0 : BoxTree::missed; }, [] { return 0; },
             [&](std::int64_t e) {
               const VolumeType type = volume_.type[at(e)];
               const auto nodes = volume_.element(e);
               Vec3 r;
               if (!find_reference(type, nodes, node_, point, box_of(node_, nodes).longest(), r)) return;
               const double beyond = outside(type, r);
               if (beyond > least || (beyond == least && (!best || e > best->element))) return;
               least = beyond;
               best = VolumePoint{e, r};
             });
  return best;
}

}  // namespace rollcon
