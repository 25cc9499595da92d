#pragma once
/// Families of gaps with one parameter, and scenes of strips under them. Lengths in mm, forces in N.

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "framing/strips/strip_bridge.hpp"
#include "framing/strips/strip_results.hpp"
#include "support/testing.hpp"

namespace rollcon::strips {

/// A gap, or its derivative by the parameter at fixed places.
struct FamilyGap : PlaneField {
  enum Kind { ellipse, arcs, corner, slanted_pair, pair, apart, rounded } kind = ellipse;
  double s = 0;
  bool by_parameter = false;
  double a = 1.0 / 920, b = 1.0 / 700, c = 0;  ///< curvatures of ellipses about (s, s/2)

  FamilyGap(Kind of, double parameter) : kind(of), s(parameter) {}

  /// Rail of arcs of 300, 80 and 13 mm.
  static void rail(double y, double* z, double* slope) {
    constexpr double curvature[] = {1 / 300.0, 1 / 80.0, 1 / 13.0}, end[] = {10, 26, 1e9};
    const double side = y < 0 ? -1 : 1, to = std::abs(y);
    double from = 0;
    *z = *slope = 0;
    for (int i = 0; i < 3 && to > from; ++i) {
      const double t = std::min(to, end[i]) - from;
      *z += *slope * t + curvature[i] * t * t / 2;
      *slope += curvature[i] * t;
      from = end[i];
    }
    *slope *= side;
  }

  double value(double x, double y, Vec2* slope) const {
    switch (kind) {
      case ellipse: {
        const double u = x - s, v = y - s / 2;
        *slope = {2 * a * u + c * v, 2 * b * v + c * u};
        const double by = -(*slope)[0] - (*slope)[1] / 2;
        if (by_parameter) *slope = {-2 * a - c / 2, -b - c};
        return by_parameter ? by : a * u * u + b * v * v + c * u * v;
      }
      case arcs:
      case corner: {
        // A hollow wheel, cut by an edge of 1 mm radius.
        double z, dz;
        rail(y, &z, &dz);
        const double wheel = (y - s) / 420 + 0.0095, edge = kind == corner ? std::max(y - 11, 0.0) : 0;
        if (by_parameter) {
          *slope = {0, 1 / 420.0};
          return wheel;
        }
        *slope = {x / 460, dz - wheel + edge};
        return x * x / 920 + z - ((y - s) * (y - s) / 840 + 0.0095 * (y - s)) + edge * edge / 2;
      }
      case slanted_pair: {
        // Two peaks that join, along a line slanted by 45 degrees; s: half their distance over 3 mm.
        const double u = (x + y) / std::numbers::sqrt2, w = (x - y) / std::numbers::sqrt2, q = u * u - 9 * s * s;
        double by_u = 8e-5 * q * u;
        double f = w * w / 240 + 2e-5 * q * q, by_w = w / 120;
        if (by_parameter) f = -7.2e-4 * q * s, by_u = -1.44e-3 * u * s, by_w = 0;
        *slope = {(by_u + by_w) / std::numbers::sqrt2, (by_u - by_w) / std::numbers::sqrt2};
        return f;
      }
      case rounded: {
        // A crowned roller 16 mm long whose ends are rounded by 10 mm, tilted by s.
        const double end = std::max(std::abs(y) - 8, 0.0), side = y < 0 ? -1 : 1;
        *slope = by_parameter ? Vec2{0, 1} : Vec2{x / 460, y / 2000 + side * end / 10 + s};
        return by_parameter ? y : x * x / 920 + y * y / 4000 + end * end / 20 + s * y;
      }
      case apart: {
        // Two bumps across whose half distance is s.
        const double q = y * y - s * s;
        if (by_parameter) {
          *slope = {0, -2.4e-4 * y * s};
          return -1.2e-4 * q * s;
        }
        *slope = {x / 460, 1.2e-4 * q * y + 1e-4};
        return x * x / 920 + 3e-5 * q * q + 1e-4 * y;
      }
      default: {
        // Two bumps across, 14 mm apart, one lower than the other by the tilt s.
        const double q = y * y - 49;
        *slope = by_parameter ? Vec2{0, 1} : Vec2{x / 460, 1.2e-4 * q * y + s};
        return by_parameter ? y : x * x / 920 + 3e-5 * q * q + s * y;
      }
    }
  }
  void at(std::span<const Vec2> point, double* v, Vec2* slope) const override {
    Vec2 ignored;
    for (std::size_t i = 0; i < point.size(); ++i) v[i] = value(point[i][0], point[i][1], slope ? slope + i : &ignored);
  }
};

/// Friction that depends on the place: 1 + part sin(...), or its derivative by part.
struct WavyFriction : PlaneField {
  double part = 0.2;
  bool by_part = false;
  void at(std::span<const Vec2> point, double* v, Vec2* slope) const override {
    for (std::size_t i = 0; i < point.size(); ++i) {
      const double phase = point[i][1] / 4 + point[i][0] / 7, f = by_part ? 1 : part;
      v[i] = (by_part ? 0 : 1) + f * std::sin(phase);
      if (slope) slope[i] = {f * std::cos(phase) / 7, f * std::cos(phase) / 4};
    }
  }
};

/// Two equal bodies, or one on a rigid body; shear modulus and Poisson's number of steel unless said.
inline StripBodies equal_bodies(double shear = 8e4, double nu = 0.28) {
  const double unit = 1 / (2 * std::numbers::pi * shear);
  return {2 * (1 - nu) * unit, 2 * nu * unit, 0};
}
inline StripBodies on_rigid(double shear = 5e4, double nu = 0.3) {
  const double unit = 1 / (2 * std::numbers::pi * shear);
  return {(1 - nu) * unit, nu * unit, (1 - 2 * nu) * unit / 2};
}
/// Body 1 of steel on body 2 of aluminium.
inline StripBodies unlike_bodies() {
  constexpr double unit = 1 / (2 * std::numbers::pi), shear[] = {8.2e4, 2.6e4}, nu[] = {0.28, 0.35};
  return {unit * ((1 - nu[0]) / shear[0] + (1 - nu[1]) / shear[1]), unit * (nu[0] / shear[0] + nu[1] / shear[1]),
          unit / 2 * ((1 - 2 * nu[0]) / shear[0] - (1 - 2 * nu[1]) / shear[1])};
}

struct StripCase {
  FamilyGap gap;
  StripScene scene;

  explicit StripCase(FamilyGap::Kind kind, double s, const StripBodies& bodies = equal_bodies()) : gap(kind, s) {
    scene.bodies = bodies;
    scene.value = 1e5;
    scene.mu = 0.3;
    scene.motion = {1e-3, -5e-4, 2e-4};
  }
  const StripScene& now() {
    scene.gap = &gap;
    return scene;
  }
};

constexpr Rectangle wide{-25, 25, -32, 32};

/// Components of the totals over their sizes: forces and moment over friction's, approach, middle of the pressure.
inline std::array<double, 6> components(const StripTotals& t, double mu) {
  const double limit = mu * t.load, length = 8;
  return {t.force[0] / limit,
          t.force[1] / limit,
          t.force[2] / limit / length,
          t.approach / 0.08,
          t.pressed[0] / t.load / length,
          t.pressed[1] / t.load / length};
}
inline double largest_difference(const std::array<double, 6>& a, const std::array<double, 6>& b) {
  double worst = 0;
  for (int k = 0; k < 6; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}

}  // namespace rollcon::strips
