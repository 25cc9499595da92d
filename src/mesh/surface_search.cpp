#include "mesh/surface_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/surface_geometry.hpp"
#include "mesh/surface_patch.hpp"

namespace rollcon {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Over an element's size: how far beyond its edge it is still hit, and how far apart along the
/// line two hits count as one.
constexpr double beyond_edge = 1e-9;
/// Least cosine between the normal and `facing`: walls along it do not count by rounding.
constexpr double least_cosine = 1e-9;

struct Box {
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

  void add(const Box& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], b.low[k]);
      high[k] = std::max(high[k], b.high[k]);
    }
  }
  double distance(const Vec3& x) const {
    Vec3 d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = std::max({low[k] - x[k], x[k] - high[k], 0.0});
    return length(d);
  }
};

struct Line {
  Vec3 from, direction, a, b;  ///< a, b: unit vectors normal to the direction and to one another

  Line(const Vec3& from_, const Vec3& direction_) : from(from_), direction(direction_) {
    std::size_t least = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(direction[k]) < std::abs(direction[least])) least = k;
    Vec3 axis{0, 0, 0};
    axis[least] = 1;
    a = normalized(cross(direction, axis));
    b = normalized(cross(direction, a));
  }

  /// Least |t| at which the line may be within the box; infinity: never.
  double reach(const Box& box) const {
    double first = -infinity, last = infinity;
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = box.low[k] - from[k], high = box.high[k] - from[k];
      if (direction[k] == 0) {
        if (low > 0 || high < 0) return infinity;
        continue;
      }
      const double s = low / direction[k], t = high / direction[k];
      first = std::max(first, std::min(s, t));
      last = std::min(last, std::max(s, t));
    }
    const double slack = 8 * epsilon * std::max(std::abs(first), std::abs(last));
    if (first > last + slack) return infinity;
    if (first <= 0 && last >= 0) return 0;
    return std::max(std::min(std::abs(first), std::abs(last)) - slack, 0.0);
  }
};

}  // namespace

/// Binary tree over parts of elements; node i covers cells [begin, end), its first child follows
/// it.
struct SurfaceSearch::Tree {
  struct Cell {
    Box box;
    std::int64_t element;
    int part;
  };
  struct Node {
    Box box;
    std::size_t begin, end;
    std::size_t second = 0;  ///< 0: leaf
  };

  const SurfaceMesh* mesh;
  std::vector<Cell> cell;
  std::vector<Node> node;

  Tree(const SurfaceMesh& of, std::span<const std::int64_t> elements) : mesh(&of) {
    if (elements.empty())
      for (std::int64_t e = 0; e < of.elements(); ++e) add(e);
    else
      for (std::int64_t e : elements) add(e);
    if (!cell.empty()) build(0, cell.size());
  }

  void add(std::int64_t e) {
    const SurfacePatch patch(*mesh, e);
    for (int i = 0; i < patch.parts(); ++i) {
      const auto box = patch.box(patch.part(i));
      Cell c{{patch.origin() + box[0], patch.origin() + box[1]}, e, i};
      for (std::size_t k = 0; k < 3; ++k) {
        const double margin =
            2 * beyond_edge * patch.size() +
            4 * epsilon * std::max(std::abs(c.box.low[k]), std::abs(c.box.high[k]));
        c.box.low[k] -= margin;
        c.box.high[k] += margin;
      }
      cell.push_back(c);
    }
  }

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t self = node.size();
    Box box;
    for (std::size_t i = begin; i < end; ++i) box.add(cell[i].box);
    node.push_back({box, begin, end});
    if (end - begin <= 2) return self;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return cell.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Cell& p, const Cell& q) {
      return p.box.low[axis] + p.box.high[axis] < q.box.low[axis] + q.box.high[axis];
    });
    build(begin, middle);
    const std::size_t second = build(middle, end);
    node[self].second = second;
    return self;
  }

  /// Visits the cells whose bound(box) is at most limit(), nearer ones first.
  template <class Bound, class Limit, class Visit>
  void walk(Bound bound, Limit limit, Visit visit) const {
    if (node.empty()) return;
    // Halving: the tree is no deeper than the bits of the number of cells.
    std::pair<double, std::size_t> stack[2 * 64];
    std::size_t depth = 0;
    stack[depth++] = {bound(node[0].box), 0};
    while (depth > 0) {
      const auto [reach, i] = stack[--depth];
      if (!(reach <= limit()) || reach == infinity) continue;
      const Node& n = node[i];
      if (n.second == 0) {
        for (std::size_t c = n.begin; c < n.end; ++c)
          if (const double r = bound(cell[c].box); r < infinity && r <= limit()) visit(cell[c]);
        continue;
      }
      std::pair<double, std::size_t> near{bound(node[i + 1].box), i + 1};
      std::pair<double, std::size_t> far{bound(node[n.second].box), n.second};
      if (far.first < near.first) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
    }
  }

  SurfacePoint point(const SurfacePatch& patch, std::int64_t element,
                     const ReferencePoint& p) const {
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
SurfaceSearch::SurfaceSearch(SurfaceSearch&&) noexcept = default;
SurfaceSearch& SurfaceSearch::operator=(SurfaceSearch&&) noexcept = default;

std::optional<SurfacePoint> SurfaceSearch::along(const Vec3& from, const Vec3& direction,
                                                 const Vec3& facing) const {
  const Line line(from, direction);
  const Vec3 side = normalized(facing);
  const bool any = dot(side, side) == 0;
  std::optional<SurfacePoint> best;
  double tie = 0;  // hits at one place: their distances differ by no more
  auto better = [&](const SurfacePoint& hit) {
    if (!best) return true;
    if (std::abs(hit.distance - best->distance) > tie)
      return std::abs(hit.distance) < std::abs(best->distance);
    // At an edge: the element that looks best towards `facing`, else the first.
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
                patch.meet(patch.part(cell.part), start, line.a, line.b, beyond_edge * patch.size(),
                           found);
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
  tree_->walk([&](const Box& box) { return box.distance(point); }, [&] { return best.distance; },
              [&](const Tree::Cell& cell) {
                const SurfacePatch patch(*tree_->mesh, cell.element);
                const Vec3 x = point - patch.origin();
                const ReferencePoint p = patch.nearest(patch.part(cell.part), x);
                const double distance = length(patch.at(p.xi, p.eta).x - x);
                const double tie = 1e-14 * patch.size();
                if (distance > best.distance + tie ||
                    (distance > best.distance - tie && cell.element >= best.element))
                  return;
                best = tree_->point(patch, cell.element, p);
                best.distance = distance;
              });
  return best;
}

}  // namespace rollcon
