#pragma once
/// Makes small boxes in every element type.

#include <cstdint>
#include <vector>

namespace fuzz {

/// Is [0, 1]^3 scaled by `size`, in n[0] x n[1] x n[2] cells of a type: volume elements, or surface elements with
/// outward normals. Ids count from 0.
struct Box {
  std::int32_t type = 0;
  int per_element = 0;
  std::vector<double> x;                ///< [nodes][3]
  std::vector<std::int32_t> element;    ///< [elements][per_element]
  std::vector<std::int32_t> side;       ///< side of each surface element: 0 to 5, x, y, z from below
  std::vector<std::int32_t> at_bottom;  ///< nodes with the least z
  std::vector<std::int32_t> at_top;     ///< nodes with the greatest z

  std::int64_t nodes() const { return static_cast<std::int64_t>(x.size()) / 3; }
  std::int64_t elements() const {
    return per_element > 0 ? static_cast<std::int64_t>(element.size()) / per_element : 0;
  }
};

Box make_box(std::int32_t type, const int (&n)[3], const double (&size)[3]);

/// The element types 0 to 4 are surfaces, 5 to 10 volumes.
extern const std::int32_t element_types[11];
int nodes_of_type(std::int32_t type);

}  // namespace fuzz
