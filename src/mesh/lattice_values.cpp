#include "mesh/lattice_values.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {
namespace {

/// Holds the nodes of a line of one grid from which a node of another takes its value, and their weights.
struct Share {
  std::int64_t first = 0;
  std::vector<double> weight;
};

/// Holds the nodes of a grid along one axis.
struct Line {
  double start = 0, spacing = 0;
  std::int64_t count = 0;
};

/// Gives each node the hat functions of the coarser line.
std::vector<Share> shares(const Line& from, const Line& to) {
  constexpr double rounding = 1e-6;
  const double ratio = to.spacing / from.spacing, reach = std::max(1.0, ratio), part = std::min(1.0, 1 / ratio);
  std::vector<Share> all;
  for (std::int64_t n = 0; n < to.count; ++n) {
    double place = (to.start - from.start) / from.spacing + static_cast<double>(n) * ratio;
    if (const double whole = std::round(place); std::abs(place - whole) < rounding) place = whole;
    Share share{to_index(std::clamp(std::floor(place - reach) + 1, 0.0, static_cast<double>(from.count))), {}};
    for (std::int64_t i = share.first; i < from.count && static_cast<double>(i) < place + reach; ++i)
      share.weight.push_back(part * (1 - std::abs(static_cast<double>(i) - place) / reach));
    all.push_back(std::move(share));
  }
  return all;
}

}  // namespace

void carry_to_lattice(const Lattice& from, std::span<const double> value, const Lattice& to,
                      std::vector<double>& carried) {
  const auto along = shares({from.x0, from.dx, from.nx}, {to.x0, to.dx, to.nx});
  const auto across = shares({from.y0, from.dy, from.ny}, {to.y0, to.dy, to.ny});
  const std::size_t columns = along.size();
  std::vector<double> line(columns * at(from.ny));
  for (std::size_t j = 0; j < at(from.ny); ++j)
    for (std::size_t i = 0; i < columns; ++i)
      for (std::size_t k = 0; k < along[i].weight.size(); ++k)
        line[j * columns + i] += along[i].weight[k] * value[at(from.node[j * at(from.nx) + at(along[i].first) + k])];
  carried.assign(to.node.size(), 0.0);
  for (std::size_t j = 0; j < across.size(); ++j)
    for (std::size_t k = 0; k < across[j].weight.size(); ++k)
      for (std::size_t i = 0; i < columns; ++i)
        carried[at(to.node[j * columns + i])] += across[j].weight[k] * line[(at(across[j].first) + k) * columns + i];
}

bool lies_along_axes(const Lattice& lattice) {
  constexpr double rounding = 1e-9;
  return std::abs(lattice.ey) < rounding &&
         std::all_of(lattice.node.begin(), lattice.node.end(), [](std::int32_t k) { return k >= 0; }) &&
         lattice.loose.empty();
}

}  // namespace rollcon
