#include "bodies/bem/far_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bodies/bem/kelvin.hpp"
#include "mesh/box.hpp"

namespace rollcon::bem {
namespace {

constexpr double nearest = 2.5;  ///< distance in half-lengths below which no rule serves
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

double size_near(const SurfaceMesh& mesh) {
  const double size = box_of(mesh.node).longest();
  return size > 0 ? std::exp2(std::round(std::log2(size))) : 1;
}

std::vector<ElementGeometry> geometries(const SurfaceMesh& mesh, double scale) {
  std::vector<ElementGeometry> all;
  all.reserve(static_cast<std::size_t>(mesh.elements()));
  for (std::int64_t e = 0; e < mesh.elements(); ++e) all.push_back(element_geometry(mesh, e, scale));
  return all;
}

FarField::Level FarField::level(const ElementGeometry& e, int direction, int exact, double tolerance_t) {
  constexpr double pi = std::numbers::pi;
  Level level;
  const int m = exact + 1 - e.degree;
  if (m < 1) {
    level.t = level.u[0] = infinity;
    return level;
  }
  // C area R^-2 rho^-m max(1, kappa rho)^k, rho = 1.9 R/a: the larger of two powers of R.
  const double area = 2 * rule_constant * e.shape.area;
  for (int i = 0; i < (e.extra > 0 ? 2 : 1); ++i) {
    const int k = i * std::min(e.extra, m), exponent = level.exponent[i] = m - k;
    const double scale = area * std::exp(k * e.log_departure) * std::pow(e.half[direction] / 1.9, exponent);
    level.t = std::max(level.t, std::pow(scale / (2 * pi * tolerance_t), 1.0 / (exponent + 2)));
    level.u[i] = std::pow(scale / (4 * pi), 1.0 / (exponent + 1));
  }
  level.u[2] = area / (4 * pi) * e.bend * std::exp(-m * e.jacobian_log_rho[direction]);
  return level;
}

FarField::FarField(const std::vector<ElementGeometry>& elements, double tolerance_t) {
  for (const ElementGeometry& e : elements) {
    Element entry;
    entry.nearest = nearest * std::max(e.half[0], e.half[1]);
    entry.triangle = e.corners == 3;
    for (int direction = 0; direction < 2; ++direction)
      for (int k = 0; k < far_levels; ++k) entry.level[direction][k] = level(e, direction, 2 * k + 1, tolerance_t);
    elements_.push_back(entry);
  }
}

FarField::PackFactors::PackFactors(double tolerance_u) {
  for (int m = 0; m <= 2 * far_levels; ++m) power[m] = std::pow(tolerance_u, -1.0 / (m + 1));
}

FarRule FarField::rule(std::size_t element, double distance, int terms, const PackFactors& pack) const {
  const Element& e = elements_[element];
  if (!(distance >= e.nearest)) return {};
  int n[2] = {0, 0};
  for (int direction = 0; direction < (e.triangle ? 1 : 2); ++direction) {
    int k = 0;
    for (; k < far_levels; ++k) {
      const Level& level = e.level[direction][k];
      if ((terms & double_layer) != 0 && distance < level.t) continue;
      if ((terms & single_layer) != 0 &&
          (distance < level.u[0] * pack.power[level.exponent[0]] ||
           distance < level.u[1] * pack.power[level.exponent[1]] || distance < level.u[2] * pack.power[0]))
        continue;
      break;
    }
    if (k == far_levels) return {};
    n[direction] = e.triangle ? 2 * k + 1 : k + 1;
  }
  return {n[0], e.triangle ? n[0] : n[1]};
}

std::size_t FarField::bytes() const {
  return elements_.capacity() * sizeof(Element);
}

}  // namespace rollcon::bem
