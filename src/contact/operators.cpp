#include "contact/operators.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/lattice.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "mesh/topology.hpp"
#include "support/memory_limit.hpp"

namespace rollcon {
namespace {

// Spacing along the flow (t1): dual-cell area over half the extent of the neighbours across it.
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
  const std::vector<double> area = projected_cell_area(frame);
  for (std::size_t i = 0; i < n; ++i) {
    const double side = std::sqrt(area[i]);
    const double across = 0.5 * (high[i] - low[i]);
    const double along = across > 0 ? area[i] / across : side;
    spacing[i] = frame.used[i] ? along : 0;
  }
  return spacing;
}

// Where the traction of a node acts along the flow, as seen from it: mean and mean square of the
// distance upstream, weighted by the squares of the shape functions (which have no negative lobes).
struct Spread {
  double mean = 0, square = 0;
};

std::vector<Spread> spread_along_flow(const Frame& frame) {
  constexpr int degree = 11;  // N^2 x^2 and the Jacobian of curved quadratic elements
  static const PlaneRule triangle = triangle_rule(degree), square = square_rule(degree);
  std::vector<Spread> spread(static_cast<std::size_t>(frame.nodes()));
  std::vector<double> sum(spread.size(), 0.0);
  Shape shape;
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    const ElementType type = frame.mesh.type[static_cast<std::size_t>(e)];
    const auto nodes = frame.mesh.element(e);
    const PlaneRule& rule = corner_count(type) == 3 ? triangle : square;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      evaluate_shape(type, rule.xi[q], rule.eta[q], shape);
      double x = 0, a = 0, b = 0, c = 0, d = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto k = static_cast<std::size_t>(nodes[i]);
        x += shape.value[i] * frame.x[k];
        a += shape.d_xi[i] * frame.x[k];
        b += shape.d_eta[i] * frame.x[k];
        c += shape.d_xi[i] * frame.y[k];
        d += shape.d_eta[i] * frame.y[k];
      }
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto k = static_cast<std::size_t>(nodes[i]);
        const double w = rule.w[q] * std::abs(a * d - b * c) * shape.value[i] * shape.value[i];
        const double ahead = x - frame.x[k];
        sum[k] += w;
        spread[k].mean += w * ahead;
        spread[k].square += w * ahead * ahead;
      }
    }
  }
  for (std::size_t k = 0; k < spread.size(); ++k)
    if (sum[k] > 0) spread[k].mean /= sum[k], spread[k].square /= sum[k];
  return spread;
}

// Steps upstream: a part of the spacing. A node's own traction must move the surface there less
// than at the node, or slip grows with the friction that opposes it. Where it acts upstream of its
// node, as on the rim that material leaves and where elements grow fast, the step passes that place
// by more than the node's distance from it. Inside, elements that grow threefold from one to the
// next do not need that yet. Regular grids have the same step everywhere, so that all rows are
// alike.
std::vector<double> steps_upstream(const Frame& frame, double part) {
  constexpr double uniform = 10;  // squared spacing over the mean square, on a uniform grid
  constexpr double further_on_rim = 0.8, further_inside = 0.3;
  const auto n = static_cast<std::size_t>(frame.nodes());
  const std::optional<Lattice> lattice = find_lattice(frame);
  if (lattice && lattice->nx > 2 && lattice->ny > 2)
    return std::vector<double>(n, part * lattice->spacing_along_flow());
  std::vector<double> step = spacing_along_flow(frame);
  const std::vector<Spread> spread = spread_along_flow(frame);
  // frame.rim leaves out a body's own edges, where elements end all the same.
  const std::vector<std::uint8_t> rim =
      rim_nodes(frame.nodes(), sorted_sides(split_elements(frame.mesh)));
  for (std::size_t k = 0; k < n; ++k) {
    if (!frame.used[k]) continue;
    const double further = rim[k] ? further_on_rim : further_inside;
    const double beyond = further * part * std::sqrt(uniform * spread[k].square);
    step[k] = std::max(part * step[k], spread[k].mean + std::hypot(spread[k].mean, beyond));
  }
  return step;
}

// Derivatives along the surface instead of along its projection.
void follow_surface(const Frame& frame, ContactOperators& op) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  op.upstream_path.resize(op.upstream.size());
  for (std::size_t i = 0; i < n; ++i) {
    const double cosine = dot(frame.t1[i], frame.axes.t1);
    if (!op.upstream.empty()) {
      op.upstream_path[i] = op.upstream[i] / cosine;
      continue;
    }
    for (auto k = static_cast<std::size_t>(op.convection.start[i]);
         k < static_cast<std::size_t>(op.convection.start[i + 1]); ++k)
      op.convection.value[k] *= cosine;
  }
}

}  // namespace

std::size_t ContactOperators::bytes() const {
  std::size_t sum = 0;
  for (const auto& row : block)
    for (const auto& matrix : row)
      if (!matrix.empty() && !matrix.shared())
        sum += static_cast<std::size_t>(rows * matrix.columns()) * sizeof(double);
  if (field) sum += field->bytes();
  return sum + convection.value.capacity() * (sizeof(double) + sizeof(std::int32_t));
}

void require_operator_memory(const ContactOperators& op, const bool (&block)[3][3],
                             std::int64_t rows) {
  double allocated = 0, written = 0;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      if (block[r][c] && op.block[r][c].empty()) allocated += 1;
      if (block[r][c] || !(op.block[r][c].empty() || op.block[r][c].shared())) written += 1;
    }
  const double row_bytes = 8.0 * static_cast<double>(op.nodes);
  require_memory({allocated * static_cast<double>(op.nodes) * row_bytes,
                  written * static_cast<double>(rows) * row_bytes},
                 "take a coarser or smaller frame; on a regular one above half-spaces, option "
                 "'operators' = 'fft' needs no matrices",
                 "the operators of a frame of %lld nodes need", static_cast<long long>(op.nodes));
}

void prepare_convection(const Frame& frame, Scheme scheme, double step, ContactOperators& op) {
  const auto n = static_cast<std::size_t>(frame.nodes());
  op.slip_x = frame.x;
  op.slip_y = frame.y;
  op.upstream.clear();
  op.upstream_path.clear();
  op.convection = SparseRows{};
  switch (scheme) {
    case Scheme::godunov:
      op.convection = godunov(frame, 1, 0);
      break;
    case Scheme::least_squares:
      op.convection = least_squares(frame, 1, 0);
      break;
    case Scheme::characteristic:
      op.upstream = steps_upstream(frame, step);
      for (std::size_t i = 0; i < n; ++i) {
        op.slip_x[i] += op.upstream[i] / 2;  // second order: the difference is centred there
      }
  }
  if (frame.curved()) follow_surface(frame, op);
}

void convect(const ContactOperators& op, const double* w, const double* ahead,
             std::vector<double> (&slip)[2]) {
  const std::size_t n = op.slip_x.size();
  for (auto& v : slip) v.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t c = 0; c < 2; ++c) {
      if (!op.upstream.empty()) {
        if (op.upstream[k] > 0) slip[c][k] = (w[3 * k + c] - ahead[3 * k + c]) / op.path(k);
        continue;
      }
      for (auto j = static_cast<std::size_t>(op.convection.start[k]);
           j < static_cast<std::size_t>(op.convection.start[k + 1]); ++j)
        slip[c][k] +=
            op.convection.value[j] * w[3 * static_cast<std::size_t>(op.convection.column[j]) + c];
    }
}

}  // namespace rollcon
