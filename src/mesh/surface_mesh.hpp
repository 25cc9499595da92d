#pragma once
/// Represents a mesh of triangles and quadrilaterals in space: a contact frame, or the surface of a body.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/element_type.hpp"
#include "mesh/vec3.hpp"

namespace rollcon {

/// Holds what the caller gave: nodes in space and elements with 0-based nodes, ids and counts checked.
struct SurfaceMesh {
  std::vector<Vec3> node;
  std::vector<ElementType> type;  ///< one per element
  std::vector<std::int32_t> tag;  ///< one per element
  /// Holds elements + 1 places in connectivity; a new mesh starts as {0} when elements are added one by one.
  std::vector<std::int64_t> offset;
  std::vector<std::int32_t> connectivity;
  std::int32_t index_base = 0;  ///< index base of the caller, for messages only

  std::int64_t nodes() const { return static_cast<std::int64_t>(node.size()); }
  std::int64_t elements() const { return static_cast<std::int64_t>(type.size()); }
  std::span<const std::int32_t> element(std::int64_t e) const {
    return {connectivity.data() + offset[static_cast<std::size_t>(e)],
            static_cast<std::size_t>(node_count(type[static_cast<std::size_t>(e)]))};
  }
};

}  // namespace rollcon
