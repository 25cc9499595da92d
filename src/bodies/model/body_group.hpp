#pragma once
/// What the file of a body's mesh calls by one name.

#include <cstdint>
#include <string>
#include <vector>

#include "bodies/model/body_mesh.hpp"

namespace rollcon {

struct BodyGroup {
  std::string name;
  std::vector<std::int32_t> node;     ///< all nodes of what it has, ascending
  std::vector<std::int32_t> element;  ///< of the volume, or, of a body without, of the surface
  std::vector<FaceNaming> naming;     ///< faces of a volume
};

}  // namespace rollcon
