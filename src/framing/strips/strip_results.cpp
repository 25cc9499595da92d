#include "framing/strips/strip_results.hpp"

#include <algorithm>
#include <cmath>

namespace rollcon::strips {
namespace {

/// Returns the second derivative at a node between two others.
double curvature(const double (&x)[3], const double (&f)[3]) {
  return 2 * ((f[2] - f[1]) / (x[2] - x[1]) - (f[1] - f[0]) / (x[1] - x[0])) / (x[2] - x[0]);
}

/// Returns what a node is above the curve: the mean distance of curve and chords, weighted with its shape function.
double above(const double (&x)[3], const double (&f)[3]) {
  const double a = x[1] - x[0], b = x[2] - x[1];
  return -(a * a - a * b + b * b) / 12 * curvature(x, f);
}

/// Returns the top of a parabola through three points near its middle one, within them.
double top(const double (&x)[3], const double (&f)[3], double* at) {
  const double bend = curvature(x, f), slope = (f[2] - f[0]) / (x[2] - x[0]) - bend / 2 * (x[2] + x[0] - 2 * x[1]);
  *at = bend < 0 ? std::clamp(x[1] - slope / bend, x[0], x[2]) : x[1];
  const double d = *at - x[1];
  return f[1] + slope * d + bend / 2 * d * d;
}

}  // namespace

double area(const StripState& state) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  double sum = 0;
  for (int i = 0; i < l.nodes; ++i) sum += l.unit_cell[i] * l.cell(l.node[i], g);
  return sum;
}

std::array<double, 3> lacking_at_poles(const StripState& solution) {
  constexpr int points = 4;  // in each direction between four nodes
  // Cells with a node that sticks do not count; slip of a few per cent of the mean is as good as none. Directions are
  // rounded off over the distance of points, so that sums are continuous.
  constexpr double slow = 0.05, rounded = 0.5 / points;
  const StripLayout& l = solution.layout;
  const double* g = solution.geometry.data();
  const auto vector = [n = l.nodes](const std::vector<double>& of, int node) { return Vec2{of[node], of[n + node]}; };
  std::array<double, 3> sum{};
  for (int first = 0; first + l.nodes_each < l.nodes; ++first) {
    const int row = first / l.nodes_each;
    if (l.part_of(row) != l.part_of(row + 1) || first % l.nodes_each + 1 == l.nodes_each) continue;
    const int node[] = {first, first + 1, first + l.nodes_each, first + l.nodes_each + 1};
    Vec2 slip[4], traction[4], place[4];
    double carried[4], mean = 0, spread = 0, weight = 1;
    for (int k = 0; k < 4; ++k) {
      slip[k] = vector(solution.slip, node[k]);
      traction[k] = vector(solution.traction, node[k]);
      place[k] = {l.x(l.node[node[k]], g), l.y(l.node[node[k]], g)};
      carried[k] = length(traction[k]);
      mean += length(slip[k]) / 4;
      spread = std::max(spread, length(slip[k] - slip[0]));
    }
    if (!(mean > 0)) continue;
    for (const Vec2& s : slip) weight *= std::min(1.0, length(s) / (slow * mean));
    for (int i = 0; i < points * points && weight > 0; ++i) {
      const double u = (i % points + 0.5) / points, v = (i / points + 0.5) / points;
      const auto between = [&](const auto& of) {
        return (1 - v) * ((1 - u) * of[0] + u * of[1]) + v * ((1 - u) * of[2] + u * of[3]);
      };
      const double chord = (1 - v) * (place[1][0] - place[0][0]) + v * (place[3][0] - place[2][0]),
                   part = weight * chord * (place[2][1] - place[0][1]) / (points * points);
      const Vec2 s = between(slip), x = between(place);
      const Vec2 lack = -between(carried) / std::hypot(s[0], s[1], rounded * spread) * s - between(traction);
      sum[0] += part * lack[0];
      sum[1] += part * lack[1];
      sum[2] += part * (x[0] * lack[1] - x[1] * lack[0]);
    }
  }
  return sum;
}

PressurePeak largest_pressure(const StripState& state) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  // Pressure at a node or 0 at an end, and its place along.
  const auto pressure = [&](int row, int i) {
    return i < 0 || i >= l.nodes_each ? 0 : state.pressure[row * l.nodes_each + i];
  };
  const auto place = [&](int row, int i) { return g[row] + g[l.half_of(row)] * l.along[i + 1]; };
  // Returns the pressure of a row at a place beside it, linear between its nodes.
  const auto at = [&](int row, double x) {
    for (int i = -1; i < l.nodes_each; ++i)
      if (x >= place(row, i) && x <= place(row, i + 1)) {
        const double t = (x - place(row, i)) / (place(row, i + 1) - place(row, i));
        return (1 - t) * pressure(row, i) + t * pressure(row, i + 1);
      }
    return 0.0;
  };
  struct Crest {
    double square = 0, x = 0;
  };
  const auto crest = [&](int row) {
    Crest best;
    const int highest = static_cast<int>(std::max_element(state.pressure.begin() + row * l.nodes_each,
                                                          state.pressure.begin() + (row + 1) * l.nodes_each) -
                                         state.pressure.begin()) -
                        row * l.nodes_each;
    const int line = row % l.rows_each;
    double square[3], x[3];
    for (int j = 0; j < 3; ++j) {
      const int i = std::clamp(highest - 1 + j, -1, l.nodes_each);
      x[j] = place(row, i);
      const double p = pressure(row, i);
      square[j] = 0;
      if (i < 0 || i >= l.nodes_each) continue;
      const double xs[3] = {place(row, i - 1), x[j], place(row, i + 1)};
      const double ps[3] = {pressure(row, i - 1), p, pressure(row, i + 1)};
      const double width = g[l.width_of(l.part_of(row))];
      const double ys[3] = {width * l.across[line], width * l.across[line + 1], width * l.across[line + 2]};
      const double pys[3] = {line > 0 ? at(row - 1, x[j]) : 0, p, line + 1 < l.rows_each ? at(row + 1, x[j]) : 0};
      const double corrected = std::max(p - above(xs, ps) - above(ys, pys), 0.0);
      square[j] = corrected * corrected;
    }
    best.square = top(x, square, &best.x);
    return best;
  };
  PressurePeak peak;
  for (int part = 0; part < l.parts; ++part) {
    int highest = -1;
    double most = 0;
    for (int k = 0; k < l.rows_each; ++k) {
      const double square = crest(part * l.rows_each + k).square;
      if (square > most) most = square, highest = k;
    }
    if (highest < 0) continue;
    double y[3], square[3], x[3];
    for (int j = 0; j < 3; ++j) {
      const int k = highest - 1 + j;
      y[j] = g[l.centre_of(part)] + g[l.width_of(part)] * l.across[k + 1];
      const Crest c = k < 0 || k >= l.rows_each ? Crest{} : crest(part * l.rows_each + k);
      square[j] = c.square;
      x[j] = c.x;
    }
    double best_y = 0;
    const double p = std::sqrt(std::max(top(y, square, &best_y), 0.0));
    if (p > peak.pressure) peak = {p, {x[1], best_y}};
  }
  return peak;
}

StripTrust trust(const StripState& state) {
  const StripLayout& l = state.layout;
  const double* g = state.geometry.data();
  StripTrust t;
  // Values over those of an ellipse, and their least one between two larger ones over the lesser of these.
  const auto along_row = [&](int row, int i) {
    return state.pressure[row * l.nodes_each + i] / std::sqrt(1 - l.along[i + 1] * l.along[i + 1]);
  };
  // Rows that lie near a corner count as the outermost usual row.
  const double outermost = usual_row(1 - 2.0 / l.counts.across);
  const auto of_row = [&](int row) {
    double most = along_row(row, 0);
    for (int i = 1; i < l.nodes_each; ++i) most = std::max(most, along_row(row, i));
    const double u = std::min(std::abs(l.across[row % l.rows_each + 1]), outermost);
    return most / std::sqrt(1 - u * u);
  };
  const auto valley = [&](int count, const auto& value) {
    for (int i = 1; i + 1 < count; ++i) {
      double left = value(0), right = value(i + 1);
      for (int j = 1; j < i; ++j) left = std::max(left, value(j));
      for (int j = i + 2; j < count; ++j) right = std::max(right, value(j));
      if (std::min(left, right) > 0) t.joined = std::min(t.joined, value(i) / std::min(left, right));
    }
  };
  for (int part = 0; part < l.parts; ++part) {
    const int first = part * l.rows_each;
    for (int k = 0; k < l.rows_each; ++k) valley(l.nodes_each, [&](int i) { return along_row(first + k, i); });
    valley(l.rows_each, [&](int k) { return of_row(first + k); });
    // Measures how far a row ends within the straight line between its neighbours' ends.
    const double* half = g + l.half_of(part * l.rows_each);
    const double* middle = g + part * l.rows_each;
    const double longest = *std::max_element(half, half + l.rows_each);
    for (int k = 1; k + 1 < l.rows_each; ++k)
      for (const int side : {-1, 1}) {
        const auto end = [&](int i) { return side * middle[i] + half[i]; };
        const double below = l.across[k + 1] - l.across[k], above = l.across[k + 2] - l.across[k + 1];
        const double line_there = (end(k - 1) * above + end(k + 1) * below) / (below + above);
        t.hollow = std::max(t.hollow, (line_there - end(k)) / longest);
      }
  }
  for (int a = 0; a < l.rows; ++a)
    for (int b = (l.part_of(a) + 1) * l.rows_each; b < l.rows; ++b) {
      const double dy = g[l.centre_of(l.part_of(a))] + g[l.width_of(l.part_of(a))] * l.across[a % l.rows_each + 1] -
                        g[l.centre_of(l.part_of(b))] - g[l.width_of(l.part_of(b))] * l.across[b % l.rows_each + 1];
      const double dx = std::max(std::abs(g[a] - g[b]) - g[l.half_of(a)] - g[l.half_of(b)], 0.0);
      t.apart =
          std::min(t.apart, std::hypot(dx, dy) / std::min(g[l.width_of(l.part_of(a))], g[l.width_of(l.part_of(b))]));
    }
  return t;
}

double StripTrust::share() const {
  // Neighbours with a neck of a fifth of the wall between both deepest places more and less have left these zones.
  const auto rise = [](double x, double low, double high) {
    const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return s * s * (3 - 2 * s);
  };
  return rise(joined, 0.006, 0.018) * rise(apart, 0.5, 1) * rise(-hollow, -most_hollow, -2 * most_hollow / 3);
}

}  // namespace rollcon::strips
