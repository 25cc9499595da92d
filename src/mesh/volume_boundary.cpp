#include "mesh/volume_boundary.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "mesh/volume_faces.hpp"
#include "mesh/volume_shape.hpp"

namespace rollcon {

std::array<std::int32_t, 4> sorted_corners(std::span<const std::int32_t> corner) {
  std::array<std::int32_t, 4> sorted{-1, -1, -1, -1};
  for (std::size_t i = 0; i < corner.size(); ++i) {
    std::size_t k = i;
    for (; k > 0 && sorted[k - 1] > corner[i]; --k) sorted[k] = sorted[k - 1];
    sorted[k] = corner[i];
  }
  return sorted;
}

std::array<std::int32_t, 8> face_nodes(const VolumeElements& volume, const BoundaryFace& face) {
  const auto nodes = volume.element(face.element);
  const VolumeFace& f =
      faces_of(volume.type[static_cast<std::size_t>(face.element)])[static_cast<std::size_t>(face.side)];
  std::array<std::int32_t, 8> result{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(node_count(f.type)); ++i)
    result[i] = nodes[static_cast<std::size_t>(f.node[i])];
  return result;
}

std::vector<CornerFace> sorted_faces(const VolumeElements& volume) {
  // Faces are counted into the lists of their lowest corners, which are short, and sorted there.
  const std::int32_t most =
      volume.connectivity.empty() ? -1 : *std::max_element(volume.connectivity.begin(), volume.connectivity.end());
  std::vector<std::size_t> next(static_cast<std::size_t>(most) + 2, 0);
  std::vector<CornerFace> all;
  all.reserve(6 * static_cast<std::size_t>(volume.elements()));
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    const auto nodes = volume.element(e);
    const auto sides = faces_of(volume.type[static_cast<std::size_t>(e)]);
    for (std::size_t s = 0; s < sides.size(); ++s) {
      std::array<std::int32_t, 4> corner{};
      const auto corners = static_cast<std::size_t>(corner_count(sides[s].type));
      for (std::size_t i = 0; i < corners; ++i) corner[i] = nodes[static_cast<std::size_t>(sides[s].node[i])];
      all.push_back({sorted_corners({corner.data(), corners}), {e, static_cast<std::int32_t>(s)}});
      ++next[static_cast<std::size_t>(all.back().corner[0]) + 1];
    }
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::size_t> start = next;
  std::vector<CornerFace> sorted(all.size());
  for (const CornerFace& f : all) sorted[next[static_cast<std::size_t>(f.corner[0])]++] = f;
  for (std::size_t k = 0; k + 1 < start.size(); ++k)
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(start[k]),
              sorted.begin() + static_cast<std::ptrdiff_t>(start[k + 1]), [](const CornerFace& a, const CornerFace& b) {
                return std::tie(a.corner, a.of.element, a.of.side) < std::tie(b.corner, b.of.element, b.of.side);
              });
  return sorted;
}

std::vector<BoundaryFace> boundary_faces(const VolumeElements& volume) {
  std::vector<BoundaryFace> boundary;
  const std::vector<CornerFace> faces = sorted_faces(volume);
  for_each_face(faces, [&](std::span<const CornerFace> same) {
    if (same.size() == 1) boundary.push_back(same[0].of);
  });
  std::sort(boundary.begin(), boundary.end(), [](const BoundaryFace& a, const BoundaryFace& b) {
    return std::tie(a.element, a.side) < std::tie(b.element, b.side);
  });
  return boundary;
}

SurfaceMesh boundary_surface(const VolumeElements& volume, std::span<const BoundaryFace> face) {
  SurfaceMesh surface;
  surface.tag.assign(face.size(), 0);
  surface.type.reserve(face.size());
  surface.offset.reserve(face.size() + 1);
  surface.offset.push_back(0);
  surface.connectivity.reserve(8 * face.size());
  for (const BoundaryFace& f : face) {
    const ElementType type =
        faces_of(volume.type[static_cast<std::size_t>(f.element)])[static_cast<std::size_t>(f.side)].type;
    const auto nodes = face_nodes(volume, f);
    surface.type.push_back(type);
    surface.connectivity.insert(surface.connectivity.end(), nodes.begin(), nodes.begin() + node_count(type));
    surface.offset.push_back(static_cast<std::int64_t>(surface.connectivity.size()));
  }
  return surface;
}

}  // namespace rollcon
