#include "geometry/height_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/index.hpp"

namespace rollcon {
namespace {

// Returns the slope at point `at` (from 0) of the polynomial through `count` values at 0, 1, 2, ...
template <class Value>
double slope(std::int64_t count, std::int64_t at, const Value& value) {
  double sum = 0;
  for (std::int64_t j = 0; j < count; ++j) {
    // The weight is the slope of the j-th Lagrange polynomial.
    double weight = 0;
    for (std::int64_t m = 0; m < count; ++m) {
      if (m == j) continue;
      double product = 1 / static_cast<double>(j - m);
      for (std::int64_t l = 0; l < count; ++l)
        if (l != j && l != m) product *= static_cast<double>(at - l) / static_cast<double>(j - l);
      weight += product;
    }
    sum += weight * value(j);
  }
  return sum;
}

// Computes slopes along a row of points from the finite values of `of`.
template <class Of, class To>
void slopes(std::int64_t points, const Of& of, const To& to) {
  constexpr std::int64_t most = 5;
  for (std::int64_t first = 0; first < points;) {
    if (!std::isfinite(of(first))) {
      to(first++) = std::numeric_limits<double>::infinity();
      continue;
    }
    std::int64_t end = first;
    while (end < points && std::isfinite(of(end))) ++end;
    const std::int64_t count = std::min(most, end - first);
    for (std::int64_t i = first; i < end; ++i) {
      const std::int64_t from = std::clamp(i - count / 2, first, end - count);
      to(i) = slope(count, i - from, [&](std::int64_t j) { return of(from + j); });
    }
    first = end;
  }
}

// Evaluates the cubic with values f and slopes d at 0 and 1.
double cubic(double t, double f0, double d0, double f1, double d1) {
  const double s = 1 - t;
  return s * s * ((1 + 2 * t) * f0 + t * d0) + t * t * ((1 + 2 * s) * f1 - s * d1);
}

// Returns the slope of that cubic.
double cubic_slope(double t, double f0, double d0, double f1, double d1) {
  const double s = 1 - t;
  return 6 * s * t * (f1 - f0) + s * (1 - 3 * t) * d0 + t * (1 - 3 * s) * d1;
}

struct Cell {
  std::int64_t first = -1;
  double part = 0;  ///< position in the cell, 0 to 1
};

Cell cell(double x, double least, double spacing, std::int64_t points) {
  constexpr double rounding = 1e-9;  // fraction of an interval
  const double place = (x - least) / spacing, last = static_cast<double>(points - 1);
  if (!(place >= -rounding && place <= last + rounding)) return {};
  const double first = std::clamp(std::floor(place), 0.0, last - 1);
  return {to_index(first), std::clamp(place - first, 0.0, 1.0)};
}

}  // namespace

HeightGrid::HeightGrid(const GridPlace& place, const double* value) : place_(place), point_(at(place.nx * place.ny)) {
  const std::int64_t nx = place.nx, ny = place.ny;
  for (std::size_t k = 0; k < point_.size(); ++k) point_[k].f = value[k];
  const auto point = [&](std::int64_t i, std::int64_t j) -> Point& { return point_[at(j * nx + i)]; };
  for (std::int64_t j = 0; j < ny; ++j)
    slopes(
        nx, [&](std::int64_t i) { return point(i, j).f; }, [&](std::int64_t i) -> double& { return point(i, j).fx; });
  for (std::int64_t i = 0; i < nx; ++i) {
    slopes(
        ny, [&](std::int64_t j) { return point(i, j).f; }, [&](std::int64_t j) -> double& { return point(i, j).fy; });
    slopes(
        ny, [&](std::int64_t j) { return point(i, j).fx; }, [&](std::int64_t j) -> double& { return point(i, j).fxy; });
  }
}

double HeightGrid::operator()(double x, double y, Vec2* slope) const {
  const Cell a = cell(x, place_.x_least, spacing_x(), place_.nx), b = cell(y, place_.y_least, spacing_y(), place_.ny);
  if (a.first < 0 || b.first < 0) return std::numeric_limits<double>::infinity();
  // Points between two cells belong to both; the surface may end there.
  constexpr double rounding = 1e-9;
  const auto cells = [](const Cell& c) {
    std::array<Cell, 2> both{c, c};
    if (c.part < rounding && c.first > 0) both[1] = {c.first - 1, 1};
    if (c.part > 1 - rounding) both[1] = {c.first + 1, 0};
    return both;
  };
  for (const Cell& cell_x : cells(a))
    for (const Cell& cell_y : cells(b))
      if (const double height = in_cell(cell_x.first, cell_x.part, cell_y.first, cell_y.part, slope);
          std::isfinite(height))
        return height;
  return std::numeric_limits<double>::infinity();
}

double HeightGrid::in_cell(std::int64_t i, double s, std::int64_t j, double t, Vec2* slope) const {
  if (i + 1 >= place_.nx || j + 1 >= place_.ny) return std::numeric_limits<double>::infinity();
  const Point* const low = &point_[at(j * place_.nx + i)];
  const Point* const high = low + place_.nx;
  for (const Point* p : {low, low + 1, high, high + 1})
    if (!std::isfinite(p->f)) return p->f;
  const auto along = [&](const Point* p) {
    return std::array{cubic(s, p[0].f, p[0].fx, p[1].f, p[1].fx), cubic(s, p[0].fy, p[0].fxy, p[1].fy, p[1].fxy)};
  };
  const auto [f0, d0] = along(low);
  const auto [f1, d1] = along(high);
  if (slope) {
    const auto by_x = [&](const Point* p) {
      return std::array{cubic_slope(s, p[0].f, p[0].fx, p[1].f, p[1].fx),
                        cubic_slope(s, p[0].fy, p[0].fxy, p[1].fy, p[1].fxy)};
    };
    const auto [fx0, dx0] = by_x(low);
    const auto [fx1, dx1] = by_x(high);
    *slope = {cubic(t, fx0, dx0, fx1, dx1) / spacing_x(), cubic_slope(t, f0, d0, f1, d1) / spacing_y()};
  }
  return cubic(t, f0, d0, f1, d1);
}

bool HeightGrid::ends_at(double x, double y) const {
  constexpr double beside = 1e-6;  // fraction of an interval
  const double dx = beside * spacing_x(), dy = beside * spacing_y();
  for (const double sx : {-dx, 0.0, dx})
    for (const double sy : {-dy, 0.0, dy}) {
      const bool on_grid = x + sx > place_.x_least && x + sx < place_.x_greatest && y + sy > place_.y_least &&
                           y + sy < place_.y_greatest;
      if (on_grid && !std::isfinite((*this)(x + sx, y + sy))) return true;
    }
  return false;
}

bool HeightGrid::same_as(const GridPlace& place, const double* value) const {
  if (!(place == place_)) return false;
  for (std::size_t k = 0; k < point_.size(); ++k)
    if (point_[k].f != value[k]) return false;
  return true;
}

}  // namespace rollcon
