#include "tables/spline_basis.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/lu.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

constexpr double value_of_end[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};

void add_end(double* row, std::int64_t outermost, std::int64_t inwards, SplineEnd end) {
  constexpr double flat[] = {-1, 0, 1}, straight[] = {1, -2, 1}, open[] = {1, -4, 6, -4, 1};
  const auto put = [&](std::span<const double> v) {
    for (std::size_t i = 0; i < v.size(); ++i) row[outermost + inwards * static_cast<std::int64_t>(i)] = v[i];
  };
  if (end == SplineEnd::flat) return put(flat);
  if (end == SplineEnd::straight) return put(straight);
  put(open);
}

}  // namespace

SplineWeights spline_weights(double t, std::int64_t intervals) {
  SplineWeights w;
  // NaN takes the first interval: its weights are NaN, too.
  w.first = t > 0 ? static_cast<std::int64_t>(std::min(t, static_cast<double>(intervals - 1))) : 0;
  const double x = t - static_cast<double>(w.first), y = 1 - x;
  w.value[0] = y * y * y / 6;
  w.value[1] = (4 - 6 * x * x + 3 * x * x * x) / 6;
  w.value[2] = (4 - 6 * y * y + 3 * y * y * y) / 6;
  w.value[3] = x * x * x / 6;
  w.slope[0] = -y * y / 2;
  w.slope[1] = (-4 * x + 3 * x * x) / 2;
  w.slope[2] = (4 * y - 3 * y * y) / 2;
  w.slope[3] = x * x / 2;
  return w;
}

SplineFit::SplineFit(std::int64_t intervals, SplineEnd begin, SplineEnd end) : intervals_(intervals) {
  const std::int64_t n = coefficients(), nodes = intervals + 1;
  Lu<double> lu;
  double* a = lu.prepare(n);
  std::fill(a, a + n * n, 0.0);
  for (std::int64_t i = 0; i < nodes; ++i)
    for (std::int64_t j = 0; j < 3; ++j) a[i * n + i + j] = value_of_end[j];
  add_end(a + nodes * n, 0, 1, begin);
  add_end(a + (nodes + 1) * n, n - 1, -1, end);
  if (!lu.factor()) fail(Status::err_internal, "the equations of a spline are singular");
  matrix_.assign(static_cast<std::size_t>(n * nodes), 0.0);
  std::vector<double> b(static_cast<std::size_t>(n));
  for (std::int64_t node = 0; node < nodes; ++node) {
    std::fill(b.begin(), b.end(), 0.0);
    b[static_cast<std::size_t>(node)] = 1;
    lu.solve(b.data());
    for (std::int64_t i = 0; i < n; ++i)
      matrix_[static_cast<std::size_t>(i * nodes + node)] = b[static_cast<std::size_t>(i)];
  }
}

void SplineFit::apply(std::span<const double> value, std::span<double> coefficient) const {
  const std::size_t nodes = value.size();
  for (std::size_t i = 0; i < coefficient.size(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < nodes; ++j) sum += matrix_[i * nodes + j] * value[j];
    coefficient[i] = sum;
  }
}

}  // namespace rollcon
