#include "bodies/bem/lifted_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "bodies/bem/boundary_integrals.hpp"
#include "mesh/element_sides.hpp"
#include "mesh/surface_geometry.hpp"
#include "mesh/traction_nodes.hpp"
#include "support/index.hpp"

namespace rollcon::bem {
namespace {

/// Returns 1, x, y, x^2, x y, y^2 along and across an edge, in lengths of its surroundings.
constexpr std::size_t monomials = 6;
using Monomials = std::array<double, monomials>;
Monomials monomials_at(double x, double y) {
  return {1, x, y, x * x, x * y, y * y};
}

/// Larger sums (of weights beside the ends' halves; 0.25 to 0.5 on even meshes, half the ratio of lengths where an edge
/// has shorter neighbours) would blow up differences between neighbours: far nodes cannot tell how the edge bends.
/// Larger sums are shrunk to it, not dropped: meshes graded by whole numbers would meet a limit to the last digit, and
/// rounding would choose.
constexpr double most_weight = 2;
/// A midside node off the middle by more, in lengths of its edge, belongs to no smooth surface; it is drawn back.
constexpr double most_shift = 0.15;

/// Returns the factor that brings a value down to the most it may be.
double shrinking(double value, double most) {
  return value > most ? most / value : 1;
}

/// Returns weights w of points, by least squares, with sum w p = wanted for all monomials p, shrunk where they are
/// large. basis: values of each monomial at the points. Empty: the points do not tell.
std::vector<double> weights_for(std::array<std::vector<double>, monomials> basis, const Monomials& wanted) {
  constexpr double dependent = 1e-3, met = 1e-6;
  const std::size_t points = basis[0].size();
  const auto dot_of = [points](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < points; ++i) sum += a[i] * b[i];
    return sum;
  };
  std::vector<double> weight(points, 0.0);
  const auto original = basis;
  double scale = 0;
  for (const double value : wanted) scale = std::max(scale, std::abs(value));
  // Gram-Schmidt: each new direction adds what the sum still lacks of its monomial.
  for (std::size_t k = 0; k < monomials; ++k) {
    std::vector<double>& own = basis[k];
    const double before = std::sqrt(dot_of(own, own));
    for (int twice = 0; twice < 2; ++twice)
      for (std::size_t j = 0; j < k; ++j) {
        const double part = dot_of(basis[j], own);
        for (std::size_t i = 0; i < points; ++i) own[i] -= part * basis[j][i];
      }
    const double left = std::sqrt(dot_of(own, own));
    if (!(left > dependent * before)) {
      std::fill(own.begin(), own.end(), 0.0);
      continue;
    }
    for (double& value : own) value /= left;
    const double lacks = (wanted[k] - dot_of(weight, original[k])) / dot_of(own, original[k]);
    for (std::size_t i = 0; i < points; ++i) weight[i] += lacks * own[i];
  }
  double sum = 0;
  for (const double w : weight) sum += std::abs(w);
  bool good = true;
  for (std::size_t k = 0; k < monomials; ++k)
    good = good && std::abs(dot_of(weight, original[k]) - wanted[k]) <= met * scale;
  if (!good) return {};
  for (double& w : weight) w *= shrinking(sum, most_weight);
  return weight;
}

class Lifting {
 public:
  Lifting(const BodyMesh& mesh, double edge_angle) : surface_(mesh.surface), held_(held_elements(mesh)) {
    SurfaceMesh parts = surface_;
    for (std::size_t e = 0; e < parts.tag.size(); ++e) parts.tag[e] = held_[e];
    fans_ = split_at_edges(parts, edge_angle);
    start_.assign(surface_.node.size() + 1, 0);
    for (const std::int32_t k : surface_.connectivity) ++start_[at(k) + 1];
    for (std::size_t k = 0; k < surface_.node.size(); ++k) start_[k + 1] += start_[k];
    around_.resize(surface_.connectivity.size());
    std::vector<std::int64_t> next(start_.begin(), start_.end() - 1);
    for (std::int64_t e = 0; e < surface_.elements(); ++e)
      for (const std::int32_t k : surface_.element(e)) around_[at(next[at(k)]++)] = e;
  }

  /// Returns what the edge's middle has beyond half of each end.
  std::map<std::int32_t, double> beyond_halves(const Side& a, const Side& b) const {
    const bool smooth =
        fan_of(a.cell, a.from) == fan_of(b.cell, a.from) && fan_of(a.cell, a.to) == fan_of(b.cell, a.to);
    const bool held[] = {held_[at(a.cell)] != 0, held_[at(b.cell)] != 0};
    std::map<std::int32_t, double> sum;
    // Two held faces that meet would each move what the other holds.
    if (!smooth && held[0] && held[1]) return sum;
    std::vector<std::map<std::int32_t, double>> found;
    if (smooth || held[0] == held[1] || held[0]) found.push_back(by_face(a.cell, a.from, a.to));
    if (!smooth && (held[0] == held[1] || held[1])) found.push_back(by_face(b.cell, a.from, a.to));
    std::erase_if(found, [](const auto& weights) { return weights.empty(); });
    for (const auto& weights : found)
      for (const auto& [node, w] : weights) sum[node] += w / static_cast<double>(found.size());
    Vec3 shift{0, 0, 0};
    for (const auto& [node, w] : sum) shift = shift + w * (place(node) - place(a.from));
    const double factor = shrinking(length(shift), most_shift * length(place(a.to) - place(a.from)));
    for (auto& [node, w] : sum) w *= factor;
    return sum;
  }

 private:
  const Vec3& place(std::int32_t node) const { return surface_.node[at(node)]; }

  std::int32_t fan_of(std::int64_t e, std::int32_t node) const {
    const auto nodes = surface_.element(e);
    const auto local = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    return fans_.of[at(surface_.offset[at(e)] + local)];
  }

  /// Returns nodes of the elements that share an end of the edge and are joined smoothly to element e. (More of them,
  /// at corners of triangles where these do not tell, give worse results.)
  std::vector<std::int32_t> nodes_near(std::int64_t e, std::int32_t from, std::int32_t to) const {
    std::vector<std::int32_t> near;
    for (const std::int32_t end : {from, to}) {
      const std::int32_t fan = fan_of(e, end);
      for (std::int64_t k = start_[at(end)]; k < start_[at(end) + 1]; ++k) {
        const std::int64_t other = around_[at(k)];
        if (fan_of(other, end) != fan) continue;
        const auto nodes = surface_.element(other);
        near.insert(near.end(), nodes.begin(), nodes.end());
      }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  std::map<std::int32_t, double> by_face(std::int64_t e, std::int32_t from, std::int32_t to) const {
    const std::vector<std::int32_t> near = nodes_near(e, from, to);
    const Vec3 normal = normalized(fans_.normal[at(fan_of(e, from))] + fans_.normal[at(fan_of(e, to))]);
    const Vec3 edge = place(to) - place(from), middle = 0.5 * (place(from) + place(to));
    const Vec3 along = normalized(edge - dot(edge, normal) * normal), across = cross(normal, along);
    double reach[] = {0, 0};
    for (const std::int32_t k : near) {
      reach[0] = std::max(reach[0], std::abs(dot(place(k) - middle, along)));
      reach[1] = std::max(reach[1], std::abs(dot(place(k) - middle, across)));
    }
    if (!(reach[0] > 0 && reach[1] > 0)) return {};
    const auto values = [&](std::int32_t k) {
      const Vec3 d = place(k) - middle;
      return monomials_at(dot(d, along) / reach[0], dot(d, across) / reach[1]);
    };
    std::array<std::vector<double>, monomials> basis;
    for (const std::int32_t k : near) {
      const Monomials own = values(k);
      for (std::size_t i = 0; i < monomials; ++i) basis[i].push_back(own[i]);
    }
    const Monomials first = values(from), last = values(to);
    Monomials wanted = monomials_at(0, 0);
    for (std::size_t i = 0; i < monomials; ++i) wanted[i] -= 0.5 * (first[i] + last[i]);
    const std::vector<double> weight = weights_for(std::move(basis), wanted);
    std::map<std::int32_t, double> of_node;
    for (std::size_t i = 0; i < weight.size(); ++i) of_node[near[i]] = weight[i];
    return of_node;
  }

  const SurfaceMesh& surface_;
  std::vector<std::uint8_t> held_;
  TractionNodes fans_;
  std::vector<std::int64_t> start_, around_;  ///< elements around each node
};

}  // namespace

LiftedSurface lift(const BodyMesh& mesh, double edge_angle) {
  const SurfaceMesh& surface = mesh.surface;
  LiftedSurface lifted;
  lifted.mesh = surface;
  lifted.nodes = surface.nodes();
  const auto linear = [&](std::int64_t e) { return !is_quadratic(surface.type[at(e)]); };
  bool any = false;
  for (std::int64_t e = 0; e < surface.elements(); ++e) any = any || linear(e);
  if (!any) return lifted;

  SurfaceMesh& to = lifted.mesh;
  to.offset.assign(1, 0);
  to.connectivity.clear();
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const auto nodes = surface.element(e);
    to.connectivity.insert(to.connectivity.end(), nodes.begin(), nodes.end());
    if (linear(e)) {
      to.connectivity.insert(to.connectivity.end(), nodes.size(), -1);
      to.type[at(e)] = nodes.size() == 3 ? ElementType::tri6 : ElementType::quad8;
    }
    to.offset.push_back(static_cast<std::int64_t>(to.connectivity.size()));
  }
  const Lifting lifting(mesh, edge_angle);
  for_each_edge(sorted_sides(corner_cells(surface)), [&](const Side& a, std::size_t count) {
    if (!linear(a.cell)) return;
    std::map<std::int32_t, double> parts{{a.from, 0.5}, {a.to, 0.5}};
    if (count == 2)
      for (const auto& [node, w] : lifting.beyond_halves(a, *(&a + 1))) parts[node] += w;
    Vec3 offset{0, 0, 0};
    for (const auto& [node, w] : parts) {
      lifted.part.push_back({node, w});
      offset = offset + w * (surface.node[at(node)] - surface.node[at(a.from)]);
    }
    lifted.start.push_back(static_cast<std::int64_t>(lifted.part.size()));
    for (std::size_t s = 0; s < count; ++s) {
      const Side& side = *(&a + s);
      const auto own = side_number(surface, side);
      to.connectivity[at(to.offset[at(side.cell)] + corner_count(to.type[at(side.cell)]) + own)] =
          static_cast<std::int32_t>(to.nodes());
    }
    to.node.push_back(surface.node[at(a.from)] + offset);
  });
  return lifted;
}

LiftedColumns lift_columns(const SurfaceMesh& surface, const LiftedSurface& lifted,
                           const std::vector<std::int32_t>& column, std::int64_t columns) {
  LiftedColumns result;
  result.own = columns;
  if (lifted.start.size() == 1) {
    result.of = column;
    return result;
  }
  result.of.assign(lifted.mesh.connectivity.size(), -1);
  std::map<std::array<std::int32_t, 2>, std::int32_t> of_ends;
  for (std::int64_t e = 0; e < surface.elements(); ++e) {
    const std::size_t nodes = surface.element(e).size();
    const std::int32_t* from = column.data() + surface.offset[at(e)];
    std::int32_t* to = result.of.data() + lifted.mesh.offset[at(e)];
    std::copy(from, from + nodes, to);
    if (is_quadratic(surface.type[at(e)])) continue;
    for (std::size_t k = 0; k < nodes; ++k) {
      const std::int32_t a = from[k], b = from[(k + 1) % nodes];
      if (a < 0 && b < 0) continue;
      // Edges with one wanted end share no column: two edges of one element would overwrite each other's integrals.
      const std::array<std::int32_t, 2> ends{std::min(a, b), std::max(a, b)};
      std::int32_t& own = to[nodes + k] = static_cast<std::int32_t>(result.size());
      if (ends[0] >= 0) own = of_ends.try_emplace(ends, own).first->second;
      if (own == result.size()) result.end.push_back(ends);
    }
  }
  return result;
}

namespace {

constexpr std::size_t block = 9 * lanes;

void add(const double* from, double factor, double* to) {
  for (std::size_t i = 0; i < block; ++i) to[i] += factor * from[i];
}

}  // namespace

void fold_displacements(const LiftedSurface& lifted, double* h) {
  for (std::size_t m = 0; m + 1 < lifted.start.size(); ++m)
    for (std::int64_t k = lifted.start[m]; k < lifted.start[m + 1]; ++k)
      add(h + (at(lifted.nodes) + m) * block, lifted.part[at(k)].value, h + at(lifted.part[at(k)].of) * block);
}

void fold_tractions(const LiftedColumns& columns, double* g) {
  for (std::size_t m = 0; m < columns.end.size(); ++m)
    for (const std::int32_t end : columns.end[m])
      if (end >= 0) add(g + (at(columns.own) + m) * block, 0.5, g + at(end) * block);
}

}  // namespace rollcon::bem
