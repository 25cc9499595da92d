#include "support/volume_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "mesh/volume_shape.hpp"
#include "support/frames.hpp"

namespace rollcon::volumes {
namespace {

using surfaces::at;

using Local = std::array<int, 3>;  ///< point of a cell's lattice, 0 to 2 in each direction

Local middle(const Local& a, const Local& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// Returns an element's nodes as lattice points of its cell, from those of its corners.
std::vector<Local> with_middles(VolumeType type, std::vector<Local> corner) {
  if (!is_quadratic(type)) return corner;
  std::vector<Local> all = corner;
  for (const auto& [a, b] : edges_of(type)) all.push_back(middle(corner[at(a)], corner[at(b)]));
  return all;
}

/// Returns the elements of one type that fill a cell; `other` takes the other diagonal (wedges).
std::vector<std::vector<Local>> filling_of_cell(VolumeType type, bool other) {
  std::vector<std::vector<Local>> elements;
  switch (corner_count(type)) {
    case 8:
      elements.push_back({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}});
      break;
    case 6: {
      const Local square[4] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
      for (const std::size_t first : {std::size_t{0}, std::size_t{2}}) {
        std::vector<Local> corner;
        for (const int z : {0, 2})
          for (std::size_t i = 0; i < 3; ++i) {
            Local p = square[(first + (other ? 1 : 0) + i) % 4];
            p[2] = z;
            corner.push_back(p);
          }
        elements.push_back(corner);
      }
      break;
    }
    default: {
      // Each row is an order in which the coordinates go from least to most.
      constexpr int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
      for (int k = 0; k < 6; ++k) {
        std::vector<Local> corner{{0, 0, 0}};
        for (const int axis : order[k]) {
          corner.push_back(corner.back());
          corner.back()[at(axis)] = 2;
        }
        if (k >= 3) std::swap(corner[1], corner[2]);  // odd permutations
        elements.push_back(corner);
      }
    }
  }
  for (auto& e : elements) e = with_middles(type, std::move(e));
  return elements;
}

/// Collects cells. Nodes are known by keys of four integers.
class Builder {
 public:
  using Key = std::array<int, 4>;
  std::function<Vec3(const Key&)> position;

  /// Adds a cell. The function `key` gives the key of a lattice point; side_tag holds the tags of the sides (first
  /// coordinate least, most, second ...), -1 inside the body.
  void add_cell(VolumeType type, bool other, const std::function<Key(const Local&)>& key,
                const std::array<std::int32_t, 6>& side_tag) {
    for (const auto& element : filling_of_cell(type, other)) {
      std::vector<std::int32_t> nodes;
      for (const Local& p : element) nodes.push_back(node(key(p)));
      add_element(mesh_.volume, type, nodes);
      for (const VolumeFace& f : faces_of(type))
        for (std::size_t side = 0; side < 6; ++side)
          if (side_tag[side] >= 0 && lies_on(element, f, side)) add_face(nodes, f, side_tag[side]);
    }
  }

  Mesh take() { return std::move(mesh_); }

 private:
  static bool lies_on(const std::vector<Local>& element, const VolumeFace& f, std::size_t side) {
    for (int i = 0; i < corner_count(f.type); ++i)
      if (element[at(f.node[at(i)])][side / 2] != (side % 2 == 0 ? 0 : 2)) return false;
    return true;
  }

  std::int32_t node(const Key& key) {
    const auto [place, fresh] = known_.try_emplace(key, static_cast<std::int32_t>(mesh_.surface.node.size()));
    if (fresh) mesh_.surface.node.push_back(position(key));
    return place->second;
  }

  void add_face(const std::vector<std::int32_t>& nodes, const VolumeFace& f, std::int32_t tag) {
    std::vector<std::int32_t> own;
    for (int i = 0; i < node_count(f.type); ++i) own.push_back(nodes[at(f.node[at(i)])]);
    surfaces::add_element(mesh_.surface, f.type, own, tag);
  }

  Mesh mesh_;
  std::map<Key, std::int32_t> known_;
};

/// Takes the type of the cells in column (i, j) from want(i, j).
Mesh fill(const Block& shape, const std::function<VolumeType(int, int)>& want) {
  std::array<int, 3> n{};
  for (std::size_t c = 0; c < 3; ++c) n[c] = static_cast<int>(shape.line[c].size()) - 1;
  Builder builder;
  builder.position = [&](const Builder::Key& key) {
    Vec3 q{};
    for (std::size_t c = 0; c < 3; ++c)
      q[c] = 0.5 * (shape.line[c][at(key[c] / 2)] + shape.line[c][at((key[c] + 1) / 2)]);
    return shape.map ? shape.map(q) : q;
  };
  Local cell;
  for (cell[2] = 0; cell[2] < n[2]; ++cell[2])
    for (cell[1] = 0; cell[1] < n[1]; ++cell[1])
      for (cell[0] = 0; cell[0] < n[0]; ++cell[0]) {
        std::array<std::int32_t, 6> side;
        for (std::size_t c = 0; c < 3; ++c) {
          side[2 * c] = cell[c] == 0 ? shape.tag[2 * c] : -1;
          side[2 * c + 1] = cell[c] == n[c] - 1 ? shape.tag[2 * c + 1] : -1;
        }
        if (shape.ring) side[0] = side[1] = -1;
        const auto in_zone = [&](std::size_t c) { return cell[c] >= shape.zone_from[c] && cell[c] < shape.zone_to[c]; };
        if (side[5] >= 0 && in_zone(0) && in_zone(1)) side[5] = shape.zone_tag;
        builder.add_cell(
            want(cell[0], cell[1]), (cell[0] + cell[1]) % 2 == 1,
            [&](const Local& p) {
              Builder::Key key{2 * cell[0] + p[0], 2 * cell[1] + p[1], 2 * cell[2] + p[2], 0};
              if (shape.ring && key[0] == 2 * n[0]) key[0] = 0;
              return key;
            },
            side);
      }
  return builder.take();
}

}  // namespace

void add_element(VolumeElements& volume, VolumeType type, std::span<const std::int32_t> nodes, std::int32_t tag) {
  volume.type.push_back(type);
  volume.tag.push_back(tag);
  volume.connectivity.insert(volume.connectivity.end(), nodes.begin(), nodes.end());
  volume.offset.push_back(static_cast<std::int64_t>(volume.connectivity.size()));
}

std::string name_of(VolumeType type) {
  const int corners = corner_count(type);
  return (corners == 4 ? "tet" : corners == 6 ? "wedge" : "hex") + std::to_string(node_count(type));
}

Mesh block(const Block& shape, VolumeType type) {
  return fill(shape, [type](int, int) { return type; });
}

Mesh mixed_block(const Block& shape, bool quadratic) {
  return fill(shape, [quadratic](int i, int j) {
    const bool wedge = (i + 2 * j) % 3 == 1;
    if (quadratic) return wedge ? VolumeType::wedge15 : VolumeType::hex20;
    return wedge ? VolumeType::wedge6 : VolumeType::hex8;
  });
}

Vec3 mean_corner(const Mesh& mesh, std::int64_t element) {
  const int corners = corner_count(mesh.volume.type[at(element)]);
  Vec3 mean{0, 0, 0};
  for (const std::int32_t k : mesh.volume.element(element).first(at(corners)))
    mean = mean + (1.0 / corners) * mesh.surface.node[at(k)];
  return mean;
}

Mesh with_materials(Mesh mesh, const std::function<std::int32_t(const Vec3&)>& tag) {
  for (std::int64_t e = 0; e < mesh.volume.elements(); ++e) mesh.volume.tag[at(e)] = tag(mean_corner(mesh, e));
  return mesh;
}

Mesh part_of(const Mesh& mesh, const std::function<bool(std::int64_t)>& wanted) {
  Mesh part;
  part.surface.offset.push_back(0);
  std::vector<std::int32_t> number(mesh.surface.node.size(), -1);
  for (std::int64_t e = 0; e < mesh.volume.elements(); ++e) {
    if (!wanted(e)) continue;
    for (const std::int32_t k : mesh.volume.element(e)) number[at(k)] = 0;
    add_element(part.volume, mesh.volume.type[at(e)], mesh.volume.element(e), mesh.volume.tag[at(e)]);
  }
  for (std::size_t k = 0; k < number.size(); ++k) {
    if (number[k] < 0) continue;
    number[k] = static_cast<std::int32_t>(part.surface.node.size());
    part.surface.node.push_back(mesh.surface.node[k]);
  }
  for (std::int32_t& k : part.volume.connectivity) k = number[at(k)];
  return part;
}

Mesh distort(Mesh mesh, double fraction, std::uint32_t seed) {
  std::vector<double> shortest(mesh.surface.node.size(), std::numeric_limits<double>::max());
  std::vector<std::uint8_t> corner(mesh.surface.node.size(), 0);
  const auto for_each_edge = [&mesh](auto visit) {
    for (std::int64_t e = 0; e < mesh.volume.elements(); ++e) {
      const VolumeType type = mesh.volume.type[at(e)];
      const auto n = mesh.volume.element(e);
      const auto edges = edges_of(type);
      for (std::size_t k = 0; k < edges.size(); ++k)
        visit(at(n[at(edges[k][0])]), at(n[at(edges[k][1])]), is_quadratic(type) ? n[at(corner_count(type)) + k] : -1);
    }
  };
  for_each_edge([&](std::size_t a, std::size_t b, std::int32_t mid) {
    const double edge = length(mesh.surface.node[a] - mesh.surface.node[b]);
    corner[a] = corner[b] = 1;
    shortest[a] = std::min(shortest[a], edge);
    shortest[b] = std::min(shortest[b], edge);
    if (mid >= 0) shortest[at(mid)] = std::min(shortest[at(mid)], edge);
  });
  surfaces::shake(mesh.surface.node, shortest, corner, fraction, seed, [&] {
    for_each_edge([&](std::size_t a, std::size_t b, std::int32_t mid) {
      if (mid >= 0) mesh.surface.node[at(mid)] = 0.5 * (mesh.surface.node[a] + mesh.surface.node[b]);
    });
  });
  return mesh;
}

Mesh transform(Mesh mesh, const Map& map) {
  for (Vec3& x : mesh.surface.node) x = map(x);
  return mesh;
}

Mesh ring(const surfaces::Ring& shape, VolumeType type) {
  return block(surfaces::ring_block(shape), type);
}

Mesh zone_block(const surfaces::ZoneBlock& shape, VolumeType type) {
  return block(surfaces::with_zone(shape), type);
}

Filling filling(const Mesh& mesh) {
  Filling f;
  f.least = std::numeric_limits<double>::infinity();
  std::map<VolumeType, VolumeRule> rules;
  for (std::int64_t e = 0; e < mesh.volume.elements(); ++e) {
    const VolumeType type = mesh.volume.type[at(e)];
    VolumeRule& rule = rules[type];
    // The Jacobian of hex20 is of degree 5, times the position 7.
    if (rule.size() == 0) rule = volume_rule(type, is_quadratic(type) ? 7 : 3);
    const auto n = mesh.volume.element(e);
    VolumeShape s;
    double own = 0, least = std::numeric_limits<double>::infinity(), weights = 0;
    for (std::size_t g = 0; g < rule.size(); ++g) {
      evaluate_shape(type, rule.point[g], s);
      Vec3 x{0, 0, 0}, u = x, v = x, w = x;
      for (std::size_t i = 0; i < n.size(); ++i) {
        const Vec3& y = mesh.surface.node[at(n[i])];
        x = x + s.value[i] * y;
        u = u + s.d[i][0] * y;
        v = v + s.d[i][1] * y;
        w = w + s.d[i][2] * y;
      }
      const double det = dot(u, cross(v, w));
      own += rule.w[g] * det;
      weights += rule.w[g];
      least = std::min(least, det);
      f.centroid = f.centroid + (rule.w[g] * det) * x;
    }
    f.volume += own;
    f.least = std::min(f.least, least * weights / own);
  }
  f.centroid = (1 / f.volume) * f.centroid;
  return f;
}

}  // namespace rollcon::volumes
