#include "mesh/shell_nesting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/box.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

constexpr int samples = 5;  ///< nodes asked per shell
constexpr int facets = 4;   ///< per side of an element, for the winding number

const Vec3& first_node(const SurfaceMesh& mesh, std::int64_t element) {
  return mesh.node[static_cast<std::size_t>(mesh.element(element)[0])];
}

/// Boxes of the shells' nodes, larger by half: curved elements leave the box of their nodes.
std::vector<Box> boxes(const SurfaceMesh& mesh, const Shells& shells) {
  std::vector<Box> box(shells.size());
  for (std::int64_t e = 0; e < mesh.elements(); ++e)
    box[static_cast<std::size_t>(shells.shell[static_cast<std::size_t>(e)])].add(box_of(mesh.node, mesh.element(e)));
  for (Box& b : box)
    for (std::size_t k = 0; k < 3; ++k) {
      const double margin = 0.25 * (b.high[k] - b.low[k]);
      b.low[k] -= margin;
      b.high[k] += margin;
    }
  return box;
}

/// Solid angle of a triangle seen from the origin (van Oosterom and Strackee), lengths in its own unit.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  const double y = dot(a, cross(b, c));
  const double x = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return 2 * std::atan2(y, x);
}

struct Sample {
  Vec3 x;
  std::size_t shell;
};

std::vector<Sample> sample_nodes(const SurfaceMesh& mesh, const Shells& shells) {
  std::vector<std::int64_t> size(shells.size(), 0), seen(shells.size(), 0);
  for (std::int32_t s : shells.shell) ++size[static_cast<std::size_t>(s)];
  std::vector<Sample> sample;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto s = static_cast<std::size_t>(shells.shell[static_cast<std::size_t>(e)]);
    const std::int64_t i = seen[s]++;
    // Evenly over the shell's elements; small shells give some node twice.
    for (std::int64_t k = 0; k < samples; ++k)
      if (k * size[s] / samples == i) sample.push_back({first_node(mesh, e), s});
  }
  return sample;
}

/// Calls f(a, b, c) for the triangles of an element cut into facets; neighbours share their points.
template <class F>
void for_each_facet(const SurfaceMesh& mesh, std::int64_t e, F f) {
  const bool triangle = corner_count(mesh.type[static_cast<std::size_t>(e)]) == 3;
  std::array<std::array<Vec3, facets + 1>, facets + 1> x;
  for (std::size_t i = 0; i <= facets; ++i)
    for (std::size_t j = 0; j <= facets; ++j) {
      const double u = static_cast<double>(i) / facets, v = static_cast<double>(j) / facets;
      if (!triangle)
        x[i][j] = evaluate_surface(mesh, e, 2 * u - 1, 2 * v - 1).x;
      else if (i + j <= facets)
        x[i][j] = evaluate_surface(mesh, e, u, v).x;
    }
  for (std::size_t i = 0; i < facets; ++i)
    for (std::size_t j = 0; j < facets; ++j) {
      if (triangle && i + j >= facets) continue;
      f(x[i][j], x[i + 1][j], x[i][j + 1]);
      if (!triangle || i + j + 1 < facets) f(x[i + 1][j], x[i + 1][j + 1], x[i][j + 1]);
    }
}

}  // namespace

std::vector<double> shell_volumes(const SurfaceMesh& mesh, const Shells& shells) {
  std::vector<double> volume(shells.size(), 0), area(shells.size(), 0), far(shells.size(), 0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto s = static_cast<std::size_t>(shells.shell[static_cast<std::size_t>(e)]);
    volume[s] += shells.sign[static_cast<std::size_t>(e)] * cone_volume(mesh, e, first_node(mesh, shells.first[s]));
    area[s] += element_area(mesh, e);
    for (std::int32_t k : mesh.element(e))
      for (double c : mesh.node[static_cast<std::size_t>(k)]) far[s] = std::max(far[s], std::abs(c));
  }
  Tally flat;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const double noise = 16 * std::numeric_limits<double>::epsilon() * far[s];
    if (!(std::abs(volume[s]) > area[s] * std::max(1e-12 * std::sqrt(area[s]), noise)))
      flat.add("the one of element %lld", static_cast<long long>(shells.first[s]) + mesh.index_base);
  }
  flat.fail_if_any("a closed part encloses no volume", "surface", mesh.index_base);
  return volume;
}

std::vector<int> nesting_depths(const SurfaceMesh& mesh, const Shells& shells, std::span<const double> volume) {
  std::vector<int> depth(shells.size(), 0);
  if (shells.size() == 1) return depth;
  const std::vector<Sample> sample = sample_nodes(mesh, shells);
  const std::vector<Box> box = boxes(mesh, shells);
  // Samples by the shells in whose box they are.
  std::vector<std::vector<std::size_t>> near(shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s)
    for (std::size_t i = 0; i < sample.size(); ++i)
      if (sample[i].shell != s && box[s].holds(sample[i].x)) near[s].push_back(i);

  std::vector<std::vector<double>> angle(shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s) angle[s].assign(near[s].size(), 0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto s = static_cast<std::size_t>(shells.shell[static_cast<std::size_t>(e)]);
    if (near[s].empty()) continue;
    const double sign = shells.sign[static_cast<std::size_t>(e)] * (volume[s] > 0 ? 1 : -1);
    const double scale = 1 / element_diameter(mesh, e);
    for_each_facet(mesh, e, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      for (std::size_t i = 0; i < near[s].size(); ++i) {
        const Vec3& x = sample[near[s][i]].x;
        angle[s][i] += sign * solid_angle(scale * (a - x), scale * (b - x), scale * (c - x));
      }
    });
  }

  for (std::size_t s = 0; s < shells.size(); ++s) {
    std::vector<int> inside(shells.size(), 0);
    for (std::size_t i = 0; i < near[s].size(); ++i)
      if (angle[s][i] > 2 * std::numbers::pi) ++inside[sample[near[s][i]].shell];
    for (std::size_t other = 0; other < shells.size(); ++other) {
      if (inside[other] == samples)
        ++depth[other];
      else if (inside[other] > 0)
        fail(Status::err_mesh,
             "two closed parts of the surface cross: those of elements %lld and %lld "
             "(counting from %d)",
             static_cast<long long>(shells.first[s]) + mesh.index_base,
             static_cast<long long>(shells.first[other]) + mesh.index_base, mesh.index_base);
    }
  }
  return depth;
}

}  // namespace rollcon
