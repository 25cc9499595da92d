#pragma once
/// Interpolates a smooth height over a rectangle of the plane through values on a regular grid.

#include <cstdint>
#include <vector>

#include "geometry/vec2.hpp"

namespace rollcon {

/// Says where a grid lies: its points along x run from x_least to x_greatest, both included, and so along y.
struct GridPlace {
  std::int64_t nx = 0, ny = 0;
  double x_least = 0, x_greatest = 0, y_least = 0, y_greatest = 0;
  bool operator==(const GridPlace&) const = default;
};

/// Is bicubic between four points, with continuous slopes, and exact for polynomials up to the third degree in x and in
/// y. Slopes come from five points in a row, from fewer beside the end of a row. Infinite values mark where there is no
/// surface.
class HeightGrid {
 public:
  /// Takes values line by line from the least y, each line from the least x, with at least two points each way.
  HeightGrid(const GridPlace& place, const double* value);

  const GridPlace& place() const { return place_; }
  /// Returns +infinity off the grid and in cells with an infinite corner; else fills in the slopes by x and y, if
  /// wanted.
  double operator()(double x, double y, Vec2* slope = nullptr) const;
  /// Says whether a cell of the grid without a surface touches the point.
  bool ends_at(double x, double y) const;
  bool same_as(const GridPlace& place, const double* value) const;

 private:
  /// Holds the height, its slopes and their mixed derivative, per interval.
  struct Point {
    double f = 0, fx = 0, fy = 0, fxy = 0;
  };
  /// Returns the height in cell (i, j) at the positions s and t, each from 0 to 1.
  double in_cell(std::int64_t i, double s, std::int64_t j, double t, Vec2* slope) const;
  double spacing_x() const { return (place_.x_greatest - place_.x_least) / static_cast<double>(place_.nx - 1); }
  double spacing_y() const { return (place_.y_greatest - place_.y_least) / static_cast<double>(place_.ny - 1); }

  GridPlace place_;
  std::vector<Point> point_;
};

}  // namespace rollcon
