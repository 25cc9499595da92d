#include "bodies/fem/assembly.hpp"

#include <algorithm>
#include <utility>

#include "mesh/surface_quadrature.hpp"
#include "mesh/volume_shape.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::fem {
namespace {

/// Lists the lower triangle by blocks of nodes: to each node its neighbours of higher number.
struct NodePattern {
  std::vector<std::int64_t> start;
  std::vector<std::int32_t> neighbour;  ///< ascending
};

NodePattern node_pattern(const VolumeElements& volume, std::int64_t nodes) {
  // Elements of each node.
  std::vector<std::int64_t> first(at(nodes) + 1, 0);
  for (const std::int32_t k : volume.connectivity) ++first[at(k) + 1];
  for (std::size_t k = 0; k < at(nodes); ++k) first[k + 1] += first[k];
  std::vector<std::int64_t> element(volume.connectivity.size()), next(first.begin(), first.end());
  for (std::int64_t e = 0; e < volume.elements(); ++e)
    for (const std::int32_t k : volume.element(e)) element[at(next[at(k)]++)] = e;

  NodePattern pattern;
  pattern.start.push_back(0);
  std::vector<std::int32_t> around;
  for (std::int64_t k = 0; k < nodes; ++k) {
    around.clear();
    for (std::int64_t i = first[at(k)]; i < first[at(k) + 1]; ++i)
      for (const std::int32_t other : volume.element(element[at(i)]))
        if (other > k) around.push_back(other);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    pattern.neighbour.insert(pattern.neighbour.end(), around.begin(), around.end());
    pattern.start.push_back(static_cast<std::int64_t>(pattern.neighbour.size()));
  }
  return pattern;
}

/// Places of the entries of a node's columns: those with the node itself first, then neighbour by neighbour, free
/// components only.
class EntryPlaces {
 public:
  EntryPlaces(const NodePattern& pattern, const Unknowns& unknowns)
      : pattern_(pattern), unknowns_(unknowns), before_(pattern.neighbour.size()) {
    for (std::size_t k = 0; k + 1 < pattern.start.size(); ++k) {
      std::int64_t sum = 0;
      for (std::int64_t i = pattern.start[k]; i < pattern.start[k + 1]; ++i) {
        before_[at(i)] = sum;
        sum += free_components(pattern.neighbour[at(i)]);
      }
    }
  }

  std::int64_t free_components(std::int64_t node) const {
    std::int64_t n = 0;
    for (std::size_t c = 0; c < 3; ++c) n += unknowns_.of[3 * at(node) + c] >= 0;
    return n;
  }
  /// Entries of neighbour `other` (> node) start this far after those of the node itself.
  std::int64_t before(std::int64_t node, std::int32_t other) const {
    const auto begin = pattern_.neighbour.begin();
    const auto found = std::lower_bound(begin + pattern_.start[at(node)], begin + pattern_.start[at(node) + 1], other);
    return before_[at(found - begin)];
  }

 private:
  const NodePattern& pattern_;
  const Unknowns& unknowns_;
  std::vector<std::int64_t> before_;
};

SparseMatrix empty_matrix(const NodePattern& pattern, const Unknowns& unknowns) {
  SparseMatrix matrix;
  matrix.begin(unknowns.count);
  for (std::size_t k = 0; k + 1 < pattern.start.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      if (unknowns.of[3 * k + c] < 0) continue;
      const auto add = [&](std::size_t node, std::size_t from) {
        for (std::size_t d = from; d < 3; ++d)
          if (unknowns.of[3 * node + d] >= 0) matrix.row.push_back(unknowns.of[3 * node + d]);
      };
      add(k, c);
      for (std::int64_t i = pattern.start[k]; i < pattern.start[k + 1]; ++i) add(at(pattern.neighbour[at(i)]), 0);
      matrix.end_column();
    }
  matrix.value.assign(matrix.row.size(), 0.0);
  return matrix;
}

void scatter(const std::vector<double>& k, std::span<const std::int32_t> nodes, const Unknowns& unknowns,
             const EntryPlaces& places, SparseMatrix& matrix) {
  const std::size_t width = 3 * nodes.size();
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = 0; b < nodes.size(); ++b) {
      const std::int32_t node = nodes[a], other = nodes[b];
      if (other < node) continue;
      const std::int64_t before = other == node ? 0 : places.before(node, other);
      std::int64_t own_left = places.free_components(node);
      for (std::size_t c = 0; c < 3; ++c) {
        const std::int64_t column = unknowns.of[3 * at(node) + c];
        if (column < 0) continue;
        std::int64_t place = matrix.start[at(column)];
        if (other != node) place += own_left + before;
        --own_left;
        for (std::size_t d = other == node ? c : 0; d < 3; ++d)
          if (unknowns.of[3 * at(other) + d] >= 0) matrix.value[at(place++)] += k[(3 * a + c) * width + 3 * b + d];
      }
    }
}

}  // namespace

Unknowns number_unknowns(const BodyMesh& mesh) {
  Unknowns unknowns;
  unknowns.of.assign(3 * mesh.held.size(), -1);
  for (std::size_t k = 0; k < mesh.held.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      if (!(mesh.held[k] >> c & 1)) unknowns.of[3 * k + c] = unknowns.count++;
  return unknowns;
}

Assembly::Assembly(const BodyMesh& mesh, std::vector<Material> material, Hex8 hex8, double reference)
    : mesh_(mesh), material_(std::move(material)), hex8_(hex8), reference_(reference) {
  for (const Spring& spring : mesh.spring)
    for (std::int64_t face = 0; face < mesh.surface.elements(); ++face)
      if (mesh.surface.tag[at(face)] == spring.tag)
        spring_[mesh.origin[at(face)].element].emplace_back(face, spring.stiffness);
}

void Assembly::add_springs(std::int64_t e, std::vector<double>& k) const {
  const auto found = spring_.find(e);
  if (found == spring_.end()) return;
  constexpr int degree = 7;
  const SurfaceMesh& surface = mesh_.surface;
  const auto nodes = mesh_.volume.element(e);
  const std::size_t width = 3 * nodes.size();
  for (const auto& [face, stiffness] : found->second) {
    std::vector<std::size_t> place;
    for (const std::int32_t n : surface.element(face))
      place.push_back(at(std::find(nodes.begin(), nodes.end(), n) - nodes.begin()));
    for (const auto& [weight, shape] : tabulated<degree>(surface.type[at(face)])) {
      const double area = weight *
                          length(combine(surface, face, shape, surface.node[at(surface.element(face)[0])]).normal) /
                          reference_;
      for (std::size_t a = 0; a < place.size(); ++a)
        for (std::size_t b = 0; b < place.size(); ++b)
          for (std::size_t c = 0; c < 3; ++c)
            k[(3 * place[a] + c) * width + 3 * place[b] + c] += area * stiffness[c] * shape.value[a] * shape.value[b];
    }
  }
}

void Assembly::element_matrix(std::int64_t e, std::vector<double>& k) const {
  const auto nodes = mesh_.volume.element(e);
  Vec3 x[max_volume_nodes];
  for (std::size_t a = 0; a < nodes.size(); ++a) x[a] = mesh_.surface.node[at(nodes[a])];
  k.resize(9 * nodes.size() * nodes.size());
  const Material& material = material_[at(e)];
  element_stiffness(mesh_.volume.type[at(e)], {x, nodes.size()}, material.poisson, k.data(), hex8_);
  for (double& v : k) v *= material.young;
  add_springs(e, k);
}

// Elements of one colour share no node: they may be added at the same time, and each entry gets its parts in the order
// of the colours.
std::vector<std::vector<std::int64_t>> Assembly::colours() const {
  const VolumeElements& volume = mesh_.volume;
  std::vector<std::vector<std::int64_t>> colour;
  std::vector<std::uint64_t> used(mesh_.held.size(), 0);  // bits of up to 64 colours, by node
  std::vector<std::int64_t> rest;
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    std::uint64_t taken = 0;
    for (const std::int32_t k : volume.element(e)) taken |= used[at(k)];
    std::size_t c = 0;
    while (c < 64 && taken >> c & 1) ++c;
    if (c == 64) {
      rest.push_back(e);  // a node of very many elements
      continue;
    }
    for (const std::int32_t k : volume.element(e)) used[at(k)] |= std::uint64_t{1} << c;
    if (colour.size() <= c) colour.resize(c + 1);
    colour[c].push_back(e);
  }
  for (const std::int64_t e : rest) colour.push_back({e});
  return colour;
}

SparseMatrix Assembly::stiffness(const Unknowns& unknowns, int threads) const {
  const NodePattern pattern = node_pattern(mesh_.volume, static_cast<std::int64_t>(mesh_.held.size()));
  const EntryPlaces places(pattern, unknowns);
  SparseMatrix matrix = empty_matrix(pattern, unknowns);
  std::vector<std::vector<double>> own(at(std::max(threads, 1)));
  for (const std::vector<std::int64_t>& elements : colours()) {
    const auto count = static_cast<std::int64_t>(elements.size());
    parallel_for(count, 64, threads, [&](std::int64_t i, int thread) {
      std::vector<double>& k = own[static_cast<std::size_t>(thread)];
      element_matrix(elements[at(i)], k);
      scatter(k, mesh_.volume.element(elements[at(i)]), unknowns, places, matrix);
    });
  }
  return matrix;
}

std::vector<double> Assembly::forces_at_supports(const std::vector<double>& u) const {
  std::vector<double> force(u.size(), 0.0), k;
  for (std::int64_t e = 0; e < mesh_.volume.elements(); ++e) {
    const auto nodes = mesh_.volume.element(e);
    if (std::none_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return mesh_.held[at(n)] != 0; })) continue;
    element_matrix(e, k);
    const std::size_t width = 3 * nodes.size();
    for (std::size_t i = 0; i < width; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < width; ++j) sum += k[i * width + j] * u[3 * at(nodes[j / 3]) + j % 3];
      force[3 * at(nodes[i / 3]) + i % 3] += sum;
    }
  }
  return force;
}

void Assembly::add_body_force(const BodyForce& load, double reference, std::vector<double>& force) const {
  const VolumeElements& volume = mesh_.volume;
  VolumeShape shape;
  for (std::int64_t e = 0; e < volume.elements(); ++e) {
    if (volume.tag[at(e)] != load.tag) continue;
    const VolumeType type = volume.type[at(e)];
    const VolumeRule rule = volume_rule(type, is_quadratic(type) ? 6 : 3);
    const auto nodes = volume.element(e);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.point[q], shape);
      Vec3 x{0, 0, 0}, d[3] = {};
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Vec3& node = mesh_.surface.node[at(nodes[k])];
        x = x + shape.value[k] * node;
        for (std::size_t a = 0; a < 3; ++a) d[a] = d[a] + shape.d[k][a] * node;
      }
      const Vec3 part = (rule.w[q] * dot(d[0], cross(d[1], d[2])) / reference) * load.at(x);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) force[3 * at(nodes[k]) + c] += shape.value[k] * part[c];
    }
  }
}

std::vector<double> Assembly::loads(double reference) const {
  std::vector<double> force(3 * mesh_.held.size(), 0.0);
  for (const BodyForce& load : mesh_.body_force) add_body_force(load, reference, force);
  add_face_loads(mesh_, reference, force);
  return force;
}

}  // namespace rollcon::fem
