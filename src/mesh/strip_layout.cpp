#include "mesh/strip_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rollcon::strips {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double upstream_part = 0.6;  // part of the mean spacing
// Gaps vanish so far beyond the ends of a chord and of a width, by the square of the intervals along and by those
// across: the mean over Hertz's ellipses of ratios 0.25 to 2, whose chords are 1 % too long without.
constexpr double beyond_chord = 0.9, beyond_width = 0.21;

// Hats that close the gap carry less load than the pressures they stand for. The missing part, a mean over Hertz's
// ellipses of ratios 0.2 to 5 and over wheels on rails, falls with the fourth power of the intervals along, with the
// sixth from about load_later on, and with the fourth power of those across.
constexpr double load_along = 6.6, load_later = 9, load_across = 1.2;

// Returns integrals over the width of hats of rows, constant beyond the outer rows, times the chords of an ellipse,
// over the chords at the rows.
std::vector<double> row_areas(const std::vector<double>& across) {
  constexpr int points = 400;
  const std::size_t rows = across.size() - 2;
  std::vector<double> area(rows, 0.0);
  for (int i = 0; i < points; ++i) {
    const double angle = pi * (i + 0.5) / points, u = -std::cos(angle),
                 part = std::sin(angle) * std::sin(angle) * pi / points;
    const double inside = std::clamp(u, across[1], across[rows]);
    const auto above = std::upper_bound(across.begin() + 1, across.begin() + static_cast<std::ptrdiff_t>(rows), inside);
    const auto k = static_cast<std::size_t>(above - across.begin());
    const double t = (inside - across[k - 1]) / (across[k] - across[k - 1]);
    area[k - 2] += (1 - t) * part;
    area[k - 1] += t * part;
  }
  for (std::size_t k = 0; k < rows; ++k) area[k] /= std::sqrt(1 - across[k + 1] * across[k + 1]);
  return area;
}

// Returns weights of values at some places for that of their polynomial at another place.
template <std::size_t count>
std::array<double, 3> extrapolated(double to, const std::array<double, count>& from) {
  std::array<double, 3> weight{};
  for (std::size_t i = 0; i < count; ++i) {
    weight[i] = 1;
    for (std::size_t j = 0; j < count; ++j)
      if (j != i) weight[i] *= (to - from[j]) / (from[i] - from[j]);
  }
  return weight;
}

}  // namespace

double usual_row(double t) {
  return (t + std::sin(pi / 2 * t)) / 2;
}

StripLayout::StripLayout(StripCounts of, int number_of_parts, std::vector<double> rows_across)
    : counts(of), parts(number_of_parts), across(std::move(rows_across)) {
  const int n = counts.along, m = counts.across;
  rows_each = m - 1;
  rows = parts * rows_each;
  nodes_each = n - 1;
  nodes = rows * nodes_each;
  geometry = 2 * (rows + parts);
  const int used = rows * (n + 1);
  places = (used + kernel_width - 1) / kernel_width * kernel_width;
  for (int i = 0; i <= n; ++i) along.push_back(std::sin(pi / 2 * (2.0 * i / n - 1)));
  if (across.empty())
    for (int i = 0; i <= m; ++i) across.push_back(usual_row(2.0 * i / m - 1));
  for (int i = 0; i < n; ++i) slope.push_back(1 / (along[i + 1] - along[i]));
  weight.assign(3 * static_cast<std::size_t>(places), 0);
  turn = weight;
  const std::vector<double> area = row_areas(across);
  const double whole_load =
      1 + load_along / (std::pow(n, 4) * (1 + std::pow(n / load_later, 2))) + load_across / std::pow(m, 4);
  for (int row = 0; row < rows; ++row) {
    const int part = part_of(row), line = row % rows_each + 1;
    const double below = 1 / (across[line] - across[line - 1]), above = 1 / (across[line + 1] - across[line]);
    const double foot[3] = {below, -below - above, above};
    for (int f = 0; f < 3; ++f)
      for (int i = 0; i <= n; ++i) {
        const int at = f * places + row * (n + 1) + i;
        weight[at] = foot[f];
        turn[at] = foot[f] * across[line - 1 + f];
      }
    for (int i = 1; i < n; ++i) {
      const auto difference = [&](int node) { return upstream_part * (along[node + 1] - along[node - 1]) / 2; };
      const double step = difference(i);
      StripPoint p{row, row, part, 1, 0, along[i], across[line]};
      node.push_back(p);
      const bool carried = i + 2 < n;
      const auto middle = [&](int at) { return along[at] + difference(at) / 2; };
      carry.push_back(i + 3 < n ? extrapolated(along[i], std::array{middle(i), middle(i + 1), middle(i + 2)})
                      : carried ? extrapolated(along[i], std::array{middle(i), middle(i + 1)})
                                : std::array{1.0, 0.0, 0.0});
      p.half = carried ? along[i] : along[i] + step / 2;
      slip_place.push_back(p);
      p.half = along[i] + step;
      upstream.push_back(p);
      spacing.push_back(step);
      unit_weight.push_back(whole_load * (along[i + 1] - along[i - 1]) / 2 * (across[line + 1] - across[line - 1]) / 2);
      const double low = i > 1 ? (along[i - 1] + along[i]) / 2 : -1,
                   high = i + 1 < n ? (along[i] + along[i + 1]) / 2 : 1;
      unit_cell.push_back((high - low) * area[static_cast<std::size_t>(line) - 1]);
      p.half = (along[i - 1] + along[i] + along[i + 1]) / 3;
      p.across = (across[line - 1] + across[line] + across[line + 1]) / 3;
      centroid.push_back(p);
    }
  }
  observers = node;
  for (int row = 0; row < rows; ++row)
    for (const int side : {-1, 1})
      observers.push_back(
          {row, row, part_of(row), 1, 0, side * (1 + beyond_chord / (n * n)), node[row * nodes_each].across});
  for (int part = 0; part < parts; ++part)
    for (const int side : {-1, 1}) {
      // Middles of the last two rows are extended.
      const int last = part * rows_each + (side < 0 ? 0 : rows_each - 1);
      const double outer = across[side < 0 ? 1 : m - 1], inner = across[side < 0 ? 2 : m - 2],
                   usual = (1 - std::abs(outer)) / (1 - usual_row(1 - 2.0 / m)),
                   end = side * (1 + beyond_width / m * usual), by = (end - outer) / (outer - inner);
      observers.push_back({last, last - side, part, 1 + by, -by, 0, end});
    }
}

}  // namespace rollcon::strips
