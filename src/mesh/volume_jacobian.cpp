#include "mesh/volume_jacobian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "mesh/mesh_errors.hpp"
#include "mesh/volume_shape.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Smallest Jacobian within an element over its mean.
constexpr double smallest_jacobian = 1e-6;

/// Holds in columns the derivatives of the position to xi, eta, zeta.
struct Jacobian {
  Vec3 u{0, 0, 0}, v{0, 0, 0}, w{0, 0, 0};
  double det() const { return dot(u, cross(v, w)); }
  double scale() const { return length(u) * length(v) * length(w); }
};

struct VolumePoint {
  Vec3 at;
  int node = -1;  ///< local node that lies there
  VolumeShape shape;
  std::array<double, max_volume_nodes> slope{};  ///< |grad N_i|
};

/// Holds the points where the Jacobian of one type is checked.
struct CheckPoints {
  std::vector<VolumePoint> point;
  VolumeShape centre;
  Vec3 centre_at{};
  double gradient = 0;  ///< largest sum over the nodes of |grad N_i| at a point

  explicit CheckPoints(VolumeType type) {
    // Linear tetrahedra have one Jacobian; their nodes name the place.
    const int steps = is_quadratic(type) ? 4 : corner_count(type) == 4 ? 1 : 2;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j)
        for (int k = 0; k <= steps; ++k) {
          const double x = static_cast<double>(i) / steps, y = static_cast<double>(j) / steps,
                       z = static_cast<double>(k) / steps;
          if (corner_count(type) == 8)
            add(type, {2 * x - 1, 2 * y - 1, 2 * z - 1});
          else if (corner_count(type) == 6 && i + j <= steps)
            add(type, {x, y, 2 * z - 1});
          else if (corner_count(type) == 4 && i + j + k <= steps)
            add(type, {x, y, z});
        }
    for (const Vec3& x : volume_rule(type, is_quadratic(type) ? 5 : 2).point) add(type, x);
    const auto nodes = reference_nodes(type);
    for (std::size_t i = 0; i < static_cast<std::size_t>(corner_count(type)); ++i)
      centre_at = centre_at + (1.0 / corner_count(type)) * nodes[i];
    evaluate_shape(type, centre_at, centre);
  }

 private:
  void add(VolumeType type, const Vec3& at) {
    VolumePoint p;
    p.at = at;
    const auto nodes = reference_nodes(type);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes[i] == at) p.node = static_cast<int>(i);
    evaluate_shape(type, at, p.shape);
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += p.slope[i] = length(p.shape.d[i]);
    gradient = std::max(gradient, sum);
    point.push_back(p);
  }
};

/// Holds an element's nodes relative to its first one.
struct Element {
  std::array<Vec3, max_volume_nodes> x;
  std::size_t n = 0;
  NodeExtent extent;

  Jacobian jacobian(const VolumeShape& s) const {
    Jacobian j;
    for (std::size_t i = 1; i < n; ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        j.u[c] += s.d[i][0] * x[i][c];
        j.v[c] += s.d[i][1] * x[i][c];
        j.w[c] += s.d[i][2] * x[i][c];
      }
    return j;
  }
};

Element measure(std::span<const Vec3> node, std::span<const std::int32_t> of) {
  Element e;
  for (const std::int32_t k : of) e.x[e.n++] = node[at(k)];
  e.extent = measure_nodes({e.x.data(), e.n});
  for (std::size_t i = e.n; i-- > 0;) e.x[i] = e.x[i] - e.x[0];
  return e;
}

/// Checks a cheap sufficient condition: the element differs from an affine image of the reference element by
/// displacements d_i there, so that J = J_0 (1 + sum d_i grad N_i), and the sum's norm is well below 1 at all points.
bool surely_sound(const Element& e, const CheckPoints& points, std::span<const Vec3> reference) {
  constexpr double bound = 0.9;
  const Jacobian j = e.jacobian(points.centre);
  const double det = j.det();
  if (!(det > 1e-6 * j.scale())) return false;
  // The rows a, b, c are those of the inverse.
  const Vec3 a = (1 / det) * cross(j.v, j.w), b = (1 / det) * cross(j.w, j.u), c = (1 / det) * cross(j.u, j.v);
  Vec3 centre{0, 0, 0};
  for (std::size_t i = 1; i < e.n; ++i) centre = centre + points.centre.value[i] * e.x[i];
  std::array<double, max_volume_nodes> d{};
  double largest = 0;
  for (std::size_t i = 0; i < e.n; ++i) {
    const Vec3 x = e.x[i] - centre;
    d[i] = length(Vec3{dot(a, x), dot(b, x), dot(c, x)} - (reference[i] - points.centre_at));
    largest = std::max(largest, d[i]);
  }
  if (largest * points.gradient < bound) return true;
  return std::all_of(points.point.begin(), points.point.end(), [&](const VolumePoint& p) {
    double sum = 0;
    for (std::size_t i = 0; i < e.n; ++i) sum += d[i] * p.slope[i];
    return sum < bound;
  });
}

enum class Defect { none, flat, inverted, folded };

/// Finds the defect; `worst` is the check point of the smallest Jacobian.
Defect defect_of(const Element& e, const CheckPoints& points, std::size_t& worst) {
  double mean = 0, least = std::numeric_limits<double>::infinity(), most = -least;
  bool flat = true;
  for (std::size_t p = 0; p < points.point.size(); ++p) {
    const Jacobian j = e.jacobian(points.point[p].shape);
    const double det = j.det();
    mean += det / static_cast<double>(points.point.size());
    if (det < least) least = det, worst = p;
    most = std::max(most, det);
    // Coordinates carry the rounding of their magnitude, whatever the columns' lengths.
    const double shortest = std::min({length(j.u), length(j.v), length(j.w)});
    const double noise = std::max(smallest_ratio * shortest, coordinate_rounding * e.extent.magnitude);
    flat = flat && !(std::abs(det) * shortest > noise * j.scale());
  }
  if (flat) return Defect::flat;
  if (most < 0 && most < smallest_jacobian * mean) return Defect::inverted;
  return least > smallest_jacobian * std::abs(mean) ? Defect::none : Defect::folded;
}

}  // namespace

std::vector<double> check_shapes(std::span<const Vec3> node, const VolumeElements& volume, std::int32_t index_base) {
  const Names<VolumeElements> names{volume, index_base, "volume"};
  std::vector<double> nearest(node.size(), std::numeric_limits<double>::infinity());
  std::map<VolumeType, CheckPoints> tables;
  Tally coincident, flat, inverted, folded;
  for (std::int64_t i = 0; i < volume.elements(); ++i) {
    const VolumeType type = volume.type[static_cast<std::size_t>(i)];
    const auto nodes = volume.element(i);
    const long long id = names.element(i);
    const Element e = measure(node, nodes);
    const NodeExtent& extent = e.extent;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      nearest[at(nodes[k])] = std::min(nearest[at(nodes[k])], extent.own[k]);
    const double noise = coordinate_rounding * extent.magnitude / extent.size;
    if (!(extent.nearest > std::max(smallest_ratio, noise) * extent.size)) {
      coincident.add("element %lld (%s), nodes %lld and %lld", id, name(type), names.node(nodes[extent.near_i]),
                     names.node(nodes[extent.near_j]));
      continue;
    }
    const CheckPoints& points = tables.try_emplace(type, type).first->second;
    if (surely_sound(e, points, reference_nodes(type))) continue;
    std::size_t worst = 0;
    const Defect defect = defect_of(e, points, worst);
    if (defect == Defect::flat) flat.add("element %lld (%s)", id, name(type));
    if (defect == Defect::inverted) inverted.add("element %lld (%s)", id, name(type));
    if (defect != Defect::folded) continue;
    const VolumePoint& there = points.point[worst];
    if (there.node >= 0)
      folded.add("element %lld (%s) at node %lld", id, name(type),
                 names.node(nodes[static_cast<std::size_t>(there.node)]));
    else
      folded.add("element %lld (%s) at xi = %g, eta = %g, zeta = %g", id, name(type), there.at[0], there.at[1],
                 there.at[2]);
  }
  names.refuse(coincident, "degenerate element: two of its nodes coincide");
  names.refuse(flat, "degenerate element: it has no volume");
  names.refuse(inverted,
               "element turned inside out: its Jacobian is negative; mirror "
               "the order of its nodes "
               "(exchange the bottom and the top face of wedges and hexahedra, "
               "the second and the third "
               "corner of tetrahedra, and their midside nodes with them)");
  names.refuse(folded,
               "degenerate element: its Jacobian is not positive "
               "everywhere (folded, corners of 180 degrees "
               "or more, nodes in a wrong order, or a midside node at "
               "or beyond the quarter of its edge)");
  return nearest;
}

}  // namespace rollcon
