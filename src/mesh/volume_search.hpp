#pragma once
/// Finds which volume element holds a point, with bounding boxes in a regular grid, and Newton's method inside an
/// element.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/box.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

struct VolumePoint {
  std::int64_t element = -1;
  Vec3 reference{};  ///< xi, eta, zeta
};

class VolumeSearch {
 public:
  /// Takes nodes and elements (checked), which must outlive it. Several threads may search at once.
  VolumeSearch(std::span<const Vec3> node, const VolumeElements& volume);

  /// Finds the element that holds a point; points up to 1e-6 of the element's size beyond its faces count as inside.
  /// The element that the point lies deepest in wins, then the first.
  std::optional<VolumePoint> find(const Vec3& point) const;

 private:
  std::span<const Vec3> node_;
  const VolumeElements& volume_;
  std::vector<Box> element_box_;
  Box box_;
  Vec3 cell_{};
  std::int64_t cells_[3] = {1, 1, 1};
  std::vector<std::int64_t> start_, element_;  ///< elements of each cell

  std::int64_t along(double x, std::size_t direction) const;
};

}  // namespace rollcon
