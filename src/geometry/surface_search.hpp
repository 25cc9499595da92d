#pragma once
/// Finds points on a surface mesh: along a line, or nearest to a point. Bounding boxes in a tree; curved elements by
/// Newton's method.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon {

struct SurfacePoint {
  std::int64_t element = -1;
  double xi = 0, eta = 0;
  double distance = 0;  ///< along the (unit) direction, signed; or to the nearest point, >= 0
  Vec3 x{}, normal{};   ///< point and unit normal of the element there
};

class SurfaceSearch {
 public:
  /// Elements to search; empty: all. The mesh must outlive the search. Safe for several threads.
  SurfaceSearch(const SurfaceMesh& mesh, std::span<const std::int64_t> elements);
  ~SurfaceSearch();

  /// Intersection with the line from + t * direction (unit) of least |t|, among those whose outward normal has a
  /// component along `facing`, a cosine above 1e-9 (pass the zero vector: any). Points up to 1e-9 of the element's size
  /// beyond an element's edge count as on it, so that no line slips through; they are moved to the edge. Of elements
  /// met at the same place, as at an edge, the one that looks best towards `facing`, then the first.
  std::optional<SurfacePoint> along(const Vec3& from, const Vec3& direction, const Vec3& facing) const;
  /// The nearest point; of equally near elements the first.
  SurfacePoint nearest(const Vec3& point) const;
  /// Elements whose bounding boxes meet the box, ascending; overwritten.
  void near(const Vec3& low, const Vec3& high, std::vector<std::int64_t>& element) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace rollcon
