#include "contact/results/mean_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/topology.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Holds pressures along a piece of a line, linear from its lower to its upper end.
struct Piece {
  double from, to, low, high;

  double up_to(double y) const {
    if (!(to > from)) return 0;
    const double d = std::clamp(y, from, to) - from;
    return d * (low + 0.5 * (high - low) * d / (to - from));
  }
};

/// Returns what a line of given x crosses, in ascending order. A side belongs to the cell on its upper side of x.
std::vector<Piece> cross(const Solution& s, const LinearCells& cells, double x) {
  const Frame& frame = s.prepared->frame;
  std::vector<Piece> found;
  for (std::int64_t c = 0; c < cells.size(); ++c) {
    const auto n = cells[c];
    Piece piece{INFINITY, -INFINITY, 0, 0};
    for (std::size_t i = 0; i < n.size(); ++i) {
      const std::size_t a = at(n[i]), b = at(n[(i + 1) % n.size()]);
      if ((frame.x[a] <= x) == (frame.x[b] <= x)) continue;
      const double part = (x - frame.x[a]) / (frame.x[b] - frame.x[a]);
      const double y = frame.y[a] + part * (frame.y[b] - frame.y[a]);
      const double p = -s.iterate.lambda[2][a] - part * (s.iterate.lambda[2][b] - s.iterate.lambda[2][a]);
      if (y < piece.from) piece.from = y, piece.low = p;
      if (y > piece.to) piece.to = y, piece.high = p;
    }
    if (piece.to > piece.from && piece.low + piece.high > 0) found.push_back(piece);
  }
  std::sort(found.begin(), found.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
  // Cells that are not convex reach into their neighbours.
  for (std::size_t i = 1; i < found.size(); ++i) {
    Piece& p = found[i];
    const double from = std::max(p.from, found[i - 1].to);
    if (from < p.to)
      p.low += (p.high - p.low) * (from - p.from) / (p.to - p.from);
    else
      p.to = from, p.low = p.high = 0;
    p.from = from;
  }
  return found;
}

/// Returns the largest integral over a window of this length that begins or ends where a piece does.
double largest_window(const std::vector<Piece>& piece, double length) {
  std::vector<double> before{0};
  for (const Piece& p : piece) before.push_back(before.back() + p.up_to(p.to));
  const auto up_to = [&](double y) {
    const auto next =
        std::upper_bound(piece.begin(), piece.end(), y, [](double v, const Piece& p) { return v < p.from; });
    const auto i = next - piece.begin();
    return i == 0 ? 0.0 : before[at(i) - 1] + piece[at(i) - 1].up_to(y);
  };
  double most = 0;
  for (const Piece& p : piece)
    most = std::max({most, up_to(p.from + length) - up_to(p.from), up_to(p.to) - up_to(p.to - length)});
  return most;
}

}  // namespace

double largest_mean_pressure(const Solution& s, double length) {
  const Frame& frame = s.prepared->frame;
  const std::vector<double>& normal = s.iterate.lambda[2];
  std::vector<double> x;
  for (std::size_t k = 0; k < normal.size(); ++k)
    if (normal[k] < 0) x.push_back(frame.x[k]);
  if (x.empty()) return 0;
  std::sort(x.begin(), x.end());
  constexpr double rounding = 1e-9;
  const double same = rounding * (x.back() - x.front());
  x.erase(std::unique(x.begin(), x.end(), [&](double a, double b) { return b - a <= same; }), x.end());
  // Lattices have few columns; more lines than these find nothing else.
  constexpr std::size_t most_lines = 97;
  const LinearCells cells = split_elements(frame.mesh);
  double most = 0;
  const std::size_t lines = std::min(most_lines, x.size());
  for (std::size_t i = 0; i < lines; ++i)
    most = std::max(most, largest_window(cross(s, cells, x[lines > 1 ? i * (x.size() - 1) / (lines - 1) : 0]), length));
  return most / length;
}

}  // namespace rollcon
