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
  Vec3 mean{0, 0, 0};
  const auto n = static_cast<double>(volume.elements());
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    Box box = box_of(node, volume.element(e));
    // The margin is for faces of quadratic elements, which bulge beyond their nodes.
    const double margin = (is_quadratic(volume.type[at(e)]) ? 0.25 : 1e-5) * box.longest();
    for (std::size_t c = 0; c < 3; ++c) box.low[c] -= margin, box.high[c] += margin;
    element_box_.push_back(box);
    box_.add(box);
    mean = mean + (1 / n) * box.size();
  }
  for (std::size_t c = 0; c < 3; ++c) {
    cells_[c] = std::clamp(to_index(std::min(box_.size()[c] / mean[c], 256.0)), std::int64_t{1}, std::int64_t{256});
    cell_[c] = box_.size()[c] / static_cast<double>(cells_[c]);
  }
  start_.assign(at(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
  const auto each = [&](auto&& visit) {
    for (std::int64_t e = 0; e < volume.elements(); ++e) {
      std::int64_t from[3], to[3];
      for (std::size_t c = 0; c < 3; ++c)
        from[c] = along(element_box_[at(e)].low[c], c), to[c] = along(element_box_[at(e)].high[c], c);
      for (std::int64_t i = from[0]; i <= to[0]; ++i)
        for (std::int64_t j = from[1]; j <= to[1]; ++j)
          for (std::int64_t k = from[2]; k <= to[2]; ++k) visit(e, at((i * cells_[1] + j) * cells_[2] + k));
    }
  };
  each([&](std::int64_t, std::size_t cell) { ++start_[cell + 1]; });
  for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
  element_.resize(at(start_.back()));
  std::vector<std::int64_t> next(start_.begin(), start_.end() - 1);
  each([&](std::int64_t e, std::size_t cell) { element_[at(next[cell]++)] = e; });
}

std::int64_t VolumeSearch::along(double x, std::size_t direction) const {
  const std::int64_t k = to_index(std::floor((x - box_.low[direction]) / cell_[direction]));
  return std::clamp(k, std::int64_t{0}, cells_[direction] - 1);
}

std::optional<VolumePoint> VolumeSearch::find(const Vec3& point) const {
  if (!box_.holds(point)) return std::nullopt;
  const std::size_t cell = at((along(point[0], 0) * cells_[1] + along(point[1], 1)) * cells_[2] + along(point[2], 2));
  std::optional<VolumePoint> best;
  double least = tolerance;
  for (std::int64_t i = start_[cell]; i < start_[cell + 1]; ++i) {
    const std::int64_t e = element_[at(i)];
    if (!element_box_[at(e)].holds(point)) continue;
    const VolumeType type = volume_.type[at(e)];
    Vec3 r;
    if (!find_reference(type, volume_.element(e), node_, point, element_box_[at(e)].longest(), r)) continue;
    const double beyond = outside(type, r);
    if (beyond >= least) continue;
    least = beyond;
    best = VolumePoint{e, r};
  }
  return best;
}

}  // namespace rollcon
