#pragma once
/// A smooth height over a rectangle of the plane, through values on a regular grid.

#include <cstdint>
#include <vector>

namespace rollcon {

/// Where a grid lies: points along x from x_least to x_greatest, both included, and along y.
struct GridPlace {
  std::int64_t nx = 0, ny = 0;
  double x_least = 0, x_greatest = 0, y_least = 0, y_greatest = 0;
  bool operator==(const GridPlace&) const = default;
};

/// Bicubic between four points, with continuous slopes; exact for polynomials up to the third degree in x and in y.
/// Slopes come from five points in a row, from less beside the end of a row. Infinite values: there is no surface.
class HeightGrid {
 public:
  /// value: line by line from the least y, each from the least x. At least two points each way.
  HeightGrid(const GridPlace& place, const double* value);

  const GridPlace& place() const { return place_; }
  /// +infinity off the grid and in cells with an infinite corner.
  double operator()(double x, double y) const;
  /// Whether a cell without a surface, on the grid, touches the point.
  bool ends_at(double x, double y) const;
  bool same_as(const GridPlace& place, const double* value) const;

 private:
  /// Height, its slopes and their mixed derivative, per interval.
  struct Point {
    double f = 0, fx = 0, fy = 0, fxy = 0;
  };
  /// At a part 0 to 1 of cell (i, j) each way.
  double in_cell(std::int64_t i, double s, std::int64_t j, double t) const;
  double spacing_x() const { return (place_.x_greatest - place_.x_least) / static_cast<double>(place_.nx - 1); }
  double spacing_y() const { return (place_.y_greatest - place_.y_least) / static_cast<double>(place_.ny - 1); }

  GridPlace place_;
  std::vector<Point> point_;
};

}  // namespace rollcon
