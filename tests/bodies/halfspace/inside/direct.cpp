#include "bodies/halfspace/inside/direct.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "bodies/halfspace/interior.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace rollcon::inside {
namespace {

/// Is a part of the reference square, or of a triangle collapsed at its first corner.
struct Part {
  double u, v, half;
};

struct Element {
  ElementType type;
  std::vector<double> x, y;
  std::vector<std::array<double, 3>> t;
};

/// Computes position, weight and forces at (u, v) in [-1, 1]^2.
void sample(const Element& e, double u, double v, double& x, double& y, double& jacobian, std::array<double, 3>& t) {
  double xi = u, eta = v, map = 1;
  if (corner_count(e.type) == 3) {
    const double s = 0.5 * (1 + u), r = 0.5 * (1 + v);  // s towards the far side, r along it
    xi = s * (1 - r), eta = s * r, map = 0.25 * s;
  }
  Shape shape;
  evaluate_shape(e.type, xi, eta, shape);
  double xu = 0, xv = 0, yu = 0, yv = 0;
  x = y = 0;
  t = {0, 0, 0};
  for (std::size_t k = 0; k < e.x.size(); ++k) {
    x += shape.value[k] * e.x[k], y += shape.value[k] * e.y[k];
    xu += shape.d_xi[k] * e.x[k], xv += shape.d_eta[k] * e.x[k];
    yu += shape.d_xi[k] * e.y[k], yv += shape.d_eta[k] * e.y[k];
    for (std::size_t j = 0; j < 3; ++j) t[j] += shape.value[k] * e.t[k][j];
  }
  jacobian = map * (xu * yv - xv * yu);
}

void integrate(const Element& e, const Part& part, const Solid& solid, double px, double py, double pz, Values& sum) {
  double x, y, jacobian, corner_x, corner_y, radius = 0;
  std::array<double, 3> t;
  sample(e, part.u, part.v, x, y, jacobian, t);
  for (const double su : {-1.0, 1.0})
    for (const double sv : {-1.0, 1.0}) {
      sample(e, part.u + su * part.half, part.v + sv * part.half, corner_x, corner_y, jacobian, t);
      radius = std::max(radius, std::hypot(corner_x - x, corner_y - y));
    }
  const double distance = std::hypot(px - x, py - y, pz);
  if (radius > 0.6 * distance && part.half > 1e-6) {
    for (const double su : {-0.5, 0.5})
      for (const double sv : {-0.5, 0.5})
        integrate(e, {part.u + su * part.half, part.v + sv * part.half, 0.5 * part.half}, solid, px, py, pz, sum);
    return;
  }
  static const LineRule rule = gauss_legendre(14);
  for (std::size_t i = 0; i < rule.x.size(); ++i)
    for (std::size_t j = 0; j < rule.x.size(); ++j) {
      sample(e, part.u + part.half * rule.x[i], part.v + part.half * rule.x[j], x, y, jacobian, t);
      const double w = part.half * part.half * rule.w[i] * rule.w[j] * jacobian;
      const Values v = point_force(solid, {w * t[0], w * t[1], w * t[2]}, px - x, py - y, pz);
      for (std::size_t k = 0; k < 9; ++k) sum[k] += v[k];
    }
}

/// Applies a force along x, Johnson (3.75).
Values cerruti(const Solid& solid, double q, double x, double y, double z) {
  const double r = std::hypot(x, y, z), k = 1 - 2 * solid.poisson, p = r + z;
  const double r3 = r * r * r, r5 = r3 * r * r, s = q / (2 * std::numbers::pi);
  const double m = q / (4 * std::numbers::pi * solid.shear);
  const double p2 = p * p, p3 = p2 * p, r2 = r * r;
  return {
      s * (-3 * x * x * x / r5 + k * (x / r3 - 3 * x / (r * p2) + x * x * x / (r3 * p2) + 2 * x * x * x / (r2 * p3))),
      s * (-3 * x * y * y / r5 + k * (x / r3 - x / (r * p2) + x * y * y / (r3 * p2) + 2 * x * y * y / (r2 * p3))),
      s * (-3 * x * z * z / r5),
      s * (-3 * x * x * y / r5 + k * (-y / (r * p2) + x * x * y / (r3 * p2) + 2 * x * x * y / (r2 * p3))),
      s * (-3 * x * x * z / r5),
      s * (-3 * x * y * z / r5),
      m * (1 / r + x * x / r3 + k * (1 / p - x * x / (r * p2))),
      m * (x * y / r3 - k * x * y / (r * p2)),
      m * (x * z / r3 + k * x / (r * p))};
}

/// Applies a force along z, Johnson (3.18) and (3.19), written without the distance from the axis.
Values boussinesq(const Solid& solid, double f, double x, double y, double z) {
  const double r = std::hypot(x, y, z), k = 1 - 2 * solid.poisson, p = r + z;
  const double r3 = r * r * r, r5 = r3 * r * r, s = f / (2 * std::numbers::pi);
  const double m = f / (4 * std::numbers::pi * solid.shear), c = (2 * r + z) / (p * p * r3);
  return {s * (-3 * x * x * z / r5 + k * (z / r3 - 1 / (r * p) + x * x * c)),
          s * (-3 * y * y * z / r5 + k * (z / r3 - 1 / (r * p) + y * y * c)),
          s * (-3 * z * z * z / r5),
          s * (-3 * x * y * z / r5 + k * x * y * c),
          s * (-3 * x * z * z / r5),
          s * (-3 * y * z * z / r5),
          m * (x * z / r3 - k * x / (r * p)),
          m * (y * z / r3 - k * y / (r * p)),
          m * (z * z / r3 + 2 * (1 - solid.poisson) / r)};
}

}  // namespace

Values point_force(const Solid& solid, const std::array<double, 3>& f, double x, double y, double z) {
  const Values a = cerruti(solid, f[0], x, y, z), c = boussinesq(solid, f[2], x, y, z);
  // A force along y needs the axes turned by a right angle, x' = y, y' = -x.
  const Values b = cerruti(solid, f[1], y, -x, z);
  const Values turned = {b[1], b[0], b[2], -b[3], -b[5], b[4], -b[7], b[6], b[8]};
  Values sum;
  for (std::size_t k = 0; k < 9; ++k) sum[k] = a[k] + turned[k] + c[k];
  return sum;
}

Values direct(const Frame& frame, const std::vector<double>& traction, const Solid& solid, double x, double y,
              double z) {
  Values sum{};
  for (std::int64_t i = 0; i < frame.elements(); ++i) {
    Element e{frame.mesh.type[static_cast<std::size_t>(i)], {}, {}, {}};
    for (const std::int32_t id : frame.mesh.element(i)) {
      const auto k = static_cast<std::size_t>(id);
      e.x.push_back(frame.x[k]);
      e.y.push_back(frame.y[k]);
      e.t.push_back({traction[3 * k], traction[3 * k + 1], traction[3 * k + 2]});
    }
    integrate(e, {0, 0, 1}, solid, x, y, z, sum);
  }
  return sum;
}

std::vector<Values> from_library(const Frame& frame, const std::vector<double>& traction, const Solid& solid,
                                 const std::vector<std::array<double, 3>>& points, double accuracy) {
  const HalfspaceInterior interior(frame, traction.data(), {solid.shear, solid.poisson}, accuracy);
  std::vector<double> xyz, stress(6 * points.size()), u(3 * points.size());
  for (const auto& p : points) xyz.insert(xyz.end(), p.begin(), p.end());
  interior.evaluate(static_cast<std::int64_t>(points.size()), xyz.data(), stress.data(), u.data(), 1);
  std::vector<Values> values(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::copy_n(stress.begin() + static_cast<std::ptrdiff_t>(6 * p), 6, values[p].begin());
    std::copy_n(u.begin() + static_cast<std::ptrdiff_t>(3 * p), 3, values[p].begin() + 6);
  }
  return values;
}

std::vector<double> random_load(const Frame& frame, std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  std::vector<double> t(3 * frame.x.size());
  for (double& v : t) v = between(engine);
  return t;
}

double stress_difference(const Values& a, const Values& b) {
  double worst = 0;
  for (std::size_t k = 0; k < 6; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}

double motion_difference(const Values& a, const Values& b) {
  double worst = 0;
  for (std::size_t k = 6; k < 9; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  return worst;
}

}  // namespace rollcon::inside
