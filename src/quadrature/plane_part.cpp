#include "quadrature/plane_part.hpp"

#include <cmath>
#include <utility>

#include "quadrature/ellipse.hpp"

namespace rollcon::quadrature {
namespace {

constexpr double negligible = 1e-13;  ///< height above the plane, in half lengths, equal to that of element_geometry

}  // namespace

Vec2 PlanePart::corner(int i) const {
  constexpr double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double xi = square[i % 4][0], eta = square[i % 4][1];
  return {xi + alpha * xi * eta, eta + beta * xi * eta};
}

Vec2 PlanePart::local(Vec2 at) const {
  const double u = beta * at.x - alpha * at.y, root2 = 1 + 2 * (beta * at.x + alpha * at.y) + u * u;
  const double real = root2 > 0 ? std::sqrt(root2) : 0, imaginary2 = root2 > 0 ? 0 : -root2;
  const auto solve = [&](double value, double c) { return 2 * value * c / (c * c + imaginary2); };
  return {solve(at.x, 1 - u + real), solve(at.y, 1 + u + real)};
}

void PlanePart::place(Vec2& at, double& weight) const {
  const Vec2 half1 = 0.5 * (cell.corner[1] - cell.corner[0]), half2 = 0.5 * (cell.corner[3] - cell.corner[0]);
  const Vec2 x = local(at);
  at = cell.centre() + x.x * half1 + x.y * half2;
  weight *= cross(half1, half2) / (1 + alpha * x.y + beta * x.x);
}

std::optional<PlanePart> plane_part(const ElementGeometry& element, const Cell& cell, const CellShape& shape) {
  if (element.map == MapKind::curved || cell.corners != 4) return {};
  const Vec3(&c)[4] = shape.corner;
  const Vec3 a = 0.25 * (c[1] + c[2] - c[0] - c[3]), b = 0.25 * (c[2] + c[3] - c[0] - c[1]),
             d = 0.25 * (c[0] + c[2] - c[1] - c[3]), centre = 0.25 * (c[0] + c[1] + c[2] + c[3]), normal = cross(a, b);
  const double area2 = dot(normal, normal);
  if (!(area2 > 0) || std::abs(dot(d, normal)) > negligible * shape.half_length * std::sqrt(area2)) return {};
  std::optional<PlanePart> part(std::in_place);
  part->cell = cell;
  part->alpha = dot(cross(d, b), normal) / area2;
  part->beta = dot(cross(a, d), normal) / area2;
  const double near = std::sqrt(std::abs(part->alpha)) + std::sqrt(std::abs(part->beta));
  part->series_log = near < 1 ? log_rho(1 / (near * near)) : 0;
  const Vec3 corner[3] = {centre, centre + a, centre + b};
  part->affine = element_geometry(ElementType::tri3, corner);
  part->affine.degree = ray_degree(element.type, MapKind::affine);
  part->affine.series_log = part->series_log;
  part->foot = find_foot(part->affine, {0, 0}, false);
  return part;
}

}  // namespace rollcon::quadrature
