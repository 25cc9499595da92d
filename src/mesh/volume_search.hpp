#pragma once
/// Finds which volume element holds a point. Bounding boxes in a regular grid; inside an element by Newton's method.

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
  /// Nodes and elements (checked) must outlive it. Safe for several threads.
  VolumeSearch(std::span<const Vec3> node, const VolumeElements& volume);

  /// Points up to 1e-6 of the element's size beyond its faces count as inside. Of several elements the one that the
  /// point lies deepest in, then the first.
  std::optional<VolumePoint> find(const Vec3& point) const;

 private:
  std::span<const Vec3> node_;
  const VolumeElements& volume_;
  std::vector<Box> element_box_;
  Box box_;
  Vec3 cell_{};
  std::int64_t cells_[3] = {1, 1, 1};
  std::vector<std::int64_t> start_, element_;  ///< of each cell

  std::int64_t along(double x, std::size_t direction) const;
};

}  // namespace rollcon
