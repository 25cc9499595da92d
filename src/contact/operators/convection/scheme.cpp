/// A scheme's rows and samples.

#include <cmath>

#include "contact/operators/convection/convection.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

// (w(x_I) - w(x_I + delta e)) / delta, both displacements exact.
SparseRows differences(const std::vector<double>& ahead) {
  SparseRows rows;
  const std::size_t n = ahead.size();
  rows.start.push_back(0);
  for (std::size_t k = 0; k < n; ++k) {
    if (ahead[k] > 0) {
      rows.column.push_back(static_cast<std::int32_t>(k));
      rows.value.push_back(1 / ahead[k]);
      rows.column.push_back(static_cast<std::int32_t>(n + k));
      rows.value.push_back(-1 / ahead[k]);
    }
    rows.start.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  return rows;
}

void follow_surface(const Frame& frame, SparseRows& rows) {
  for (std::size_t i = 0; i < frame.t1.size(); ++i)
    for (auto k = at(rows.start[i]); k < at(rows.start[i + 1]); ++k)
      rows.value[k] *= dot(frame.t1[i], frame.axes.t1);
}

}  // namespace

Convection make_convection(const Frame& frame, Scheme scheme, double step) {
  Convection c;
  c.slip_x = frame.x;
  c.slip_y = frame.y;
  switch (scheme) {
    case Scheme::godunov:
      c.rows = godunov(frame, 1, 0);
      break;
    case Scheme::least_squares:
      c.rows = least_squares(frame, 1, 0);
      break;
    case Scheme::characteristic:
      c.ahead = characteristic_steps(frame, step);
      c.rows = differences(c.ahead);
      // Second order: the difference is centred half a step upstream.
      for (std::size_t i = 0; i < c.ahead.size(); ++i) c.slip_x[i] += c.ahead[i] / 2;
  }
  if (frame.curved()) follow_surface(frame, c.rows);
  return c;
}

void convect(const Convection& convection, const double* w, const double* ahead,
             std::vector<double> (&slip)[2]) {
  const SparseRows& d = convection.rows;
  const std::size_t n = convection.slip_x.size();
  for (std::size_t c = 0; c < 2; ++c) {
    slip[c].assign(n, 0.0);
    for (std::size_t k = 0; k < n; ++k)
      for (auto j = at(d.start[k]); j < at(d.start[k + 1]); ++j) {
        const std::size_t sample = at(d.column[j]);
        slip[c][k] += d.value[j] * (sample < n ? w[3 * sample + c] : ahead[3 * (sample - n) + c]);
      }
  }
}

}  // namespace rollcon
