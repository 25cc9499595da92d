#include "geometry/surface_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/surface_patch.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Both bounds are over an element's size: how far beyond its edge it is still hit, and how far apart along the line
/// two hits count as one.
constexpr double beyond_edge = 1e-9;
/// The least cosine between the normal and `facing` keeps walls along it from counting by rounding.
constexpr double least_cosine = 1e-9;

double distance(const Box& box, const Vec3& x) {
  Vec3 d{};
  for (std::size_t k = 0; k < 3; ++k) d[k] = std::max({box.low[k] - x[k], x[k] - box.high[k], 0.0});
  return length(d);
}

struct Line {
  Vec3 from, direction, a, b;  ///< two unit vectors a, b normal to the direction and to one another

  Line(const Vec3& from_, const Vec3& direction_) : from(from_), direction(direction_) {
    std::size_t least = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(direction[k]) < std::abs(direction[least])) least = k;
    Vec3 axis{0, 0, 0};
    axis[least] = 1;
    a = normalized(cross(direction, axis));
    b = normalized(cross(direction, a));
  }

  struct Stretch {
    double first, last;  ///< no stretch if first > last
  };
  /// Returns where the line may be within the box.
  Stretch within(const Box& box) const {
    double first = -infinity, last = infinity;
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = box.low[k] - from[k], high = box.high[k] - from[k];
      if (direction[k] == 0) {
        if (low > 0 || high < 0) return {infinity, -infinity};
        continue;
      }
      const double s = low / direction[k], t = high / direction[k];
      first = std::max(first, std::min(s, t));
      last = std::min(last, std::max(s, t));
    }
    const double slack = 8 * epsilon * std::max(std::abs(first), std::abs(last));
    return {first - slack, last + slack};
  }
  /// Returns the least |t| of the line within the box.
  double reach(const Box& box) const {
    const auto [first, last] = within(box);
    if (first > last) return BoxTree::missed;
    return std::max({first, -last, 0.0});
  }
};

}  // namespace

/// Holds boxes around parts of elements in a tree.
struct SurfaceSearch::Tree {
  struct Cell {
    std::int64_t element;
    int part;
  };

  const SurfaceMesh* mesh;
  std::vector<Cell> cell;
  BoxTree box;

  Tree(const SurfaceMesh& of, std::span<const std::int64_t> elements) : mesh(&of) {
    if (elements.empty())
      for (std::int64_t e = 0; e < of.elements(); ++e) add(e);
    else
      for (std::int64_t e : elements) add(e);
    box.build();
  }

  void add(std::int64_t e) {
    const SurfacePatch patch(*mesh, e);
    for (int i = 0; i < patch.parts(); ++i) {
      const auto [low, high] = patch.box(patch.part(i));
      Box around{patch.origin() + low, patch.origin() + high};
      for (std::size_t k = 0; k < 3; ++k) {
        const double margin =
            2 * beyond_edge * patch.size() + 4 * epsilon * std::max(std::abs(around.low[k]), std::abs(around.high[k]));
        around.low[k] -= margin;
        around.high[k] += margin;
      }
      box.add(around);
      cell.push_back({e, i});
    }
  }

  template <class Reach, class Limit, class Visit>
  void walk(const Reach& reach, const Limit& limit, const Visit& visit) const {
    box.walk(reach, limit, [&](std::int64_t k) { visit(cell[static_cast<std::size_t>(k)]); });
  }

  SurfacePoint point(const SurfacePatch& patch, std::int64_t element, const ReferencePoint& p) const {
    const auto d = patch.at(p.xi, p.eta);
    SurfacePoint result;
    result.element = element;
    result.xi = p.xi;
    result.eta = p.eta;
    result.x = patch.origin() + d.x;
    result.normal = normalized(cross(d.u, d.v));
    return result;
  }
};

SurfaceSearch::SurfaceSearch(const SurfaceMesh& mesh, std::span<const std::int64_t> elements)
    : tree_(std::make_unique<Tree>(mesh, elements)) {}
SurfaceSearch::~SurfaceSearch() = default;

std::optional<SurfacePoint> SurfaceSearch::along(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const Line line(from, direction);
  const Vec3 side = normalized(facing);
  const bool any = dot(side, side) == 0;
  std::optional<SurfacePoint> best;
  double tie = 0;  // hits at one place: their distances differ by no more
  auto better = [&](const SurfacePoint& hit) {
    if (!best) return true;
    if (std::abs(hit.distance - best->distance) > tie) return std::abs(hit.distance) < std::abs(best->distance);
    // The element at an edge that looks best towards `facing` wins, else the first.
    const double gain = dot(hit.normal, side) - dot(best->normal, side);
    if (std::abs(gain) > 1e-6) return gain > 0;
    return hit.element < best->element;
  };
  std::vector<ReferencePoint> found;
  tree_->walk([&](const Box& box) { return line.reach(box); },
              [&] { return best ? std::abs(best->distance) + tie : infinity; },
              [&](const Tree::Cell& cell) {
                const SurfacePatch patch(*tree_->mesh, cell.element);
                const Vec3 start = from - patch.origin();
                found.clear();
                patch.meet(patch.part(cell.part), start, line.a, line.b, beyond_edge * patch.size(), found);
                for (const ReferencePoint& p : found) {
                  SurfacePoint hit = tree_->point(patch, cell.element, p);
                  if (!any && dot(hit.normal, side) <= least_cosine) continue;
                  hit.distance = dot(direction, patch.at(p.xi, p.eta).x - start);
                  tie = std::max(tie, beyond_edge * patch.size());
                  if (better(hit)) best = hit;
                }
              });
  return best;
}

SurfacePoint SurfaceSearch::nearest(const Vec3& point) const {
  SurfacePoint best;
  best.distance = infinity;
  tree_->walk([&](const Box& box) { return distance(box, point); }, [&] { return best.distance; },
              [&](const Tree::Cell& cell) {
                const SurfacePatch patch(*tree_->mesh, cell.element);
                const Vec3 x = point - patch.origin();
                const ReferencePoint p = patch.nearest(patch.part(cell.part), x);
                const double distance = length(patch.at(p.xi, p.eta).x - x);
                const double tie = 1e-14 * patch.size();
                if (distance > best.distance + tie || (distance > best.distance - tie && cell.element >= best.element))
                  return;
                best = tree_->point(patch, cell.element, p);
                best.distance = distance;
              });
  return best;
}

void SurfaceSearch::near(const Vec3& low, const Vec3& high, std::vector<std::int64_t>& element) const {
  element.clear();
  const auto reach = [&](const Box& box) {
    for (std::size_t k = 0; k < 3; ++k)
      if (box.low[k] > high[k] || box.high[k] < low[k]) return BoxTree::missed;
    return 0.0;
  };
  tree_->walk(
      reach, [] { return 0.0; }, [&](const Tree::Cell& cell) { element.push_back(cell.element); });
  std::sort(element.begin(), element.end());
  element.erase(std::unique(element.begin(), element.end()), element.end());
}

}  // namespace rollcon
