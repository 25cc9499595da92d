#include "contact/newton/start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "linalg/lu.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// Holds the bodies cut at half the approach, where a smooth Hertzian contact has its edge.
struct Cut {
  double low = INFINITY;  ///< least gap, as an approach
  double half = 0;        ///< half the approach beyond it
  double p0 = 0;
};

double gap_at(const Problem& p, const MotionValues& m, std::size_t k) {
  return p.tilted_gap(k, m) / p.closing(k);
}

// Cuts the bodies; an unknown approach is taken from Hertz's formula for a circle of the same overlap.
Cut cut(const Problem& p, const Prescribed& given, const MotionValues& m) {
  Cut c;
  double high = -INFINITY;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    if (!p.used[k]) continue;
    c.low = std::min(c.low, gap_at(p, m, k));
    high = std::max(high, gap_at(p, m, k));
  }
  if (!(c.low <= high)) return c;
  const auto overlap = [&](double depth) {
    double area = 0;
    for (std::size_t k = 0; k < at(p.nodes); ++k)
      if (p.used[k] && gap_at(p, m, k) < c.low + depth) area += p.cell_area[k];
    return area;
  };
  // Half approach d and contact area A = pi a^2 give p0 = 2 E* (2 d) / (pi a), F = 2/3 p0 A.
  const auto peak = [&](double half, double area) {
    return area > 0 ? 4 * p.stiffness * half / std::sqrt(std::numbers::pi * area) : 0.0;
  };
  c.half = 0.5 * (m[approach] - c.low);
  if (given.by_force[approach]) {
    const double load = given.value[approach];
    const auto carried = [&](double depth) {
      const double area = overlap(depth);
      return 2.0 / 3.0 * peak(depth, area) * area;
    };
    double a = 0, b = std::max(high - c.low, 1e-12 * std::abs(high));
    if (!(b > 0)) b = load / (p.stiffness * p.length);
    // Gaps of nodes that are never to touch may be of any size: halving from there would take too long.
    while (load > 0 && b > 0 && carried(b / 1024) >= load) b /= 1024;
    for (int i = 0; i < 200 && carried(b) < load; ++i) a = b, b *= 2;
    for (int i = 0; i < 400 && b - a > 1e-6 * b; ++i) {
      const double middle = 0.5 * (a + b);
      (carried(middle) < load ? a : b) = middle;
    }
    c.half = b;
  }
  if (c.half > 0) c.p0 = peak(c.half, overlap(c.half));
  return c;
}

}  // namespace

GuessedContact guess_contact(const Problem& p, const Prescribed& given, const MotionValues& motion) {
  const Cut c = cut(p, given, motion);
  return {c.low, c.half};
}

void guess_approach(const Problem& p, const Prescribed& given, MotionValues& motion) {
  if (!given.by_force[approach]) return;
  const Cut c = cut(p, given, motion);
  if (c.low < INFINITY) motion[approach] = c.low + 2 * c.half;
}

// Guesses tilts whose moments are given, which level the gap where the load presses, by the gap's slope near that
// point, fitted over a part of the frame.
void guess_tilts(const Problem& p, const Prescribed& given, MotionValues& m) {
  constexpr double part = 0.15;
  double load = given.value[approach];
  if (!given.by_force[approach] || !(load > 0) || (!given.by_force[tilt1] && !given.by_force[tilt2])) return;
  const double x0 = given.value[tilt2] / load, y0 = -given.value[tilt1] / load, width = part * p.length;
  Lu<double> lu;
  double* a = lu.prepare(3);
  std::fill_n(a, 9, 0.0);
  double b[3] = {};
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    if (!p.used[k]) continue;
    // Columns of the tilts are y and -x.
    const double row[3] = {1, p.tilting[0][k] - y0, p.tilting[1][k] + x0};
    const double w = std::exp(-0.5 * (row[1] * row[1] + row[2] * row[2]) / (width * width));
    for (int r = 0; r < 3; ++r) {
      b[r] += w * row[r] * p.gap[k];
      for (int c = 0; c < 3; ++c) a[3 * r + c] += w * row[r] * row[c];
    }
  }
  if (!lu.factor()) return;
  lu.solve(b);
  for (const std::size_t t : {tilt1, tilt2})
    if (given.by_force[t] && std::isfinite(b[t - spin])) m[t] = b[t - spin];
}

// Gives the overlap the semi-elliptic pressure p0 sqrt(1 - h/(approach/2)), exact for a paraboloid.
void guess_start(const Problem& p, const Prescribed& given, Iterate& it) {
  guess_tilts(p, given, it.motion);
  Cut c = cut(p, given, it.motion);
  if (!(c.low < INFINITY)) return;
  // Enough nodes are not all on one line, about which they would carry no moment.
  constexpr std::int64_t enough = 8;
  const auto touching = [&] {
    std::int64_t count = 0;
    for (std::size_t k = 0; k < at(p.nodes); ++k) count += p.used[k] && gap_at(p, it.motion, k) < c.low + c.half;
    return count;
  };
  if (given.by_force[tilt1] || given.by_force[tilt2])
    for (int i = 0; i < 40 && touching() < enough; ++i) c.half *= 2;
  if (given.by_force[approach]) it.motion[approach] = c.low + 2 * c.half;
  if (!(c.half > 0)) return;
  for (std::size_t k = 0; k < at(p.nodes); ++k) {
    const double depth = p.used[k] ? 1 - (gap_at(p, it.motion, k) - c.low) / c.half : 0;
    it.lambda[2][k] = depth > 0 ? -c.p0 * std::sqrt(depth) : 0.0;
  }
  it.invalidate();
}

double creep_scale(const Problem& p, const Prescribed& given, const Iterate& it, int m) {
  double sum = 0, count = 0, slip = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    const double rt = given.slip_scale * p.rt[k];
    if (!(it.lambda[2][k] < 0) || !(rt > 0)) continue;
    sum += -given.coefficient(p.mu, k) * it.lambda[2][k] / rt;
    ++count;
    for (const auto& image : {it.image[0][k], it.image[1][k]})
      if (std::isfinite(image)) slip = std::max(slip, std::abs(image));
  }
  if (!(sum > 0)) return 0;
  return std::max(sum / count, slip) / (p.motion_scale * (m == spin ? p.length : 1));
}

void start_cold(const Problem& p, const Prescribed& given, Iterate& it) {
  it.clear();
  for (std::size_t m = 0; m < motion_count; ++m)
    if (!given.by_force[m]) it.motion[m] = given.value[m];
  if (!given.by_force[approach]) return;
  double low = INFINITY;
  for (std::size_t k = 0; k < p.gap.size(); ++k)
    if (p.used[k]) low = std::min(low, gap_at(p, it.motion, k));
  if (std::isfinite(low)) it.motion[approach] = low;
}

}  // namespace rollcon
