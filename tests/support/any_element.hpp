#pragma once
/// Names elements of either model, for tests that boundary and finite elements must pass alike.

#include <string>
#include <variant>
#include <vector>

#include "build_info.hpp"
#include "support/volume_meshes.hpp"

namespace rollcon {

/// Names an element of a body's surface (boundary elements) or of its volume (finite elements).
using AnyElement = std::variant<ElementType, VolumeType>;

inline bool is_finite_element(AnyElement type) {
  return std::holds_alternative<VolumeType>(type);
}
inline bool is_quadratic_element(AnyElement type) {
  return std::visit([](auto t) { return is_quadratic(t); }, type);
}
inline std::string name_of(AnyElement type) {
  if (const auto* volume = std::get_if<VolumeType>(&type)) return volumes::name_of(*volume);
  return surfaces::name_of(std::get<ElementType>(type));
}
inline std::vector<AnyElement> all_elements() {
  std::vector<AnyElement> all(surfaces::all_types.begin(), surfaces::all_types.end());
  all.insert(all.end(), volumes::all_types.begin(), volumes::all_types.end());
  return all;
}
/// Says whether the type locks near incompressibility, where tet4 and wedge6 are refused.
inline bool locks(AnyElement type) {
  return type == AnyElement(VolumeType::tet4) || type == AnyElement(VolumeType::wedge6);
}
/// Says whether the model is left out of this build.
inline bool absent(AnyElement type) {
  return is_finite_element(type) ? ROLLCON_BUILD_FEM == 0 : ROLLCON_BUILD_BEM == 0;
}

}  // namespace rollcon
