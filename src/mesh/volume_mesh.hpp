#pragma once
/// Represents tetrahedra, wedges and hexahedra of a body; its nodes are held with its surface.

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/volume_type.hpp"

namespace rollcon {

/// Holds elements with 0-based nodes, ids and counts checked.
struct VolumeElements {
  std::vector<VolumeType> type;         ///< one per element
  std::vector<std::int32_t> tag;        ///< one per element: its material
  std::vector<std::int64_t> offset{0};  ///< elements + 1, into connectivity
  std::vector<std::int32_t> connectivity;

  std::int64_t elements() const { return static_cast<std::int64_t>(type.size()); }
  std::span<const std::int32_t> element(std::int64_t e) const {
    return {connectivity.data() + offset[static_cast<std::size_t>(e)],
            static_cast<std::size_t>(node_count(type[static_cast<std::size_t>(e)]))};
  }
};

}  // namespace rollcon
