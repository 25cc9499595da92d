#include "framing/strips/strip_layout.hpp"

#include <cmath>
#include <numbers>

#include "framing/strips/strip_kernels.hpp"

namespace rollcon::strips {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double upstream_part = 0.6;  // part of the mean spacing
// Gaps vanish so far beyond the ends of a chord and of a width, by the square of the intervals along and by those
// across: the mean over Hertz's ellipses of ratios 0.25 to 2, whose chords are 1 % too long without.
constexpr double beyond_chord = 0.9, beyond_width = 0.21;

}  // namespace

StripLayout::StripLayout(StripCounts of, int number_of_parts) : counts(of), parts(number_of_parts) {
  const int n = counts.along, m = counts.across;
  rows_each = m - 1;
  rows = parts * rows_each;
  nodes_each = n - 1;
  nodes = rows * nodes_each;
  geometry = 2 * (rows + parts);
  const int used = rows * (n + 1);
  places = (used + kernel_width - 1) / kernel_width * kernel_width;
  for (int i = 0; i <= n; ++i) along.push_back(std::sin(pi / 2 * (2.0 * i / n - 1)));
  for (int i = 0; i <= m; ++i) {
    const double t = 2.0 * i / m - 1;
    across.push_back((t + std::sin(pi / 2 * t)) / 2);
  }
  for (int i = 0; i < n; ++i) slope.push_back(1 / (along[i + 1] - along[i]));
  weight.assign(3 * static_cast<std::size_t>(places), 0);
  turn = weight;
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
      const double step = upstream_part * (along[i + 1] - along[i - 1]) / 2;
      StripPoint p{row, row, part, 1, 0, along[i], across[line]};
      node.push_back(p);
      p.half = along[i] + step / 2;
      slip_place.push_back(p);
      p.half = along[i] + step;
      upstream.push_back(p);
      spacing.push_back(step);
      unit_weight.push_back((along[i + 1] - along[i - 1]) / 2 * (across[line + 1] - across[line - 1]) / 2);
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
      const double end = side * (1 + beyond_width / m), outer = across[side < 0 ? 1 : m - 1],
                   inner = across[side < 0 ? 2 : m - 2], by = (end - outer) / (outer - inner);
      observers.push_back({last, last - side, part, 1 + by, -by, 0, end});
    }
}

}  // namespace rollcon::strips
