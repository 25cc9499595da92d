#include "bodies/bem/surface_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/shape.hpp"
#include "mesh/surface_geometry.hpp"
#include "support/index.hpp"

namespace rollcon::bem {
namespace {

struct Tensor {
  Vec3 row[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  Vec3 times(const Vec3& v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
  void add(const Vec3& a, const Vec3& b) {
    for (std::size_t i = 0; i < 3; ++i) row[i] = row[i] + a[i] * b;
  }
};

Vec3 three(const double* p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

Vec3 SurfaceValues::traction_at(std::int64_t element, double xi, double eta) const {
  Shape shape;
  evaluate_shape(mesh.type[at(element)], xi, eta, shape);
  Vec3 t{0, 0, 0};
  for (std::size_t k = 0; k < mesh.element(element).size(); ++k)
    t = t + shape.value[k] * three(traction.data() + 3 * (at(mesh.offset[at(element)]) + k));
  return t;
}

// A e1 and A e2 are known for orthonormal e1, e2 in the surface and its normal n; A n follows from
// t = lambda tr(A) n + (A + A^T) n, all over G.
LinearField SurfaceValues::field(std::int64_t element, double xi, double eta, const Vec3& more) const {
  Shape shape;
  evaluate_shape(mesh.type[at(element)], xi, eta, shape);
  const auto nodes = mesh.element(element);
  const Vec3& origin = mesh.node[at(nodes[0])];
  const SurfaceFrame frame = combine(mesh, element, shape, origin);
  const Vec3 n = normalized(frame.normal), e1 = normalized(frame.d_xi), e2 = cross(n, e1);
  Vec3 value{0, 0, 0}, along{0, 0, 0}, across{0, 0, 0}, t = more + traction_at(element, xi, eta);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Vec3 own = three(u.data() + 3 * at(nodes[k]));
    value = value + shape.value[k] * own;
    along = along + shape.d_xi[k] * own;
    across = across + shape.d_eta[k] * own;
  }
  const double stretch = length(frame.d_xi), shear = dot(frame.d_eta, e1), rise = dot(frame.d_eta, e2);
  const Vec3 first = 1 / stretch * along, second = 1 / rise * (across - shear * first);
  const double normal = dot(t, n), in_plane = dot(first, e1) + dot(second, e2);
  const double press = poisson / (1 - poisson) * (2 * in_plane + normal);  // lambda tr(A)
  const Vec3 out = (dot(t, e1) - dot(n, first)) * e1 + (dot(t, e2) - dot(n, second)) * e2 + 0.5 * (normal - press) * n;
  Tensor gradient;
  gradient.add(first, e1);
  gradient.add(second, e2);
  gradient.add(out, n);
  LinearField result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.u[i] = value[i];
    for (std::size_t j = 0; j < 3; ++j) result.gradient[i][j] = gradient.row[i][j];
  }
  constexpr std::size_t row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
  for (std::size_t s = 0; s < 6; ++s)
    result.stress[s] = (s < 3 ? press : 0) + gradient.row[row[s]][column[s]] + gradient.row[column[s]][row[s]];
  return result;
}

std::vector<double> smoothed_stresses(const SurfaceValues& values, const TractionBesides& more, double edge_angle) {
  const SurfaceMesh& mesh = values.mesh;
  struct Entry {
    std::int32_t node, tag;
    std::size_t place;
    Vec3 normal;
    double area;
    double stress[6];
  };
  std::vector<Entry> entries;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto at_nodes = reference_nodes(mesh.type[at(e)]);
    const double area = element_area(mesh, e);
    for (std::size_t k = 0; k < mesh.element(e).size(); ++k) {
      const std::size_t place = at(mesh.offset[at(e)]) + k;
      Entry entry{mesh.connectivity[place], mesh.tag[at(e)], place, {}, area, {}};
      entry.normal = unit_normal(mesh, e, at_nodes[k].xi, at_nodes[k].eta);
      const LinearField own = values.field(e, at_nodes[k].xi, at_nodes[k].eta, more.empty() ? Vec3{} : more[place]);
      std::copy_n(own.stress, 6, entry.stress);
      entries.push_back(entry);
    }
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.node < b.node; });
  const double least = std::cos(edge_angle * std::numbers::pi / 180) - 1e-9;
  std::vector<double> smooth(6 * mesh.connectivity.size());
  for (std::size_t first = 0, last = 0; first < entries.size(); first = last) {
    while (last < entries.size() && entries[last].node == entries[first].node) ++last;
    for (std::size_t a = first; a < last; ++a) {
      double total = 0, sum[6] = {};
      for (std::size_t b = first; b < last; ++b) {
        if (entries[a].tag != entries[b].tag || dot(entries[a].normal, entries[b].normal) < least) continue;
        total += entries[b].area;
        for (std::size_t s = 0; s < 6; ++s) sum[s] += entries[b].area * entries[b].stress[s];
      }
      for (std::size_t s = 0; s < 6; ++s) smooth[6 * entries[a].place + s] = sum[s] / total;
    }
  }
  return smooth;
}

std::vector<double> stresses_at_nodes(const SurfaceMesh& mesh, const std::vector<double>& smoothed) {
  std::vector<double> stress(6 * mesh.node.size(), 0.0), total(mesh.node.size(), 0.0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const double area = element_area(mesh, e);
    for (std::size_t k = 0; k < mesh.element(e).size(); ++k) {
      const std::size_t place = at(mesh.offset[at(e)]) + k, node = at(mesh.connectivity[place]);
      total[node] += area;
      for (std::size_t s = 0; s < 6; ++s) stress[6 * node + s] += area * smoothed[6 * place + s];
    }
  }
  for (std::size_t node = 0; node < total.size(); ++node)
    for (std::size_t s = 0; s < 6 && total[node] > 0; ++s) stress[6 * node + s] /= total[node];
  return stress;
}

void interpolate_stress(const SurfaceMesh& mesh, const std::vector<double>& smoothed, std::int64_t element, double xi,
                        double eta, double* stress) {
  Shape shape;
  evaluate_shape(mesh.type[at(element)], xi, eta, shape);
  std::fill_n(stress, 6, 0.0);
  for (std::size_t k = 0; k < mesh.element(element).size(); ++k)
    for (std::size_t s = 0; s < 6; ++s)
      stress[s] += shape.value[k] * smoothed[6 * (at(mesh.offset[at(element)]) + k) + s];
}

}  // namespace rollcon::bem
