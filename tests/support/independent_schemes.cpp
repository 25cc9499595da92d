#include "support/independent_schemes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace rollcon::laws {
namespace {

std::size_t at_index(std::int32_t k) {
  return static_cast<std::size_t>(k);
}

/// Describes a neighbour seen from a node: s upstream, t across.
struct Seen {
  std::int32_t node;
  double s, t, d;
};

struct Stencil {
  std::vector<Difference> entry;
  double growth = 0, amplification = 0, truncation = 0;
};

Stencil judged(const std::vector<Seen>& from, const std::vector<double>& c) {
  Stencil stencil;
  double sum = 0, size = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (c[k] == 0) continue;
    stencil.entry.push_back({from[k].node, c[k]});
    sum += c[k];
    size += std::abs(c[k]);
    stencil.amplification += std::abs(c[k]) * from[k].d;
    stencil.truncation += std::abs(c[k]) * from[k].d * from[k].d;
  }
  stencil.growth = sum < 0 ? -size / sum : 1e300;
  return stencil;
}

/// Returns minus the upstream component of the gradient that fits the differences best, each weighted by cos / d with
/// cos^2 >= 1e-6.
std::optional<Stencil> fitted(const std::vector<Seen>& upwind) {
  double ss = 0, st = 0, tt = 0;
  const auto weight = [](const Seen& j) { return std::max(j.s * j.s / (j.d * j.d), 1e-6); };
  for (const Seen& j : upwind) {
    const double w = weight(j) / (j.d * j.d);
    ss += w * j.s * j.s, st += w * j.s * j.t, tt += w * j.t * j.t;
  }
  const double determinant = ss * tt - st * st;
  const bool one_line = determinant <= 1e-10 * ss * tt;
  if (one_line && tt > 1e-14 * ss) return std::nullopt;
  std::vector<double> c;
  double largest = 0;
  for (const Seen& j : upwind) {
    const double part = one_line ? j.s / ss : (tt * j.s - st * j.t) / determinant;
    c.push_back(-weight(j) * part / (j.d * j.d));
    largest = std::max(largest, std::abs(c.back()) * j.d);
  }
  for (std::size_t k = 0; k < c.size(); ++k)
    if (std::abs(c[k]) * upwind[k].d <= 1e-14 * largest) c[k] = 0;
  return judged(upwind, c);
}

/// Returns the pair of neighbours with the path between them that has the least truncation.
std::optional<Stencil> pair_around_path(const std::vector<Seen>& seen) {
  std::optional<Stencil> best;
  for (const Seen& right : seen)
    for (const Seen& left : seen) {
      if (right.node == left.node || right.t > 0 || left.t < 0) continue;
      const double cross = right.s * left.t - right.t * left.s;
      if (cross <= 1e-6 * right.d * left.d) continue;
      const Stencil pair = judged({right, left}, {-left.t / cross, right.t / cross});
      if (!best || pair.truncation < best->truncation * (1 - 1e-12)) best = pair;
    }
  return best;
}

std::optional<Stencil> shorter(std::optional<Stencil> a, std::optional<Stencil> b, double growth) {
  if (a && a->growth > growth) a.reset();
  if (b && b->growth > growth) b.reset();
  if (!a) return b;
  return b && b->truncation < a->truncation ? b : a;
}

std::vector<Seen> looking_upstream(const std::vector<Seen>& seen) {
  std::vector<Seen> upwind;
  bool any = false;
  for (const Seen& j : seen) {
    if (j.s >= 0) upwind.push_back(j);
    any = any || j.s > 0;
  }
  if (!any) upwind.clear();
  return upwind;
}

}  // namespace

std::vector<std::vector<std::int32_t>> linear_cells(const SurfaceMesh& mesh) {
  std::vector<std::vector<std::int32_t>> cells;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto n = mesh.element(e);
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    if (!is_quadratic(type)) {
      cells.emplace_back(n.begin(), n.end());
      continue;
    }
    const std::size_t corners = type == ElementType::tri6 ? 3 : 4;
    std::vector<std::int32_t> middle;
    for (std::size_t i = 0; i < corners; ++i) {
      const std::int32_t after = n[corners + i], before = n[corners + (i + corners - 1) % corners];
      if (type == ElementType::quad9) {
        cells.push_back({n[i], after, n[8]});
        cells.push_back({after, n[(i + 1) % corners], n[8]});
      } else {
        cells.push_back({n[i], after, before});
        middle.push_back(after);
      }
    }
    if (!middle.empty()) cells.push_back(middle);
  }
  return cells;
}

Rows godunov_rows(const SurfaceMesh& mesh, const Plane& at) {
  Rows rows(mesh.node.size());
  std::vector<double> cell(mesh.node.size(), 0.0);
  for (const auto& n : linear_cells(mesh)) {
    const double x0 = at.x[at_index(n[0])], y0 = at.y[at_index(n[0])];
    double gx = 0, gy = 0;
    for (const std::int32_t k : n) {
      gx += (at.x[at_index(k)] - x0) / static_cast<double>(n.size());
      gy += (at.y[at_index(k)] - y0) / static_cast<double>(n.size());
    }
    for (std::size_t i = 0; i < n.size(); ++i) {
      const std::int32_t a = n[i], b = n[(i + 1) % n.size()];
      const double ax = at.x[at_index(a)] - x0, ay = at.y[at_index(a)] - y0;
      const double bx = at.x[at_index(b)] - x0, by = at.y[at_index(b)] - y0;
      const double quarter = 0.25 * ((bx - ax) * (gy - ay) - (by - ay) * (gx - ax));
      cell[at_index(a)] += quarter;
      cell[at_index(b)] += quarter;
      // The flow along -x goes through the face from the edge's middle to the centroid.
      const double mx = 0.5 * (ax + bx), my = 0.5 * (ay + by);
      const double flux = -(gy - my);
      if (std::abs(flux) <= 1e-10 * std::hypot(gx - mx, gy - my)) continue;
      const std::int32_t into = flux < 0 ? a : b, from = flux < 0 ? b : a;
      rows[at_index(into)].push_back({from, -std::abs(flux)});
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (Difference& d : rows[k]) d.c /= cell[k];
  return rows;
}

Rows least_squares_rows(const SurfaceMesh& mesh, const Plane& at) {
  const std::size_t nodes = mesh.node.size();
  std::vector<std::set<std::int32_t>> near(nodes);
  for (const auto& n : linear_cells(mesh))
    for (std::size_t i = 0; i < n.size(); ++i) {
      const std::int32_t a = n[i], b = n[(i + 1) % n.size()];
      near[at_index(a)].insert(b);
      near[at_index(b)].insert(a);
    }
  const auto look = [&](std::size_t i, const std::set<std::int32_t>& candidates) {
    std::vector<Seen> seen;
    for (const std::int32_t k : candidates) {
      if (at_index(k) == i) continue;
      Seen j{k, at.x[at_index(k)] - at.x[i], at.y[at_index(k)] - at.y[i], 0};
      j.d = std::hypot(j.s, j.t);
      if (std::abs(j.s) <= 1e-10 * j.d) j.s = 0;
      if (std::abs(j.t) <= 1e-10 * j.d) j.t = 0;
      seen.push_back(j);
    }
    return seen;
  };
  std::optional<Rows> flux;
  Rows rows(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::vector<Seen> ring = look(i, near[i]);
    const std::vector<Seen> first = looking_upstream(ring);
    if (first.empty()) continue;
    const std::optional<Stencil> own = fitted(first);
    if (own && own->growth <= 1.5 && own->amplification <= 2.5) {
      rows[i] = own->entry;
      continue;
    }
    std::set<std::int32_t> two = near[i];
    for (const std::int32_t k : near[i]) two.insert(near[at_index(k)].begin(), near[at_index(k)].end());
    const std::vector<Seen> wide = looking_upstream(look(i, two));
    std::optional<Stencil> chosen = shorter(own, pair_around_path(wide), 1.5);
    if (!chosen) chosen = pair_around_path(ring);
    if (!chosen) chosen = shorter(own, fitted(wide), 4);
    if (chosen) {
      rows[i] = chosen->entry;
      continue;
    }
    if (!flux) flux = godunov_rows(mesh, at);
    rows[i] = (*flux)[i];
    if (!rows[i].empty()) continue;
    double sum = 0;
    for (const Seen& j : first) sum += j.s * j.s / (j.d * j.d);
    for (const Seen& j : first) rows[i].push_back({j.node, -j.s / (j.d * j.d * sum)});
  }
  return rows;
}

namespace {

/// Calls f(nodes, shape, x, y, area) at the points of a rule on every element.
template <class F>
void integrate(const SurfaceMesh& mesh, const Plane& at, int degree, F f) {
  const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  Shape shape;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    const auto n = mesh.element(e);
    const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
      double x = 0, y = 0, j[4] = {};
      for (std::size_t a = 0; a < n.size(); ++a) {
        const double nx = at.x[at_index(n[a])], ny = at.y[at_index(n[a])];
        x += shape.value[a] * nx, y += shape.value[a] * ny;
        j[0] += shape.d_xi[a] * nx, j[1] += shape.d_xi[a] * ny;
        j[2] += shape.d_eta[a] * nx, j[3] += shape.d_eta[a] * ny;
      }
      f(n, shape, x, y, rule.w[q] * (j[0] * j[3] - j[1] * j[2]));
    }
  }
}

/// Holds moments of N^2 about its node along the flow.
struct Reach {
  double all = 0, first = 0, second = 0;
};

std::vector<Reach> reaches_upstream(const SurfaceMesh& mesh, const Plane& at) {
  std::vector<Reach> reach(mesh.node.size());
  integrate(mesh, at, 13, [&](auto n, const Shape& shape, double x, double /*y*/, double w) {
    for (std::size_t a = 0; a < n.size(); ++a) {
      const double part = std::abs(w) * shape.value[a] * shape.value[a];
      const double off = x - at.x[at_index(n[a])];
      Reach& of = reach[at_index(n[a])];
      of.all += part, of.first += part * off, of.second += part * off * off;
    }
  });
  return reach;
}

/// Returns nodes of edges that belong to one element.
std::vector<bool> on_the_rim(const SurfaceMesh& mesh) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> count;
  const auto cells = linear_cells(mesh);
  for (const auto& n : cells)
    for (std::size_t i = 0; i < n.size(); ++i) ++count[std::minmax(n[i], n[(i + 1) % n.size()])];
  std::vector<bool> rim(mesh.node.size(), false);
  for (const auto& [edge, cells_there] : count)
    if (cells_there == 1) rim[at_index(edge.first)] = rim[at_index(edge.second)] = true;
  return rim;
}

}  // namespace

std::vector<double> steps(const SurfaceMesh& mesh, const Plane& at, double part_of_spacing, bool regular) {
  const std::size_t nodes = mesh.node.size();
  std::vector<double> low = at.y, high = at.y, area(nodes, 0.0), spacing(nodes, 0.0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    double bottom = INFINITY, top = -INFINITY;
    for (const std::int32_t k : mesh.element(e)) {
      bottom = std::min(bottom, at.y[at_index(k)]);
      top = std::max(top, at.y[at_index(k)]);
    }
    const double part = is_quadratic(mesh.type[static_cast<std::size_t>(e)]) ? 0.5 : 1;
    for (const std::int32_t k : mesh.element(e)) {
      const std::size_t i = at_index(k);
      low[i] = std::min(low[i], at.y[i] + part * (bottom - at.y[i]));
      high[i] = std::max(high[i], at.y[i] + part * (top - at.y[i]));
    }
  }
  // Nodes of quadratic quadrilaterals have two thirds of what equally spaced ones stand for.
  SurfaceMesh others;
  others.node = mesh.node;
  others.offset = {0};
  const auto quadratic_quad = [&](std::int64_t e) {
    const ElementType type = mesh.type[static_cast<std::size_t>(e)];
    return type == ElementType::quad8 || type == ElementType::quad9;
  };
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    if (quadratic_quad(e)) continue;
    const auto n = mesh.element(e);
    others.connectivity.insert(others.connectivity.end(), n.begin(), n.end());
    others.offset.push_back(static_cast<std::int64_t>(others.connectivity.size()));
    others.type.push_back(mesh.type[static_cast<std::size_t>(e)]);
    others.tag.push_back(0);
  }
  integrate(mesh, at, 13, [&](auto n, const Shape&, double, double, double w) {
    if (n.size() < 8) return;
    for (std::size_t a = 0; a < n.size(); ++a)
      area[at_index(n[a])] += w * (a < 4 ? 1.0 / 24 : a < 8 ? 1.0 / 12 : 1.0 / 6);
  });
  for (const auto& n : linear_cells(others)) {
    double gx = 0, gy = 0;
    const double x0 = at.x[at_index(n[0])], y0 = at.y[at_index(n[0])];
    for (const std::int32_t k : n) {
      gx += (at.x[at_index(k)] - x0) / static_cast<double>(n.size());
      gy += (at.y[at_index(k)] - y0) / static_cast<double>(n.size());
    }
    for (std::size_t i = 0; i < n.size(); ++i) {
      const std::size_t a = at_index(n[i]), b = at_index(n[(i + 1) % n.size()]);
      const double quarter =
          0.25 * ((at.x[b] - at.x[a]) * (gy + y0 - at.y[a]) - (at.y[b] - at.y[a]) * (gx + x0 - at.x[a]));
      area[a] += quarter;
      area[b] += quarter;
    }
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    if (area[i] == 0) continue;
    const double across = 0.5 * (high[i] - low[i]);
    spacing[i] = across > 0 ? area[i] / across : std::sqrt(area[i]);
  }
  if (regular) {
    const double all = *std::max_element(spacing.begin(), spacing.end());
    return std::vector<double>(nodes, part_of_spacing * all);
  }
  const std::vector<Reach> reach = reaches_upstream(mesh, at);
  const std::vector<bool> rim = on_the_rim(mesh);
  for (std::size_t i = 0; i < nodes; ++i) {
    if (area[i] == 0) continue;
    const double mean = reach[i].first / reach[i].all, mean_square = reach[i].second / reach[i].all;
    const double past = (rim[i] ? 0.8 : 0.3) * part_of_spacing * std::sqrt(10 * mean_square);
    spacing[i] = std::max(part_of_spacing * spacing[i], mean + std::sqrt(mean * mean + past * past));
  }
  return spacing;
}

std::vector<std::array<double, 3>> shape_integrals(const SurfaceMesh& mesh, const Plane& at) {
  std::vector<std::array<double, 3>> sum(mesh.node.size());
  integrate(mesh, at, 7, [&](auto n, const Shape& shape, double x, double y, double w) {
    for (std::size_t a = 0; a < n.size(); ++a) {
      std::array<double, 3>& of = sum[at_index(n[a])];
      of[0] += w * shape.value[a], of[1] += w * shape.value[a] * x, of[2] += w * shape.value[a] * y;
    }
  });
  return sum;
}

}  // namespace rollcon::laws
