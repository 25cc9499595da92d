#include "support/loaded_ring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace rollcon::statics::loaded_ring {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double none = 0;  ///< not listed, or zero by symmetry

/// Lists displacements at (s, y) = (0,0), (1,0), (2,0), (0,2), (0,3.9), (0,4), and the mean over the patch |s| <= 1.
struct Row {
  Load load;
  double poisson;
  char component;  ///< component: n inwards, s, y
  std::array<double, 7> value;
};
constexpr Row rows[] = {
    {Load::normal, 0.3, 'n', {.0474826, .0394575, .0283727, .0480571, .0517939, .0522833, .0462414}},
    {Load::normal, 0.3, 's', {none, -.0049983, -.0048333, none, none, none, none}},
    {Load::normal, 0.3, 'y', {none, none, none, .0045073, .0124102, .0129436, none}},
    {Load::tangential, 0.3, 's', {.0754808, .0673031, .0558447, .0755530, .0733572, .0726928, .0729445}},
    {Load::tangential, 0.3, 'n', {none, .0045039, .0040242, none, none, none, none}},
    {Load::normal, 0.49, 'n', {.0440806, .0372047, .0275117, .0453897, none, .0541693, .0443127}},
    {Load::axial, 0.3, 'y', {.6098606, .5963578, .5748597, .6144048, .6305889, .6316913, .6120320}},
    {Load::axial, 0.3, 'n', {none, none, none, .0701777, .1630673, .1735673, none}}};

/// Names a load, the component along it, and the largest displacement it is listed with.
struct LoadFacts {
  const char* name;
  char component;
  double scale;
};
LoadFacts facts_of(Load kind) {
  if (kind == Load::normal) return {"normal", 'n', .0474826};
  if (kind == Load::tangential) return {"tangential", 's', .0754808};
  return {"axial", 'y', .6098606};
}
constexpr const char* point_names[] = {"(0,0)", "(1,0)", "(2,0)", "(0,2)", "(0,3.9)", "(0,4)", "mean"};
constexpr std::pair<double, double> points[] = {{0, 0}, {1, 0}, {2, 0}, {0, 2}, {0, 3.9}, {0, 4}};

Vec3 outward(const Vec3& x) {
  const double r = std::hypot(x[0], x[2]);
  return {x[0] / r, 0, x[2] / r};
}
Vec3 around(const Vec3& x) {
  const Vec3 n = outward(x);
  return {n[2], 0, -n[0]};
}
/// Says whether a point is on the outer surface, at the upper half, no further than s along the circumference.
bool near_top(const Vec3& x, double s) {
  return x[2] > 0 && std::abs(std::hypot(x[0], x[2]) - outer) < 1e-9 &&
         std::abs(outer * std::atan2(x[0], x[2])) < s + 1e-9;
}

bool on_line(const Vec3& x, double s) {
  return std::abs(outer * std::atan2(x[0], x[2]) - s) < 1e-9;
}

double component(const Vec3& local, char name) {
  return local[name == 's' ? 0 : name == 'y' ? 1 : 2];
}

}  // namespace

surfaces::Block quarter(const Quarter& q) {
  surfaces::Block b;
  for (int k = 0; k <= q.zone; ++k) b.line[0].push_back(2.0 / outer * k / q.zone);
  const auto rest = surfaces::graded(q.far, 2.0 / outer, pi, 2.0 / outer / q.zone);
  b.line[0].insert(b.line[0].end(), rest.begin() + 1, rest.end());
  for (int k = 0; k <= q.across; ++k) b.line[1].push_back(side * std::sin(pi / 2 * k / q.across));
  b.line[2] = surfaces::graded_to(q.deep, inner, outer, 2.0 / q.zone);
  b.map = [](const Vec3& x) { return Vec3{x[2] * std::sin(x[0]), x[1], x[2] * std::cos(x[0])}; };
  return b;
}

std::vector<std::int64_t> patch_of(const SurfaceMesh& mesh) {
  std::vector<std::int64_t> patch;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    bool inside = true;
    for (const std::int32_t k : mesh.element(e)) inside = inside && near_top(mesh.node[static_cast<std::size_t>(k)], 1);
    if (inside) patch.push_back(e);
  }
  return patch;
}

Vec3 traction(Load kind, const Vec3& x) {
  if (kind == Load::axial) return {0, load, 0};
  return load * (kind == Load::normal ? -1.0 * outward(x) : around(x));
}

std::vector<std::int32_t> nodes_near_patch(const SurfaceMesh& mesh) {
  return surfaces::nodes_where(mesh, [](const Vec3& x) { return near_top(x, 2); });
}

Vec3 Answer::local(std::size_t k) const {
  const Vec3& x = mesh->node[static_cast<std::size_t>(node[k])];
  return {dot(u[k], around(x)), u[k][1], -dot(u[k], outward(x))};
}

bool Answer::has_line(double s) const {
  return std::any_of(node.begin(), node.end(),
                     [&](std::int32_t k) { return on_line(mesh->node[static_cast<std::size_t>(k)], s); });
}

Vec3 Answer::at(double s, double y) const {
  std::map<double, std::size_t> line;
  for (std::size_t k = 0; k < node.size(); ++k) {
    const Vec3& x = mesh->node[static_cast<std::size_t>(node[k])];
    if (!on_line(x, s)) continue;
    if (std::abs(x[1] - y) < 1e-9) return local(k);
    line[x[1]] = k;
  }
  // The nodes sought are those of the element that holds y.
  const std::vector<std::pair<double, std::size_t>> all(line.begin(), line.end());
  const std::size_t steps = is_quadratic(mesh->type.front()) ? 2 : 1;
  std::size_t first = 0;
  while (first + 2 * steps < all.size() && all[first + steps].first < y) first += steps;
  Vec3 sum{0, 0, 0};
  for (std::size_t i = first; i <= first + steps; ++i) {
    double weight = 1;
    for (std::size_t j = first; j <= first + steps; ++j)
      if (j != i) weight *= (y - all[j].first) / (all[i].first - all[j].first);
    sum = sum + weight * local(all[i].second);
  }
  return sum;
}

// Finds the mean by the shape functions of the patch's elements, all of whose nodes are known.
void Answer::find_mean() {
  std::vector<std::int32_t> patch_node;
  const SurfaceMesh patch = surfaces::part_of(*mesh, patch_of(*mesh), patch_node);
  std::map<std::int32_t, std::size_t> place;
  for (std::size_t k = 0; k < node.size(); ++k) place[node[k]] = k;
  double area = 0;
  mean = {0, 0, 0};
  const auto weights = surfaces::nodal_areas(patch);
  for (std::size_t k = 0; k < patch_node.size(); ++k) {
    mean = mean + weights[k] * local(place.at(patch_node[k]));
    area += weights[k];
  }
  mean = (1 / area) * mean;
}

std::vector<ListedError> listed_errors(const Answer& a, Load kind, double poisson) {
  std::vector<ListedError> errors;
  const LoadFacts facts = facts_of(kind);
  for (const Row& row : rows) {
    if (row.load != kind || row.poisson != poisson) continue;
    for (std::size_t p = 0; p < 7; ++p) {
      if (row.value[p] == none || (p < 6 && !a.has_line(points[p].first))) continue;
      const double value = component(p < 6 ? a.at(points[p].first, points[p].second) : a.mean, row.component);
      const double scale = row.component == facts.component ? row.value[p] : facts.scale;
      errors.push_back({facts.name + std::string(" load, nu ") + std::to_string(poisson).substr(0, 4) + ": u_" +
                            row.component + " at " + point_names[p],
                        (value - row.value[p]) / scale});
    }
  }
  return errors;
}

}  // namespace rollcon::statics::loaded_ring
