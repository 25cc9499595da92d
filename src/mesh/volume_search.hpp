#pragma once
/// Finds which volume element holds a point, by a tree of boxes and Newton's method within an element.

#include <cstdint>
#include <optional>
#include <span>

#include "mesh/box_tree.hpp"
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
  BoxTree tree_;
};

}  // namespace rollcon
