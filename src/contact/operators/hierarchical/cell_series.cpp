#include "contact/operators/hierarchical/cell_series.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int most_points = 16;
// Points lie in a square that holds what hangs over.
constexpr double stretch = 1 + 2 * SquareCells::overhang;
// The nearest squares that are far from each other leave a gap of (4 - stretch) half widths: the reciprocal of this
// Bernstein ellipse's sum of semi-axes is the factor.
const double falls_by = (4 - stretch) / stretch + std::sqrt((4 - stretch) * (4 - stretch) / (stretch * stretch) - 1);

}  // namespace

// Sums over many squares are off by a hundredth of what the worst pair is: fewer points do.
CellSeries::CellSeries(double accuracy)
    : line_(std::clamp(static_cast<int>(std::ceil(-std::log(accuracy) / std::log(falls_by))) - 2, 4, most_points)) {
  for (int p = 0; p < line_; ++p) {
    const double angle = std::numbers::pi * (p + 0.5) / line_;
    node_.push_back(stretch * std::cos(angle));
    for (int k = 0; k < line_; ++k) chebyshev_.push_back((k == 0 ? 1.0 : 2.0) / line_ * std::cos(k * angle));
  }
  for (int q = 0; q < 4; ++q) {
    part_[q].resize(points(), points());
    std::vector<double> value(at(points()));
    for (int py = 0; py < line_; ++py)
      for (int px = 0; px < line_; ++px) {
        std::fill(value.begin(), value.end(), 0.0);
        add((q % 2 == 1 ? 0.5 : -0.5) + 0.5 * node_[at(px)], (q / 2 == 1 ? 0.5 : -0.5) + 0.5 * node_[at(py)], 1,
            value.data());
        for (int row = 0; row < points(); ++row) part_[q].row(row)[py * line_ + px] = value[at(row)];
      }
  }
}

// Computes the shape functions of the points along an axis by Chebyshev's polynomials.
void CellSeries::line(double at, double* value) const {
  const double t = at / stretch;
  double polynomial[most_points] = {1, t};
  for (int k = 2; k < line_; ++k) polynomial[k] = 2 * t * polynomial[k - 1] - polynomial[k - 2];
  for (int p = 0; p < line_; ++p) {
    double sum = 0;
    for (int k = 0; k < line_; ++k) sum += chebyshev_[static_cast<std::size_t>(p * line_ + k)] * polynomial[k];
    value[p] = sum;
  }
}

void CellSeries::add(double x, double y, double factor, double* value) const {
  double along[most_points], across[most_points];
  line(x, along);
  line(y, across);
  for (int py = 0; py < line_; ++py)
    for (int px = 0; px < line_; ++px) value[py * line_ + px] += factor * across[py] * along[px];
}

std::array<RowMatrix<double>, point_displacements> CellSeries::transfer(const TranslationKernel& kernel,
                                                                        const CellShift& shift) const {
  std::array<RowMatrix<double>, point_displacements> matrix;
  for (int k = 0; k < point_displacements; ++k)
    if (k == 0 || (k < 4 ? kernel.shears() : kernel.couples())) matrix[at(k)].resize(points(), points());
  const double source = 0.5, target = std::ldexp(source, -shift.finer), unit = std::min(source, target);
  const double dx = unit * static_cast<double>(shift.di), dy = unit * static_cast<double>(shift.dj);
  for (int t = 0; t < points(); ++t)
    for (int s = 0; s < points(); ++s) {
      const auto u = kernel.of_point(dx + target * node_[at(t % line_)] - source * node_[at(s % line_)],
                                     dy + target * node_[at(t / line_)] - source * node_[at(s / line_)]);
      for (std::size_t k = 0; k < matrix.size(); ++k)
        if (!matrix[k].empty()) matrix[k].row(t)[s] = u[k];
    }
  return matrix;
}

}  // namespace rollcon
