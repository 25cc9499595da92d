#pragma once
/// Holds what the file of a body's mesh calls by one name.

#include <cstdint>
#include <string>
#include <vector>

#include "bodies/model/body_mesh.hpp"

namespace rollcon {

struct BodyGroup {
  std::string name;
  std::vector<std::int32_t> node;     ///< nodes of all that the group has, ascending
  std::vector<std::int32_t> element;  ///< elements of the volume, or of the surface where there is none
  std::vector<FaceNaming> naming;     ///< named faces of a volume
};

}  // namespace rollcon
