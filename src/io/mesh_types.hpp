#pragma once
/// Knows the element types of mesh generators and their orders of nodes.

#include <cstdint>
#include <string_view>

namespace rollcon {

struct ForeignType {
  int given = 0;               ///< nodes that the file has for the element
  std::int32_t type = 0;       ///< number of VolumeType or ElementType; 0: a point or line
  int kept = 0;                ///< nodes that are taken, no more than given
  const int* order = nullptr;  ///< place in the file of each of rollcon's nodes; null: in the same order
};

/// Returns the type with Gmsh's number; null if rollcon has none like it.
const ForeignType* gmsh_type(std::int64_t number);

/// Returns the type with Abaqus's name, in upper case. Null stands for an element of no surface and no volume (a
/// spring, a beam, a mass), or, with `unsupported` set, for a volume that rollcon does not have.
const ForeignType* abaqus_type(std::string_view name, bool& unsupported);

}  // namespace rollcon
