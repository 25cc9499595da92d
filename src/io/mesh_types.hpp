#pragma once
/// Element types of mesh generators and their orders of nodes.

#include <cstdint>
#include <string_view>

namespace rollcon {

struct ForeignType {
  int given = 0;               ///< nodes that the file has for it
  std::int32_t type = 0;       ///< ours: a number of VolumeType or ElementType; 0: a point or a line
  int kept = 0;                ///< nodes that we take, no more than given
  const int* order = nullptr;  ///< which of the file's is our node i; null: as they come
};

/// By Gmsh's number; null if we have none like it.
const ForeignType* gmsh_type(std::int64_t number);

/// By Abaqus's name, in upper case. Null: an element of no surface and no volume (a spring, a beam, a mass).
/// unsupported: a volume that we do not have.
const ForeignType* abaqus_type(std::string_view name, bool& unsupported);

}  // namespace rollcon
