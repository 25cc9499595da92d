#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/convection/convection.hpp"
#include "mesh/dual_cells.hpp"
#include "mesh/lattice.hpp"
#include "mesh/plane_quadrature.hpp"
#include "mesh/topology.hpp"

namespace rollcon {
namespace {

bool quadratic_quad(ElementType type) {
  return type == ElementType::quad8 || type == ElementType::quad9;
}

// Returns the area of the frame that each node stands for: its dual cell. Nodes of quadratic quadrilaterals get the
// parts that equally spaced nodes have (corner 1/16, midside 1/8, centre 1/4), as the dual cells of their linear cells,
// and so the steps, differ by 2.5 between midside nodes and corners; and two thirds of these, as tractions that are
// quadratic between the nodes want steps that much shorter (0.4 of the spacing halves the error of friction forces on
// quad8 and quad9 against 0.6).
std::vector<double> area_of_nodes(const Frame& frame) {
  const auto type = [&](std::int64_t e) { return frame.mesh.type[static_cast<std::size_t>(e)]; };
  if (std::none_of(frame.mesh.type.begin(), frame.mesh.type.end(), quadratic_quad)) return projected_cell_area(frame);
  const LinearCells all = split_elements(frame.mesh);
  LinearCells others;
  for (std::int64_t c = 0; c < all.size(); ++c) {
    const auto e = all.element[static_cast<std::size_t>(c)];
    if (quadratic_quad(type(e))) continue;
    others.node.insert(others.node.end(), all[c].begin(), all[c].end());
    others.start.push_back(static_cast<std::int64_t>(others.node.size()));
    others.element.push_back(e);
  }
  std::vector<double> area = build_dual_cells(others, frame.x, frame.y).area;
  constexpr double shorter = 2.0 / 3;
  constexpr int degree = 3;  // Jacobian of quadratic elements
  integrate_projection(frame, degree, [&](auto nodes, const Shape&, double, double, double part) {
    if (nodes.size() < 8) return;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      area[static_cast<std::size_t>(nodes[i])] += shorter * part / (i < 4 ? 16 : i < 8 ? 8 : 4);
  });
  return area;
}

// Returns the spacing along the flow (t1): area over half the extent of the neighbours across it.
std::vector<double> spacing_along_flow(const Frame& frame) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  std::vector<double> low(frame.y), high(frame.y), spacing(n);
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    double y_low = 1e300, y_high = -1e300;
    for (const std::int32_t k : frame.mesh.element(e)) {
      y_low = std::min(y_low, frame.y[static_cast<std::size_t>(k)]);
      y_high = std::max(y_high, frame.y[static_cast<std::size_t>(k)]);
    }
    const bool split = is_quadratic(frame.mesh.type[static_cast<std::size_t>(e)]);
    const double half = split ? 0.5 : 1.0;  // a quadratic element spans two spacings
    for (const std::int32_t k : frame.mesh.element(e)) {
      const auto i = static_cast<std::size_t>(k);
      low[i] = std::min(low[i], frame.y[i] + half * (y_low - frame.y[i]));
      high[i] = std::max(high[i], frame.y[i] + half * (y_high - frame.y[i]));
    }
  }
  const std::vector<double> area = area_of_nodes(frame);
  for (std::size_t i = 0; i < n; ++i) {
    const double side = std::sqrt(area[i]);
    const double across = 0.5 * (high[i] - low[i]);
    const double along = across > 0 ? area[i] / across : side;
    spacing[i] = frame.used[i] ? along : 0;
  }
  return spacing;
}

// Tells where the traction of a node acts along the flow, as seen from it: mean and mean square of the distance
// upstream, weighted by the squares of the shape functions (which have no negative lobes).
struct Spread {
  double mean = 0, square = 0;
};

std::vector<Spread> spread_along_flow(const Frame& frame) {
  constexpr int degree = 11;  // N^2 x^2 and the Jacobian of curved quadratic elements
  std::vector<Spread> spread(static_cast<std::size_t>(frame.nodes()));
  std::vector<double> sum(spread.size(), 0.0);
  integrate_projection(frame, degree, [&](auto nodes, const Shape& shape, double x, double /*y*/, double area) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto k = static_cast<std::size_t>(nodes[i]);
      const double w = std::abs(area) * shape.value[i] * shape.value[i];
      const double ahead = x - frame.x[k];
      sum[k] += w;
      spread[k].mean += w * ahead;
      spread[k].square += w * ahead * ahead;
    }
  });
  for (std::size_t k = 0; k < spread.size(); ++k)
    if (sum[k] > 0) spread[k].mean /= sum[k], spread[k].square /= sum[k];
  return spread;
}

// Makes the rows w(x_I) - w(x_I + delta e), both displacements exact.
SparseRows differences(const std::vector<double>& ahead) {
  SparseRows rows;
  const std::size_t n = ahead.size();
  rows.start.push_back(0);
  for (std::size_t k = 0; k < n; ++k) {
    if (ahead[k] > 0) {
      rows.column.push_back(static_cast<std::int32_t>(k));
      rows.value.push_back(1);
      rows.column.push_back(static_cast<std::int32_t>(n + k));
      rows.value.push_back(-1);
    }
    rows.start.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  return rows;
}

}  // namespace

// Chooses steps upstream as a part of the spacing. A node's own traction must move the surface there less than at the
// node, or slip grows with the friction that opposes it. Where it acts upstream of its node, as on the rim that
// material leaves and where elements grow fast, the step passes that place by more than the node's distance from it.
// Inside, elements that grow threefold from one to the next do not need that yet. Regular grids have the same step
// everywhere, so that all rows are alike.
std::vector<double> characteristic_steps(const Frame& frame, double part) {
  constexpr double uniform = 10;  // squared spacing over the mean square, on a uniform grid
  constexpr double further_on_rim = 0.8, further_inside = 0.3;
  const auto n = static_cast<std::size_t>(frame.nodes());
  const std::optional<Lattice> lattice = find_lattice(frame);
  if (lattice && lattice->has_inner_node()) return std::vector<double>(n, part * lattice->spacing_along_flow());
  std::vector<double> step = spacing_along_flow(frame);
  const std::vector<Spread> spread = spread_along_flow(frame);
  // frame.rim leaves out a body's own edges, where elements end all the same.
  const std::vector<std::uint8_t> rim = rim_nodes(frame.nodes(), sorted_sides(split_elements(frame.mesh)));
  for (std::size_t k = 0; k < n; ++k) {
    if (!frame.used[k]) continue;
    const double further = rim[k] ? further_on_rim : further_inside;
    const double beyond = further * part * std::sqrt(uniform * spread[k].square);
    step[k] = std::max(part * step[k], spread[k].mean + std::hypot(spread[k].mean, beyond));
  }
  return step;
}

void convect_on_strips(const Frame& frame, Convection& c) {
  const strips::StripLayout& l = frame.strips->layout;
  const double* g = frame.strips->geometry.data();
  const std::vector<std::int32_t>& node = frame.strips->node;
  const std::size_t n = frame.x.size();
  if (c.ahead.size() != n || c.rows.fallback.size() != n) {
    std::vector<std::size_t> inside(n, node.size());
    for (std::size_t i = 0; i < node.size(); ++i) inside[static_cast<std::size_t>(node[i])] = i;
    c.rows = {};
    c.rows.fallback.assign(n, 0);
    c.rows.start.push_back(0);
    for (std::size_t k = 0; k < n; ++k) {
      const auto add = [&](std::size_t i, double value) {
        c.rows.column.insert(c.rows.column.end(), {node[i], static_cast<std::int32_t>(n) + node[i]});
        c.rows.value.insert(c.rows.value.end(), {value, -value});
      };
      if (const std::size_t i = inside[k]; i < node.size()) {
        for (std::size_t j = 0; j < l.carry[i].size(); ++j)
          if (l.carry[i][j] != 0) add(i + j, l.carry[i][j] * l.spacing[i] / l.spacing[i + j]);
      }
      c.rows.start.push_back(static_cast<std::int64_t>(c.rows.column.size()));
    }
    c.ahead.assign(n, 0.0);
    c.factor.assign(n, 0.0);
  }
  c.slip_x = frame.x;
  c.slip_y = frame.y;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const auto k = static_cast<std::size_t>(node[i]);
    c.ahead[k] = l.spacing[i] * g[l.half_of(l.node[i].row)];
    c.factor[k] = 1 / c.ahead[k];
    c.slip_x[k] = l.x(l.slip_place[i], g);
  }
}

Convection make_characteristic(const Frame& frame, double step, bool ends_at_edge) {
  const std::vector<double> ahead = characteristic_steps(frame, step);
  Convection c = at_nodes(frame, differences(ahead));
  for (std::size_t i = 0; i < ahead.size(); ++i) {
    c.factor[i] = ahead[i] > 0 ? 1 / ahead[i] : 0;
    c.slip_x[i] += ahead[i] / 2;  // the difference is centred there: second order
  }
  c.ahead = ahead;
  if (ends_at_edge) take_slip_at_nodes(frame, c);
  return c;
}

}  // namespace rollcon
