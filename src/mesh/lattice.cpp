#include "mesh/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon {
namespace {

constexpr double place_tolerance = 1e-10;

struct Direction {
  double x, y;
};

/// Sides of the first element as axes of the grid, and their lengths.
bool take_cell(const Frame& frame, Lattice& lattice) {
  const auto corner = frame.mesh.element(0);
  const auto side = [&](std::size_t from, std::size_t to) {
    const auto a = static_cast<std::size_t>(corner[from]), b = static_cast<std::size_t>(corner[to]);
    return Direction{frame.x[b] - frame.x[a], frame.y[b] - frame.y[a]};
  };
  Direction first = side(0, 1), second = side(1, 2);
  double length[2] = {std::hypot(first.x, first.y), std::hypot(second.x, second.y)};
  if (!(length[0] > 0 && length[1] > 0)) return false;
  // Of two axes as close to t1 as each other, the one that leans towards t2.
  const double lean = std::abs(first.x) / length[0] - std::abs(second.x) / length[1];
  const bool tie = std::abs(lean) < 1e-6;
  if (tie ? first.x * first.y < 0 : lean < 0) {
    std::swap(first, second);
    std::swap(length[0], length[1]);
  }
  const double sign = first.x < 0 ? -1 : 1;
  lattice.ex = sign * first.x / length[0];
  lattice.ey = sign * first.y / length[0];
  lattice.dx = length[0];
  lattice.dy = length[1];
  return true;
}

/// Axes, spacings and origin from the outermost nodes; false where no grid has these extents.
bool fit_extent(const Frame& frame, Lattice& lattice) {
  const std::size_t n = frame.x.size();
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (std::size_t k = 0; k < n; ++k) {
    const double u = lattice.ex * frame.x[k] + lattice.ey * frame.y[k];
    const double v = -lattice.ey * frame.x[k] + lattice.ex * frame.y[k];
    low[0] = std::min(low[0], u), high[0] = std::max(high[0], u);
    low[1] = std::min(low[1], v), high[1] = std::max(high[1], v);
  }
  const double cells[2] = {(high[0] - low[0]) / lattice.dx, (high[1] - low[1]) / lattice.dy};
  const auto most = static_cast<double>(n);
  if (!(cells[0] > 0.5 && cells[1] > 0.5 && cells[0] < most && cells[1] < most)) return false;
  lattice.nx = std::llround(cells[0]) + 1;
  lattice.ny = std::llround(cells[1]) + 1;
  if (lattice.nx * lattice.ny != frame.nodes()) return false;
  // The corners of the grid give its axes to rounding; one cell does not.
  std::size_t corner[3] = {0, 0, 0};  // lowest, end of the first axis, end of the second
  double best[3] = {1e300, 1e300, 1e300};
  for (std::size_t k = 0; k < n; ++k) {
    const double u = (lattice.ex * frame.x[k] + lattice.ey * frame.y[k]) / lattice.dx;
    const double v = (-lattice.ey * frame.x[k] + lattice.ex * frame.y[k]) / lattice.dy;
    const double key[3] = {u + v, v - u, u - v};
    for (std::size_t i = 0; i < 3; ++i)
      if (key[i] < best[i]) best[i] = key[i], corner[i] = k;
  }
  const Direction along{frame.x[corner[1]] - frame.x[corner[0]],
                        frame.y[corner[1]] - frame.y[corner[0]]};
  const Direction across{frame.x[corner[2]] - frame.x[corner[0]],
                         frame.y[corner[2]] - frame.y[corner[0]]};
  const double length = std::hypot(along.x, along.y), width = std::hypot(across.x, across.y);
  if (!(length > 0 && width > 0)) return false;
  lattice.ex = along.x / length;
  lattice.ey = along.y / length;
  lattice.dx = length / static_cast<double>(lattice.nx - 1);
  lattice.dy = width / static_cast<double>(lattice.ny - 1);
  // To rounding, an aligned grid is an aligned grid.
  const double turned =
      std::abs(lattice.ey) * static_cast<double>(std::max(lattice.nx, lattice.ny));
  if (turned < 1e-12) lattice.ex = 1, lattice.ey = 0;
  lattice.x0 = frame.x[corner[0]];
  lattice.y0 = frame.y[corner[0]];
  return true;
}

bool place_nodes(const Frame& frame, Lattice& lattice, std::vector<std::int32_t>& place) {
  const double longer = static_cast<double>(std::max(lattice.nx, lattice.ny));
  const double tolerance = place_tolerance * longer * std::min(lattice.dx, lattice.dy);
  lattice.node.assign(frame.x.size(), -1);
  place.resize(frame.x.size());
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    if (!frame.used[k]) return false;
    const double x = frame.x[k] - lattice.x0, y = frame.y[k] - lattice.y0;
    const double u = lattice.ex * x + lattice.ey * y, v = lattice.ex * y - lattice.ey * x;
    const double i = std::round(u / lattice.dx), j = std::round(v / lattice.dy);
    if (!(std::abs(u - i * lattice.dx) <= tolerance && std::abs(v - j * lattice.dy) <= tolerance))
      return false;
    if (i < 0 || j < 0 || i >= static_cast<double>(lattice.nx) ||
        j >= static_cast<double>(lattice.ny))
      return false;
    const std::int64_t at =
        static_cast<std::int64_t>(j) * lattice.nx + static_cast<std::int64_t>(i);
    std::int32_t& node = lattice.node[static_cast<std::size_t>(at)];
    if (node >= 0) return false;
    node = static_cast<std::int32_t>(k);
    place[k] = static_cast<std::int32_t>(at);
  }
  return true;
}

bool is_every_cell(const Frame& frame, const Lattice& lattice,
                   const std::vector<std::int32_t>& place) {
  std::vector<std::uint8_t> seen(place.size(), 0);
  const std::int64_t nx = lattice.nx;
  for (std::int64_t e = 0; e < frame.elements(); ++e) {
    std::int32_t corner[4];
    for (std::size_t i = 0; i < 4; ++i)
      corner[i] = place[static_cast<std::size_t>(frame.mesh.element(e)[i])];
    std::sort(corner, corner + 4);
    const std::int64_t at = corner[0];
    if (at % nx == nx - 1 || corner[1] != at + 1 || corner[2] != at + nx ||
        corner[3] != at + nx + 1)
      return false;
    if (seen[static_cast<std::size_t>(at)]) return false;
    seen[static_cast<std::size_t>(at)] = 1;
  }
  return true;
}

}  // namespace

std::optional<Lattice> find_lattice(const Frame& frame) {
  if (frame.curved() || frame.elements() == 0) return std::nullopt;
  for (const ElementType type : frame.mesh.type)
    if (type != ElementType::quad4) return std::nullopt;
  Lattice lattice;
  if (!take_cell(frame, lattice) || !fit_extent(frame, lattice) ||
      frame.elements() != (lattice.nx - 1) * (lattice.ny - 1))
    return std::nullopt;
  std::vector<std::int32_t> place;
  if (!place_nodes(frame, lattice, place) || !is_every_cell(frame, lattice, place))
    return std::nullopt;
  return lattice;
}

}  // namespace rollcon
