#include "geometry/surface_search.hpp"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/surface_patch.hpp"
#include "mesh/box.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

namespace geometry = boost::geometry;
using Corner = geometry::model::point<double, 3, geometry::cs::cartesian>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Over an element's size: how far beyond its edge it is still hit, and how far apart along the line two hits count as
/// one.
constexpr double beyond_edge = 1e-9;
/// Least cosine between the normal and `facing`: walls along it do not count by rounding.
constexpr double least_cosine = 1e-9;

double distance(const Box& box, const Vec3& x) {
  Vec3 d{};
  for (std::size_t k = 0; k < 3; ++k) d[k] = std::max({box.low[k] - x[k], x[k] - box.high[k], 0.0});
  return length(d);
}

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

  struct Stretch {
    double first, last;  ///< first > last: none
  };
  /// Where the line may be within the box.
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
  /// Least |t| there; infinity: never.
  double reach(const Box& box) const {
    const auto [first, last] = within(box);
    if (first > last) return infinity;
    return std::max({first, -last, 0.0});
  }
};

}  // namespace

/// R-tree over the bounding boxes of parts of elements.
struct SurfaceSearch::Tree {
  struct Cell {
    Box box;
    std::int64_t element;
    int part;
  };
  using Boxed = std::pair<geometry::model::box<Corner>, std::uint32_t>;  ///< and its cell
  using Index = geometry::index::rtree<Boxed, geometry::index::linear<8>>;
  using Found = std::vector<std::pair<double, std::uint32_t>>;  ///< least distance, cell

  const SurfaceMesh* mesh;
  std::vector<Cell> cell;
  Index index;
  Box all;
  double near = 0;  ///< some sizes of a cell
  // The library's comparisons have tolerances of their own, made for coordinates of order one.
  Vec3 middle{0, 0, 0};
  double scale = 1;

  Tree(const SurfaceMesh& of, std::span<const std::int64_t> elements) : mesh(&of) {
    if (elements.empty())
      for (std::int64_t e = 0; e < of.elements(); ++e) add(e);
    else
      for (std::int64_t e : elements) add(e);
    for (const Cell& c : cell) {
      all.add(c.box);
      near += 2 * length(c.box.high - c.box.low) / static_cast<double>(cell.size());
    }
    if (!cell.empty()) {
      middle = 0.5 * all.low + 0.5 * all.high;
      const Vec3 half = all.high - middle;
      const double most = std::max({half[0], half[1], half[2]});
      if (most > 0) scale = std::exp2(-std::ilogb(most));
    }
    std::vector<Boxed> boxed;
    boxed.reserve(cell.size());
    for (const Cell& c : cell)
      boxed.emplace_back(geometry::model::box<Corner>(corner(c.box.low), corner(c.box.high)),
                         static_cast<std::uint32_t>(boxed.size()));
    index = Index(boxed);  // packed
  }

  void add(std::int64_t e) {
    const SurfacePatch patch(*mesh, e);
    for (int i = 0; i < patch.parts(); ++i) {
      const auto box = patch.box(patch.part(i));
      Cell c{{patch.origin() + box[0], patch.origin() + box[1]}, e, i};
      for (std::size_t k = 0; k < 3; ++k) {
        const double margin =
            2 * beyond_edge * patch.size() + 4 * epsilon * std::max(std::abs(c.box.low[k]), std::abs(c.box.high[k]));
        c.box.low[k] -= margin;
        c.box.high[k] += margin;
      }
      cell.push_back(c);
    }
  }

  Corner corner(const Vec3& x) const {
    const Vec3 r = scale * (x - middle);
    return {r[0], r[1], r[2]};
  }

  /// Cells whose box meets the geometry and whose bound(box) is at most `most`, nearest first.
  template <class Geometry, class Bound>
  Found meeting(const Geometry& shape, double most, Bound bound) const {
    std::vector<Boxed> boxed;
    index.query(geometry::index::intersects(shape), std::back_inserter(boxed));
    Found found;
    for (const Boxed& b : boxed)
      if (const double r = bound(cell[b.second].box); r < infinity && r <= most) found.emplace_back(r, b.second);
    std::sort(found.begin(), found.end());
    return found;
  }

  template <class Limit, class Visit>
  void visit_in_order(const Found& found, Limit limit, Visit visit) const {
    for (const auto& [reach, c] : found) {
      if (!(reach <= limit())) return;
      visit(cell[c]);
    }
  }

  /// Visits cells that the line may meet at |t| up to limit(), nearer ones first.
  template <class Limit, class Visit>
  void walk(const Line& line, Limit limit, Visit visit) const {
    const auto [first, last] = line.within(all);
    if (cell.empty() || first > last) return;
    const auto query = [&](double from, double to) {
      const geometry::model::segment<Corner> part(corner(line.from + from * line.direction),
                                                  corner(line.from + to * line.direction));
      const auto reach = [&](const Box& box) { return line.reach(box); };
      visit_in_order(meeting(part, infinity, reach), limit, visit);
    };
    const double pad = 0.01 * near;
    // Mostly the line starts close to the surface.
    if (first < near && last > -near) query(std::max(first, -near) - pad, std::min(last, near) + pad);
    if (limit() > near) query(first - pad, last + pad);
  }

  /// Visits cells that may be up to limit() from the point, nearer ones first but for one.
  template <class Limit, class Visit>
  void walk(const Vec3& x, Limit limit, Visit visit) const {
    std::vector<Boxed> nearest;
    index.query(geometry::index::nearest(corner(x), 1), std::back_inserter(nearest));
    if (nearest.empty()) return;
    const std::uint32_t first = nearest[0].second;
    visit(cell[first]);
    const double r = limit() * (1 + 4 * epsilon);
    const geometry::model::box<Corner> around(corner(x - Vec3{r, r, r}), corner(x + Vec3{r, r, r}));
    Found found = meeting(around, r, [&](const Box& box) { return distance(box, x); });
    std::erase_if(found, [first](const auto& f) { return f.second == first; });
    visit_in_order(found, limit, visit);
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
SurfaceSearch::SurfaceSearch(SurfaceSearch&&) noexcept = default;
SurfaceSearch& SurfaceSearch::operator=(SurfaceSearch&&) noexcept = default;

std::optional<SurfacePoint> SurfaceSearch::along(const Vec3& from, const Vec3& direction, const Vec3& facing) const {
  const Line line(from, direction);
  const Vec3 side = normalized(facing);
  const bool any = dot(side, side) == 0;
  std::optional<SurfacePoint> best;
  double tie = 0;  // hits at one place: their distances differ by no more
  auto better = [&](const SurfacePoint& hit) {
    if (!best) return true;
    if (std::abs(hit.distance - best->distance) > tie) return std::abs(hit.distance) < std::abs(best->distance);
    // At an edge: the element that looks best towards `facing`, else the first.
    const double gain = dot(hit.normal, side) - dot(best->normal, side);
    if (std::abs(gain) > 1e-6) return gain > 0;
    return hit.element < best->element;
  };
  std::vector<ReferencePoint> found;
  tree_->walk(
      line, [&] { return best ? std::abs(best->distance) + tie : infinity; },
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
  tree_->walk(
      point, [&] { return best.distance; },
      [&](const Tree::Cell& cell) {
        const SurfacePatch patch(*tree_->mesh, cell.element);
        const Vec3 x = point - patch.origin();
        const ReferencePoint p = patch.nearest(patch.part(cell.part), x);
        const double distance = length(patch.at(p.xi, p.eta).x - x);
        const double tie = 1e-14 * patch.size();
        if (distance > best.distance + tie || (distance > best.distance - tie && cell.element >= best.element)) return;
        best = tree_->point(patch, cell.element, p);
        best.distance = distance;
      });
  return best;
}

void SurfaceSearch::near(const Vec3& low, const Vec3& high, std::vector<std::int64_t>& element) const {
  element.clear();
  const geometry::model::box<Corner> box(tree_->corner(low), tree_->corner(high));
  for (const auto& [zero, c] : tree_->meeting(box, 0, [](const Box&) { return 0.0; }))
    element.push_back(tree_->cell[c].element);
  std::sort(element.begin(), element.end());
  element.erase(std::unique(element.begin(), element.end()), element.end());
}

}  // namespace rollcon
