#pragma once
/// Splits elements of a mesh into runs of one type and tag, with one call of rollcon_body_add_elements each, so that
/// their order stays.

#include <cstddef>
#include <cstdint>

namespace rollcon {

/// Calls add(type, tag, count, connectivity) for each run of a SurfaceMesh or VolumeElements.
template <class Mesh, class Add>
void for_runs(const Mesh& mesh, Add add) {
  const auto same = [&](std::int64_t a, std::int64_t b) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    return mesh.type[i] == mesh.type[j] && mesh.tag[i] == mesh.tag[j];
  };
  for (std::int64_t first = 0; first < mesh.elements();) {
    std::int64_t last = first;
    while (last < mesh.elements() && same(last, first)) ++last;
    const auto i = static_cast<std::size_t>(first);
    add(static_cast<std::int32_t>(mesh.type[i]), mesh.tag[i], last - first, mesh.element(first).data());
    first = last;
  }
}

}  // namespace rollcon
