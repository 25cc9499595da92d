#include "support/frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "support/surface_meshes.hpp"

namespace rollcon::frames {
namespace {

constexpr double pi = std::numbers::pi;

using EdgeKey = std::pair<std::int32_t, std::int32_t>;

EdgeKey edge_key(std::int32_t a, std::int32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

Vec3 middle(const Vec3& a, const Vec3& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

using surfaces::add_element;

void add_node(SurfaceMesh& mesh, double x, double y) {
  mesh.node.push_back({x, y, 0});
}

std::size_t corner_number(ElementType type) {
  return static_cast<std::size_t>(corner_count(type));
}

bool is_triangle(ElementType type) {
  return corner_count(type) == 3;
}

/// Turns a linear mesh into the wanted type, on the same corners.
SurfaceMesh as_type(SurfaceMesh linear, ElementType type) {
  return is_quadratic(type) ? to_quadratic(linear, type) : linear;
}

/// Counts the elements on each corner edge of the mesh.
std::map<EdgeKey, int> edge_counts(const SurfaceMesh& mesh) {
  std::map<EdgeKey, int> count;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto nodes = mesh.element(e);
    const auto corners = corner_number(mesh.type[static_cast<std::size_t>(e)]);
    for (std::size_t i = 0; i < corners; ++i) ++count[edge_key(nodes[i], nodes[(i + 1) % corners])];
  }
  return count;
}

void recentre(SurfaceMesh& mesh) {
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    if (!is_quadratic(type)) continue;
    const auto nodes = mesh.element(e);
    const auto corners = corner_number(type);
    auto at = [&](std::size_t i) -> Vec3& { return mesh.node[static_cast<std::size_t>(nodes[i])]; };
    for (std::size_t i = 0; i < corners; ++i) at(corners + i) = middle(at(i), at((i + 1) % corners));
    if (type == ElementType::quad9) at(8) = middle(middle(at(0), at(2)), middle(at(1), at(3)));
  }
}

/// Adds triangles between two rings of nodes, both counter-clockwise; phases are the angles of their first nodes in
/// turns. Advances on the ring whose next node comes first.
void stitch(SurfaceMesh& mesh, std::int32_t inner, int inner_count, double inner_phase, std::int32_t outer,
            int outer_count, double outer_phase) {
  int i = 0, o = 0;
  auto in = [&](int k) { return inner + k % inner_count; };
  auto out = [&](int k) { return outer + k % outer_count; };
  while (i < inner_count || o < outer_count) {
    const double next_in = inner_phase + (i + 1.0) / inner_count;
    const double next_out = outer_phase + (o + 1.0) / outer_count;
    if (o < outer_count && (i == inner_count || next_out <= next_in)) {
      add_element(mesh, ElementType::tri3, {in(i), out(o), out(o + 1)});
      ++o;
    } else {
      add_element(mesh, ElementType::tri3, {in(i), out(o), in(i + 1)});
      ++i;
    }
  }
}

}  // namespace

double Random::operator()() {
  state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
  return static_cast<double>(state_ >> 33) / static_cast<double>(1u << 30) - 1;
}

std::vector<double> uniform_lines(double a, double b, int n) {
  std::vector<double> line(static_cast<std::size_t>(n) + 1);
  for (int k = 0; k <= n; ++k) line[static_cast<std::size_t>(k)] = a + (b - a) * k / n;
  return line;
}

std::vector<double> cosine_lines(double a, int n) {
  std::vector<double> line(static_cast<std::size_t>(n) + 1);
  for (int k = 0; k <= n; ++k) line[static_cast<std::size_t>(k)] = -a * std::cos(pi * k / n);
  return line;
}

SurfaceMesh rectangle(ElementType type, std::span<const double> x, std::span<const double> y) {
  SurfaceMesh mesh;
  for (double yj : y)
    for (double xi : x) add_node(mesh, xi, yj);
  const auto nx = static_cast<std::int32_t>(x.size());
  const auto ny = static_cast<std::int32_t>(y.size());
  for (std::int32_t j = 0; j + 1 < ny; ++j)
    for (std::int32_t i = 0; i + 1 < nx; ++i) {
      const std::int32_t a = j * nx + i, b = a + 1, c = b + nx, d = a + nx;
      if (!is_triangle(type)) {
        add_element(mesh, ElementType::quad4, {a, b, c, d});
      } else if ((i + j) % 2 == 0) {
        add_element(mesh, ElementType::tri3, {a, b, c});
        add_element(mesh, ElementType::tri3, {a, c, d});
      } else {
        add_element(mesh, ElementType::tri3, {a, b, d});
        add_element(mesh, ElementType::tri3, {b, c, d});
      }
    }
  return as_type(std::move(mesh), type);
}

SurfaceMesh o_grid(ElementType type, int core, int rings, double ax, double ay, double core_fraction) {
  if (is_triangle(type)) throw std::invalid_argument("o_grid: quadrilaterals only");
  SurfaceMesh mesh;
  // The core is half way between a square and a disc: no corner of it is flat, no element skewed.
  for (int j = 0; j <= core; ++j)
    for (int i = 0; i <= core; ++i) {
      const double u = 2.0 * i / core - 1, v = 2.0 * j / core - 1;
      const double disc_x = u * std::sqrt(1 - v * v / 2), disc_y = v * std::sqrt(1 - u * u / 2);
      const double square = std::sqrt(0.5);
      add_node(mesh, core_fraction * (0.5 * disc_x + 0.5 * square * u),
               core_fraction * (0.5 * disc_y + 0.5 * square * v));
    }
  for (std::int32_t j = 0; j < core; ++j)
    for (std::int32_t i = 0; i < core; ++i) {
      const std::int32_t a = j * (core + 1) + i;
      add_element(mesh, ElementType::quad4, {a, a + 1, a + core + 2, a + core + 1});
    }
  std::vector<std::int32_t> rim;
  const std::int32_t n = core;
  for (std::int32_t i = 0; i < n; ++i) rim.push_back(i);
  for (std::int32_t j = 0; j < n; ++j) rim.push_back(j * (n + 1) + n);
  for (std::int32_t i = n; i > 0; --i) rim.push_back(n * (n + 1) + i);
  for (std::int32_t j = n; j > 0; --j) rim.push_back(j * (n + 1));
  const std::vector<std::int32_t> first = rim;
  const auto count = first.size();
  for (int k = 1; k <= rings; ++k) {
    std::vector<std::int32_t> next(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 inner = mesh.node[static_cast<std::size_t>(first[i])];
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(count) - 0.75 * pi;
      const double s = static_cast<double>(k) / rings;
      next[i] = static_cast<std::int32_t>(mesh.node.size());
      add_node(mesh, (1 - s) * inner[0] + s * std::cos(angle), (1 - s) * inner[1] + s * std::sin(angle));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = (i + 1) % count;
      add_element(mesh, ElementType::quad4, {rim[i], next[i], next[j], rim[j]});
    }
    rim = next;
  }
  return stretch(as_type(std::move(mesh), type), ax, ay);
}

SurfaceMesh ring_disc(ElementType type, std::span<const double> radius, std::span<const int> count) {
  if (!is_triangle(type) || radius.size() != count.size() || radius.empty())
    throw std::invalid_argument("ring_disc: triangles, one count per radius");
  SurfaceMesh mesh;
  add_node(mesh, 0, 0);
  std::int32_t previous = 0;
  double previous_phase = 0;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    const auto first = static_cast<std::int32_t>(mesh.node.size());
    // Each ring is turned by half a spacing against the one before, kept within half a spacing of angle zero.
    double phase = k == 0 ? 0 : previous_phase + 0.5 / count[k];
    if (phase >= 0.5 / count[k]) phase -= 1.0 / count[k];
    for (int i = 0; i < count[k]; ++i) {
      const double angle = 2 * pi * (phase + static_cast<double>(i) / count[k]);
      add_node(mesh, radius[k] * std::cos(angle), radius[k] * std::sin(angle));
    }
    if (k == 0) {
      for (std::int32_t i = 0; i < count[0]; ++i)
        add_element(mesh, ElementType::tri3, {0, first + i, first + (i + 1) % count[0]});
    } else {
      stitch(mesh, previous, count[k - 1], previous_phase, first, count[k], phase);
    }
    previous = first;
    previous_phase = phase;
  }
  return as_type(std::move(mesh), type);
}

SurfaceMesh paper_disc(ElementType type, double r) {
  const std::vector<int> count = {6, 12, 18, 24, 30, 36, 42, 48, 48, 54, 64, 64, 64, 64, 64, 64};
  std::vector<double> radius;
  for (std::size_t k = 1; k <= count.size(); ++k)
    radius.push_back(r * static_cast<double>(k) / static_cast<double>(count.size()));
  return ring_disc(type, radius, count);
}

std::vector<double> contact_radii(double a, int n, double outer) {
  std::vector<double> radius;
  for (int k = 1; k <= n; ++k) radius.push_back(a * std::sin(pi * k / (2.0 * n)));
  for (int k = 1; k <= n; ++k) {
    const double step = a - a * std::sin(pi * (n - k) / (2.0 * n));
    if (a + 1.2 * step >= outer) break;
    radius.push_back(a + step);
  }
  if (outer > a) radius.push_back(outer);
  return radius;
}

std::vector<int> ring_counts(std::span<const double> radius) {
  double widest = radius[0];
  for (std::size_t k = 1; k < radius.size(); ++k) widest = std::max(widest, radius[k] - radius[k - 1]);
  std::vector<int> count;
  for (double r : radius) count.push_back(std::max(6, static_cast<int>(std::lround(2 * pi * r / widest))));
  return count;
}

SurfaceMesh to_quadratic(const SurfaceMesh& linear, ElementType type) {
  SurfaceMesh mesh;
  mesh.node = linear.node;
  mesh.index_base = linear.index_base;
  std::map<EdgeKey, std::int32_t> midside;
  for (std::int64_t e = 0; e < linear.elements(); ++e) {
    const auto corner = linear.element(e);
    const std::size_t corners = corner.size();
    const ElementType t = corners == 3                 ? ElementType::tri6
                          : type == ElementType::quad9 ? ElementType::quad9
                                                       : ElementType::quad8;
    std::vector<std::int32_t> nodes(corner.begin(), corner.end());
    for (std::size_t i = 0; i < corners; ++i) {
      const auto [place, is_new] = midside.try_emplace(edge_key(corner[i], corner[(i + 1) % corners]),
                                                       static_cast<std::int32_t>(mesh.node.size()));
      if (is_new) add_node(mesh, 0, 0);
      nodes.push_back(place->second);
    }
    if (t == ElementType::quad9) {
      nodes.push_back(static_cast<std::int32_t>(mesh.node.size()));
      add_node(mesh, 0, 0);
    }
    add_element(mesh, t, nodes, linear.tag[static_cast<std::size_t>(e)]);
  }
  recentre(mesh);
  return mesh;
}

SurfaceMesh perturb(SurfaceMesh mesh, double fraction, std::uint32_t seed) {
  const auto count = edge_counts(mesh);
  std::vector<double> shortest(mesh.node.size(), std::numeric_limits<double>::infinity());
  std::vector<char> fixed(mesh.node.size(), 1);
  for (const auto& [edge, n] : count)
    for (std::int32_t k : {edge.first, edge.second}) {
      const auto i = static_cast<std::size_t>(k);
      shortest[i] = std::min(shortest[i], distance(mesh.node[static_cast<std::size_t>(edge.first)],
                                                   mesh.node[static_cast<std::size_t>(edge.second)]));
      fixed[i] = 0;
    }
  for (const auto& [edge, n] : count)
    if (n == 1) fixed[static_cast<std::size_t>(edge.first)] = fixed[static_cast<std::size_t>(edge.second)] = 1;
  Random random(seed);
  for (std::size_t k = 0; k < mesh.node.size(); ++k)
    if (!fixed[k])
      for (int i = 0; i < 2; ++i) mesh.node[k][static_cast<std::size_t>(i)] += fraction * shortest[k] * random();
  recentre(mesh);
  return mesh;
}

SurfaceMesh bend_midsides(SurfaceMesh mesh, double fraction, std::uint32_t seed) {
  const auto count = edge_counts(mesh);
  std::vector<char> done(mesh.node.size(), 0);
  Random random(seed);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    if (!is_quadratic(type)) continue;
    const auto nodes = mesh.element(e);
    const auto corners = corner_number(type);
    for (std::size_t i = 0; i < corners; ++i) {
      const std::int32_t a = nodes[i], b = nodes[(i + 1) % corners];
      const auto mid = static_cast<std::size_t>(nodes[corners + i]);
      if (count.at(edge_key(a, b)) == 1 || done[mid]++) continue;
      const double length = distance(mesh.node[static_cast<std::size_t>(a)], mesh.node[static_cast<std::size_t>(b)]);
      mesh.node[mid][0] += fraction * length * random();
      mesh.node[mid][1] += fraction * length * random();
    }
  }
  return mesh;
}

SurfaceMesh transform(SurfaceMesh mesh, const std::function<Vec3(const Vec3&)>& map) {
  for (Vec3& x : mesh.node) x = map(x);
  return mesh;
}

SurfaceMesh stretch(SurfaceMesh mesh, double sx, double sy) {
  return transform(std::move(mesh), [=](const Vec3& x) { return Vec3{sx * x[0], sy * x[1], x[2]}; });
}

SurfaceMesh rotate(SurfaceMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return transform(std::move(mesh), [=](const Vec3& x) {
    return Vec3{c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
  });
}

}  // namespace rollcon::frames
