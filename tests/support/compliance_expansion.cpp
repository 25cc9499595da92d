// Compares unknowns written out with what the same compliance condenses.

#include "linalg/factored_matrix.hpp"
#include "support/compliance_suite.hpp"
#include "support/frame_extent.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// Computes K^-1 B: unknowns x columns, column-major.
std::vector<double> solved_loads(const ExpandedBody& body) {
  const BodyEquations& k = *body.equations;
  const std::int64_t n = k.unknowns;
  FactoredMatrix matrix;
  double* a = matrix.prepare(n);
  if (k.dense.empty()) {
    std::fill_n(a, n * n, 0.0);
    for (std::int64_t c = 0; c < n; ++c)
      for (std::int64_t i = k.matrix.start[at(c)]; i < k.matrix.start[at(c) + 1]; ++i)
        a[k.matrix.row[at(i)] + c * n] = k.matrix.value[at(i)];
  } else {
    std::copy(k.dense.begin(), k.dense.end(), a);
  }
  EXPECT_TRUE(matrix.factor());
  std::vector<double> x(at(n * body.load.columns), 0.0);
  for (std::int64_t c = 0; c < body.load.columns; ++c)
    for (std::int64_t i = body.load.start[at(c)]; i < body.load.start[at(c) + 1]; ++i)
      x[at(body.load.row[at(i)] + c * n)] = body.load.value[at(i)];
  matrix.solve(x.data(), body.load.columns);
  return x;
}

/// Computes P K^-1 B + N.
RowMatrix<double> eliminated(const ExpandedCompliance& e, std::int64_t points, std::int64_t nodes) {
  RowMatrix<double> u;
  u.resize(3 * points, 3 * nodes);
  if (e.direct.empty())
    std::fill_n(u.data(), 9 * points * nodes, 0.0);
  else
    std::copy_n(e.direct.data(), 9 * points * nodes, u.data());
  for (const ExpandedBody& body : e.body) {
    const std::vector<double> x = solved_loads(body);
    const SparseMatrix& p = body.displacement;
    for (std::int64_t r = 0; r < p.columns; ++r)
      for (std::int64_t i = p.start[at(r)]; i < p.start[at(r) + 1]; ++i)
        for (std::int64_t k = 0; k < 3 * nodes; ++k)
          u.row(r)[k] += p.value[at(i)] * x[at(p.row[at(i)] + k * body.equations->unknowns)];
  }
  return u;
}

}  // namespace

double expansion_error(const Frame& frame, const Compliance& compliance) {
  const Extent e(frame);
  std::vector<double> x = frame.x, y = frame.y;
  // The points lie upstream of the nodes, between them, and around the frame: over its neighbours and off it all.
  for (const double factor : {0.83, 1.2, 4.0})
    for (std::size_t k = 0; k < frame.x.size(); k += factor < 1 ? 1 : 5) {
      const double shift = factor < 1 ? -0.07 * e.half_x : 0;
      x.push_back(e.x0 + factor * (frame.x[k] - e.x0) + shift);
      y.push_back(e.y0 + factor * (frame.y[k] - e.y0));
    }
  ExpandedCompliance expanded;
  if (!compliance.expand({x, y}, expanded)) return 1e300;
  const std::size_t n = frame.x.size();
  const RowMatrix<double> u = eliminated(expanded, static_cast<std::int64_t>(x.size()), static_cast<std::int64_t>(n));
  std::vector<double> dense[3][3];
  ComplianceBlock block;
  block.stride = static_cast<std::ptrdiff_t>(n);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      dense[i][j].assign(x.size() * n, 0.0);
      if (compliance.couples() || (i == 2) == (j == 2)) block.a[i][j] = dense[i][j].data();
    }
  compliance.block({x, y}, block);
  double most = 0, error = 0;
  for (std::size_t p = 0; p < x.size(); ++p)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < n; ++k) {
          const double value = dense[i][j][p * n + k];
          most = std::max(most, std::abs(value));
          const double difference = std::abs(u.row(static_cast<std::int64_t>(3 * p + i))[3 * k + j] - value);
          if (!(difference <= error)) error = difference;  // true also for NaN
        }
  return error / most;
}

}  // namespace rollcon
