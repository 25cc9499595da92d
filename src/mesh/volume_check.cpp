#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/coinciding_nodes.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/volume_boundary.hpp"
#include "mesh/volume_faces.hpp"
#include "mesh/volume_jacobian.hpp"
#include "mesh/volume_shape.hpp"

namespace rollcon {
namespace {

constexpr const char* where = "volume";

using Numbers = Names<VolumeElements>;

std::string corners(const Numbers& names, const CornerFace& f) {
  std::string text;
  for (const std::int32_t k : f.corner) {
    if (k < 0) continue;
    if (!text.empty()) text += '-';
    text += std::to_string(names.node(k));
  }
  return text;
}

/// Fails for midside nodes that are corners elsewhere: a quadratic element lies on shorter ones there.
void check_midside_nodes(std::size_t nodes, const VolumeElements& volume, const Numbers& names) {
  std::vector<std::int64_t> corner_of(nodes, -1);
  for (std::int64_t e = volume.elements() - 1; e >= 0; --e) {
    const int corners = corner_count(volume.type[static_cast<std::size_t>(e)]);
    for (std::int32_t k : volume.element(e).first(static_cast<std::size_t>(corners)))
      corner_of[static_cast<std::size_t>(k)] = e;
  }
  Tally halved;
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    const int corners = corner_count(volume.type[static_cast<std::size_t>(e)]);
    for (std::int32_t k : volume.element(e).subspan(static_cast<std::size_t>(corners)))
      if (const std::int64_t other = corner_of[static_cast<std::size_t>(k)]; other >= 0)
        halved.add("node %lld of element %lld (%s), a corner of element %lld (%s)", names.node(k), names.element(e),
                   names.type(e), names.element(other), names.type(other));
  }
  names.refuse(halved,
               "a midside node of one element is a corner of another: "
               "elements on both sides of a face must "
               "share all of its nodes");
}

/// Two faces with the same corners have the same midside nodes, too.
bool same_nodes(const VolumeElements& volume, const CornerFace& f, const CornerFace& g) {
  const auto a = face_nodes(volume, f.of), b = face_nodes(volume, g.of);
  return std::is_permutation(a.begin(), a.end(), b.begin());
}

/// Fails for quadrilaterals on the boundary three of whose corners are those of a triangle there.
void check_halved_faces(std::span<const CornerFace> boundary, const Numbers& names) {
  Tally halved;
  for (const CornerFace& f : boundary) {
    if (f.corner[3] < 0) continue;
    for (std::size_t skip = 0; skip < 4; ++skip) {
      std::array<std::int32_t, 4> triangle{-1, -1, -1, -1};
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != skip) triangle[k++] = f.corner[i];
      const auto at =
          std::lower_bound(boundary.begin(), boundary.end(), triangle,
                           [](const CornerFace& a, const std::array<std::int32_t, 4>& b) { return a.corner < b; });
      if (at == boundary.end() || at->corner != triangle) continue;
      halved.add("face %s of element %lld (%s) on element %lld (%s)", corners(names, f).c_str(),
                 names.element(f.of.element), names.type(f.of.element), names.element(at->of.element),
                 names.type(at->of.element));
      break;
    }
  }
  names.refuse(halved,
               "a quadrilateral face lies on triangles of its "
               "neighbours: elements on both sides of a face "
               "must share all of its nodes");
}

void check_faces(const VolumeElements& volume, std::span<const CornerFace> faces, const Numbers& names) {
  Tally crowded, differ;
  std::vector<CornerFace> boundary;
  for_each_face(faces, [&](std::span<const CornerFace> same) {
    const CornerFace &f = same.front(), &g = same.back();
    if (same.size() == 1) boundary.push_back(f);
    if (same.size() > 2)
      crowded.add("face %s of %lld elements (%lld, %lld, %lld%s)", corners(names, f).c_str(),
                  static_cast<long long>(same.size()), names.element(same[0].of.element),
                  names.element(same[1].of.element), names.element(same[2].of.element), same.size() > 3 ? ", ..." : "");
    if (same.size() == 2 && !same_nodes(volume, f, g))
      differ.add("face %s of elements %lld (%s) and %lld (%s)", corners(names, f).c_str(), names.element(f.of.element),
                 names.type(f.of.element), names.element(g.of.element), names.type(g.of.element));
  });
  names.refuse(crowded, "more than two elements share a face");
  names.refuse(differ, "two elements share a face but not its midside nodes");
  check_halved_faces(boundary, names);
}

void check_connected(const VolumeElements& volume, std::span<const CornerFace> faces, const Numbers& names) {
  std::vector<std::size_t> parent(volume.type.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for_each_face(faces, [&](std::span<const CornerFace> same) {
    if (same.size() != 2) return;
    const std::size_t i = root(static_cast<std::size_t>(same[0].of.element));
    const std::size_t j = root(static_cast<std::size_t>(same[1].of.element));
    parent[std::max(i, j)] = std::min(i, j);
  });
  // Roots are the first elements of their parts.
  long long parts = 0, second = -1;
  for (std::size_t e = 0; e < parent.size(); ++e)
    if (parent[e] == e && ++parts == 2) second = static_cast<long long>(e);
  if (parts > 1)
    fail(Status::err_mesh,
         "the volume consists of %lld parts that share no face; join them by "
         "common nodes or give "
         "each its own body; first element of the second part: element %lld "
         "(%s) (counting from %d)",
         parts, names.element(second), names.type(second), names.base);
}

}  // namespace

void check_volume(std::span<const Vec3> node, const VolumeElements& volume, std::int32_t index_base) {
  const Numbers names{volume, index_base, where};
  if (volume.elements() == 0) fail(Status::err_mesh, "the volume has no elements");
  const auto nodes = static_cast<std::int64_t>(node.size());
  check_connectivity(names, nodes);
  check_nodes_used(names, nodes);
  const std::vector<double> nearest = check_shapes(node, volume, index_base);
  check_coinciding_nodes(node, nearest, index_base, where);
  const std::vector<CornerFace> faces = sorted_faces(volume);
  check_midside_nodes(node.size(), volume, names);
  check_faces(volume, faces, names);
  check_connected(volume, faces, names);
}

}  // namespace rollcon
