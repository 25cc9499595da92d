#pragma once
/// Lists the element types of a contact frame. Numbers are those of rollcon.h and never change.

#include <cstdint>

namespace rollcon {

enum class ElementType : std::int32_t {
  tri3 = 203,
  tri6 = 206,
  quad4 = 214,
  quad8 = 218,
  quad9 = 219,
};

/// Returns the number of nodes. They are numbered corners first, counter-clockwise seen from the tip of the normal,
/// then the edge midpoints in that order (first between corners 0 and 1), then the centre (quad9).
constexpr int node_count(ElementType type) {
  switch (type) {
    case ElementType::tri3:
      return 3;
    case ElementType::tri6:
      return 6;
    case ElementType::quad4:
      return 4;
    case ElementType::quad8:
      return 8;
    case ElementType::quad9:
      return 9;
  }
  return 0;
}

constexpr int corner_count(ElementType type) {
  return type == ElementType::tri3 || type == ElementType::tri6 ? 3 : 4;
}

constexpr bool is_quadratic(ElementType type) {
  return type == ElementType::tri6 || type == ElementType::quad8 || type == ElementType::quad9;
}

constexpr int max_element_nodes = 9;

/// Returns true when the number is one of the enumerators above.
constexpr bool is_element_type(std::int32_t type) {
  return node_count(static_cast<ElementType>(type)) > 0;
}

}  // namespace rollcon
