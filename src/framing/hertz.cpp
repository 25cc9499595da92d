#include "framing/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rollcon {
namespace {

constexpr double pi = std::numbers::pi;

// Holds the complete elliptic integrals of m = 1 - k^2: K, and D = (K - E) / m, which keeps its digits for circles.
struct Elliptic {
  double k, d;
};

// Uses the arithmetic-geometric mean; c_n^2 is over m, as c_0^2 = m.
Elliptic elliptic(double ratio) {
  const double m = (1 - ratio) * (1 + ratio);
  double a = 1, g = ratio, sum = 0.5, power = 1, c = m / (1 + ratio) / 2, c2_over_m = c / (1 + ratio) / 2;
  for (int n = 1; n < 40; ++n) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
    sum += power * c2_over_m;
    if (!(std::abs(c) > 1e-17 * a)) break;
    const double shrink = c / (2 * (a + g));
    c2_over_m *= shrink * shrink;
    c *= shrink;
    power *= 2;
  }
  const double k = pi / (2 * a);
  return {k, k * sum};
}

// Returns the smaller over the larger curvature of the gap, for an ellipse of this ratio of semi-axes.
double curvature_ratio(double ratio) {
  const Elliptic e = elliptic(ratio);
  return ratio * ratio * e.d / (e.k - e.d);
}

// Inverts curvature_ratio() by secants in logarithms: nearly a straight line.
double axis_ratio(double curvatures) {
  const double wanted = std::log(curvatures);
  if (wanted > -1e-15) return 1;
  double x0 = 0, f0 = -wanted, x1 = 0.64 * wanted;
  for (int i = 0; i < 60; ++i) {
    const double f1 = std::log(curvature_ratio(std::exp(x1))) - wanted;
    if (std::abs(f1) < 1e-14 * (1 - wanted) || f1 == f0) break;
    const double x2 = std::min(x1 - f1 * (x1 - x0) / (f1 - f0), 0.0);
    x0 = x1;
    f0 = f1;
    x1 = x2;
    if (x0 == x1) break;
  }
  return std::exp(x1);
}

// Holds the shape of the contact, of unit larger semi-axis, in the principal directions of the gap.
struct Shape {
  double least = 0;              ///< curvature of the gap along the larger semi-axis
  double ratio = 1;              ///< smaller over larger semi-axis
  double along = 1, across = 0;  ///< direction of the larger semi-axis
  Elliptic integrals{};
};

Shape shape_of(const QuadraticGap& gap) {
  Shape s;
  // The smaller eigenvalue of [a c/2; c/2 b] comes from the determinant, without cancellation.
  const double half = (gap.a - gap.b) / 2, mixed = gap.c / 2, mean = (gap.a + gap.b) / 2;
  const double radius = std::hypot(half, mixed), largest = mean + radius;
  s.least = (gap.a * gap.b - mixed * mixed) / largest;
  s.ratio = axis_ratio(std::min(s.least / largest, 1.0));
  s.integrals = elliptic(s.ratio);
  // The eigenvector of the smaller one is across that of the larger one, (half + radius, mixed) or (mixed, radius -
  // half).
  if (radius > 0) {
    double u = half >= 0 ? half + radius : mixed, v = half >= 0 ? mixed : radius - half;
    const double norm = std::hypot(u, v);
    s.along = -v / norm;
    s.across = u / norm;
  }
  return s;
}

HertzContact finish(const Shape& s, double larger, double load, double approach) {
  HertzContact h;
  h.larger = larger;
  h.smaller = s.ratio * larger;
  h.angle = std::atan2(s.across, s.along);
  h.load = load;
  h.approach = approach;
  const double area = pi * h.larger * h.smaller;
  h.pressure = area > 0 ? 1.5 * load / area : 0;
  return h;
}

}  // namespace

bool has_ellipse(const QuadraticGap& gap) {
  constexpr double least = 1e-10;  // fraction of the larger curvature: longer than 5,000,000 times as wide
  const double sum = gap.a + gap.b;
  return sum > 0 && gap.a * gap.b - gap.c * gap.c / 4 > least * sum * sum;
}

HertzContact hertz_by_load(const QuadraticGap& gap, double modulus, double load) {
  const Shape s = shape_of(gap);
  const double larger = std::cbrt(3 * load * s.integrals.d / (2 * pi * modulus * s.least));
  const double approach = larger > 0 ? 3 * load * s.integrals.k / (2 * pi * modulus * larger) : 0;
  return finish(s, larger, load, approach);
}

HertzContact hertz_by_approach(const QuadraticGap& gap, double modulus, double approach) {
  const Shape s = shape_of(gap);
  const double depth = std::max(approach, 0.0);
  const double larger = std::sqrt(depth * s.integrals.d / (s.integrals.k * s.least));
  return finish(s, larger, 2 * pi * larger * modulus * depth / (3 * s.integrals.k), approach);
}

QuadraticGap gap_with_ratio(double ratio, double modulus) {
  constexpr double curvature = 1e-3;
  double low = -16, high = 16;
  QuadraticGap gap;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);  // logarithm of the ratio of curvatures
    gap = {curvature * std::exp(-middle / 2), curvature * std::exp(middle / 2), 0};
    const HertzContact hertz = hertz_by_load(gap, modulus, 1);
    const double found = middle > 0 ? hertz.larger / hertz.smaller : hertz.smaller / hertz.larger;
    (found < ratio ? low : high) = middle;
  }
  return gap;
}

double stretch_by_friction(double dundurs_beta, double friction) {
  // Unstretched frames of a body on a rigid one under mu = 0.3 tend to forces that are off by up to 1.5 %.
  constexpr double moved = 0.12, most_moved = 0.03;
  return 1 + std::min(most_moved, moved * std::abs(dundurs_beta) * friction);
}

}  // namespace rollcon
