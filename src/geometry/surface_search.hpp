#pragma once
/// Finds points on a surface mesh along a line, or nearest to a point, with bounding boxes in a tree and Newton's
/// method on curved elements.

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
  double distance = 0;  ///< distance along the (unit) direction, signed; or to the nearest point, >= 0
  Vec3 x{}, normal{};   ///< point and unit normal of the element there
};

class SurfaceSearch {
 public:
  /// Takes the elements to search; an empty list stands for all. The mesh must outlive the search. Several threads may
  /// search at once.
  SurfaceSearch(const SurfaceMesh& mesh, std::span<const std::int64_t> elements);
  ~SurfaceSearch();

  /// Intersects with the line from + t * direction (unit) at the least |t|, among the elements whose outward normal has
  /// a component along `facing`, a cosine above 1e-9 (pass the zero vector for any). Points up to 1e-9 of the element's
  /// size beyond an element's edge count as on it, so that no line slips through; they are moved to the edge. Among
  /// elements met at one place, for example at an edge, the one that looks best towards `facing` wins, then the first.
  std::optional<SurfacePoint> along(const Vec3& from, const Vec3& direction, const Vec3& facing) const;
  /// Returns the nearest point; the first wins among equally near elements.
  SurfacePoint nearest(const Vec3& point) const;
  /// Lists the elements whose bounding boxes meet the box, in ascending order; `element` is overwritten.
  void near(const Vec3& low, const Vec3& high, std::vector<std::int64_t>& element) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace rollcon
