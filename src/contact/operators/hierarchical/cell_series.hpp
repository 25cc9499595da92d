#pragma once
/// Interpolates kernels between two squares that are far from each other, at Chebyshev's points of both: the error
/// falls by a factor of about 4 with each point along an axis.

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/model/translation.hpp"
#include "contact/operators/hierarchical/square_cells.hpp"
#include "linalg/dense.hpp"

namespace rollcon {

class CellSeries {
 public:
  /// Takes the relative accuracy, from which the number of points follows.
  explicit CellSeries(double accuracy);

  int points() const { return line_ * line_; }  ///< number of points of a square
  /// Adds factor times the shape functions of a square's points to value[points()], at a place (x, y) in half widths
  /// from its centre.
  void add(double x, double y, double factor, double* value) const;
  /// Returns the shape functions of a square's points [row] at the points of its part q [column]: the second half along
  /// x where q is odd, along y where q is 2 or 3.
  const RowMatrix<double>& part(int q) const { return part_[q]; }
  /// Returns the kernels between the points of a target [row] and a source [column] whose width is 1, without those
  /// that the kernel leaves out: [entry of PointDisplacements].
  std::array<RowMatrix<double>, point_displacements> transfer(const TranslationKernel& kernel,
                                                              const CellShift& shift) const;

 private:
  void line(double at, double* value) const;

  int line_;                       ///< number of points along an axis
  std::vector<double> node_;       ///< points, in half widths
  std::vector<double> chebyshev_;  ///< [point][order], times the weight
  RowMatrix<double> part_[4];
};

}  // namespace rollcon
