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

/// Numbers and names as the caller knows them.
struct Names {
  const VolumeElements& volume;
  std::int32_t base;

  long long node(std::int32_t k) const { return static_cast<long long>(k) + base; }
  long long element(std::int64_t e) const { return static_cast<long long>(e) + base; }
  const char* type(std::int64_t e) const { return name(volume.type[static_cast<std::size_t>(e)]); }
  std::string corners(const CornerFace& f) const {
    std::string text;
    for (std::int32_t k : f.corner)
      if (k >= 0) {
        if (!text.empty()) text += '-';
        text += std::to_string(node(k));
      }
    return text;
  }
};

void check_elements(std::int64_t nodes, const VolumeElements& volume, const Names& names) {
  Tally range, repeated;
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    const auto of = volume.element(e);
    const auto out =
        std::find_if(of.begin(), of.end(), [nodes](std::int32_t k) { return k < 0 || k >= nodes; });
    if (out != of.end())
      range.add("element %lld (%s), node %lld of %d..%lld", names.element(e), names.type(e),
                names.node(*out), names.base, static_cast<long long>(nodes) - 1 + names.base);
    for (std::size_t i = 1; i < of.size(); ++i) {
      const auto end = of.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::find(of.begin(), end, of[i]) == end) continue;
      repeated.add("element %lld (%s), node %lld", names.element(e), names.type(e),
                   names.node(of[i]));
      break;
    }
  }
  range.fail_if_any("an element refers to a node that does not exist", where, names.base);
  repeated.fail_if_any("a node is repeated within an element", where, names.base);
}

/// The same corners are the same element, whatever its order of interpolation.
void check_repeated_elements(const VolumeElements& volume, const Names& names) {
  std::vector<std::pair<std::array<std::int32_t, 8>, std::int64_t>> corners;
  corners.reserve(volume.type.size());
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    std::array<std::int32_t, 8> corner;
    corner.fill(-1);
    std::copy_n(volume.element(e).begin(), corner_count(volume.type[static_cast<std::size_t>(e)]),
                corner.begin());
    std::sort(corner.begin(), corner.end());
    corners.emplace_back(corner, e);
  }
  std::sort(corners.begin(), corners.end());
  Tally twice;
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (corners[i - 1].first == corners[i].first)
      twice.add("elements %lld and %lld", names.element(corners[i - 1].second),
                names.element(corners[i].second));
  twice.fail_if_any("the same element is given twice", where, names.base);
}

void check_nodes_used(std::size_t nodes, const VolumeElements& volume, const Names& names) {
  std::vector<char> used(nodes, 0);
  for (std::int32_t k : volume.connectivity) used[static_cast<std::size_t>(k)] = 1;
  Tally unused;
  for (std::size_t k = 0; k < used.size(); ++k)
    if (!used[k]) unused.add("node %lld", names.node(static_cast<std::int32_t>(k)));
  unused.fail_if_any("a node belongs to no element", where, names.base);
}

/// Midside nodes that are corners elsewhere: there a quadratic element lies on shorter ones.
void check_midside_nodes(std::size_t nodes, const VolumeElements& volume, const Names& names) {
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
        halved.add("node %lld of element %lld (%s), a corner of element %lld (%s)", names.node(k),
                   names.element(e), names.type(e), names.element(other), names.type(other));
  }
  halved.fail_if_any(
      "a midside node of one element is a corner of another: elements on both sides of a face must "
      "share all of its nodes",
      where, names.base);
}

enum class Match { same, midsides, own_side, twisted };

/// Of two faces with the same corners.
Match match_faces(const VolumeElements& volume, const CornerFace& f, const CornerFace& g) {
  const auto a = face_nodes(volume, f.of), b = face_nodes(volume, g.of);
  const std::size_t n = f.corner[3] < 0 ? 3 : 4;
  const auto start = static_cast<std::size_t>(
      std::find(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(n), a[0]) - b.begin());
  bool forward = true, backward = true, midsides = true;
  const auto type_of = [&](const CornerFace& h) {
    return volume.type[static_cast<std::size_t>(h.of.element)];
  };
  if (is_quadratic(type_of(f)) != is_quadratic(type_of(g))) midsides = false;
  for (std::size_t i = 0; i < n; ++i) {
    forward = forward && a[i] == b[(start + i) % n];
    backward = backward && a[i] == b[(start + n - i) % n];
    // The edge from corner i to the next one is run through the other way.
    if (midsides && is_quadratic(type_of(f)))
      midsides = a[n + i] == b[n + (start + 2 * n - i - 1) % n];
  }
  if (backward) return midsides ? Match::same : Match::midsides;
  return forward ? Match::own_side : Match::twisted;
}

/// Faces on the boundary: quadrilaterals three of whose corners are those of a triangle there.
void check_halved_faces(std::span<const CornerFace> boundary, const Names& names) {
  Tally halved;
  for (const CornerFace& f : boundary) {
    if (f.corner[3] < 0) continue;
    for (std::size_t skip = 0; skip < 4; ++skip) {
      std::array<std::int32_t, 4> triangle{-1, -1, -1, -1};
      for (std::size_t i = 0, k = 0; i < 4; ++i)
        if (i != skip) triangle[k++] = f.corner[i];
      const auto at = std::lower_bound(
          boundary.begin(), boundary.end(), triangle,
          [](const CornerFace& a, const std::array<std::int32_t, 4>& b) { return a.corner < b; });
      if (at == boundary.end() || at->corner != triangle) continue;
      halved.add("face %s of element %lld (%s) on element %lld (%s)", names.corners(f).c_str(),
                 names.element(f.of.element), names.type(f.of.element),
                 names.element(at->of.element), names.type(at->of.element));
      break;
    }
  }
  halved.fail_if_any(
      "a quadrilateral face lies on triangles of its neighbours: elements on both sides of a face "
      "must share all of its nodes",
      where, names.base);
}

void check_faces(const VolumeElements& volume, std::span<const CornerFace> faces,
                 const Names& names) {
  Tally crowded, overlapping, twisted, differ;
  std::vector<CornerFace> boundary;
  for_each_face(faces, [&](std::span<const CornerFace> same) {
    const CornerFace &f = same.front(), &g = same.back();
    if (same.size() == 1) boundary.push_back(f);
    if (same.size() > 2)
      crowded.add("face %s of %lld elements (%lld, %lld, %lld%s)", names.corners(f).c_str(),
                  static_cast<long long>(same.size()), names.element(same[0].of.element),
                  names.element(same[1].of.element), names.element(same[2].of.element),
                  same.size() > 3 ? ", ..." : "");
    if (same.size() != 2) return;
    const Match match = match_faces(volume, f, g);
    if (match == Match::same) return;
    Tally& tally = match == Match::midsides   ? differ
                   : match == Match::own_side ? overlapping
                                              : twisted;
    tally.add("face %s of elements %lld (%s) and %lld (%s)", names.corners(f).c_str(),
              names.element(f.of.element), names.type(f.of.element), names.element(g.of.element),
              names.type(g.of.element));
  });
  crowded.fail_if_any("more than two elements share a face", where, names.base);
  overlapping.fail_if_any("two elements overlap: they lie on the same side of a face they share",
                          where, names.base);
  twisted.fail_if_any("two elements share the corners of a face but not its edges", where,
                      names.base);
  differ.fail_if_any("two elements share a face but not its midside nodes", where, names.base);
  check_halved_faces(boundary, names);
}

void check_connected(const VolumeElements& volume, std::span<const CornerFace> faces,
                     const Names& names) {
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
    fail(
        Status::err_mesh,
        "the volume consists of %lld parts that share no face; join them by common nodes or give "
        "each its own body; first element of the second part: element %lld (%s) (counting from %d)",
        parts, names.element(second), names.type(second), names.base);
}

}  // namespace

void check_volume(std::span<const Vec3> node, const VolumeElements& volume,
                  std::int32_t index_base) {
  const Names names{volume, index_base};
  if (volume.elements() == 0) fail(Status::err_mesh, "the volume has no elements");
  check_elements(static_cast<std::int64_t>(node.size()), volume, names);
  check_repeated_elements(volume, names);
  check_nodes_used(node.size(), volume, names);
  const std::vector<double> nearest = check_shapes(node, volume, index_base);
  check_coinciding_nodes(node, nearest, index_base, where);
  const std::vector<CornerFace> faces = sorted_faces(volume);
  check_midside_nodes(node.size(), volume, names);
  check_faces(volume, faces, names);
  check_connected(volume, faces, names);
}

}  // namespace rollcon
