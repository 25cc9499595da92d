/// Computes the entries of a step's whole matrix, column by column.

#include <algorithm>

#include "procedures/contact_equations.hpp"
#include "support/index.hpp"

namespace rollcon {

// Returns R, by unknown of the bodies.
SparseMatrix ContactEquations::body_rows() const {
  SparseBuilder rows(inner());
  for (const Unknown& row : unknown_) {
    for (int r = 0; r < 3; ++r)
      if (const double w = row.image[at(r)]; w != 0)
        images_.per_unknown(row.node, r, [&](std::int64_t i, double v) { rows.add(i, w * v); });
    rows.end_column();
  }
  return transposed(rows.take());
}

// Returns -B, by unknown traction.
SparseMatrix ContactEquations::loads() const {
  SparseBuilder loads(inner());
  for (const Unknown& column : unknown_) {
    for (int c = 0; c < 3; ++c)
      if (const double t = column.traction[at(c)]; t != 0)
        for (const BodiesEquations::Body& body : bodies_.bodies())
          entries(body.load, 3 * column.node + c,
                  [&](std::int64_t i, double v) { loads.add(body.first + i, -t * body.row[at(i)] * v); });
    loads.end_column();
  }
  return loads.take();
}

void ContactEquations::assemble(SparseMatrix& out) const {
  const SparseMatrix rows = body_rows(), loads = this->loads();
  const std::int64_t first = inner(), nu = rows.rows, n = contact_size();
  out.begin(size());
  const auto add = [&](std::int64_t row, double value) { out.push(row, value); };
  for (const BodiesEquations::Body& body : bodies_.bodies())
    for (std::int64_t j = 0; j < body.equations->unknowns; ++j) {
      body.scaled(j, [&](std::int64_t i, double v) { add(body.first + i, v); });
      entries(rows, body.first + j, [&](std::int64_t a, double v) { add(first + a, v); });
      out.end_column();
    }
  for (std::int64_t b = 0; b < n; ++b) {
    if (b < nu) entries(loads, b, add);
    for (std::int64_t a = 0; a < n; ++a)
      if (const double v = contact_.row(a)[b]; v != 0 || a == b) add(first + a, v);
    out.end_column();
  }
}

void ContactEquations::assemble(double* dense) const {
  const std::int64_t first = inner(), n = size();
  std::fill_n(dense, n * n, 0.0);
  for (const BodiesEquations::Body& body : bodies_.bodies())
    for (std::int64_t j = 0; j < body.equations->unknowns; ++j) {
      double* column = dense + (body.first + j) * n;
      body.scaled(j, [&](std::int64_t i, double v) { column[body.first + i] = v; });
    }
  const SparseMatrix rows = body_rows(), loads = this->loads();
  for (std::int64_t j = 0; j < first; ++j)
    entries(rows, j, [&](std::int64_t a, double v) { dense[first + a + j * n] = v; });
  for (std::int64_t b = 0; b < loads.columns; ++b)
    entries(loads, b, [&](std::int64_t i, double v) { dense[i + (first + b) * n] = v; });
  for (std::int64_t a = 0; a < contact_size(); ++a)
    for (std::int64_t b = 0; b < contact_size(); ++b) dense[first + a + (first + b) * n] = contact_.row(a)[b];
}

std::int64_t ContactEquations::nonzeros() const {
  if (inner() == 0) return contact_size() * contact_size();
  const double* first = contact_.data();
  std::int64_t sum = std::count_if(first, first + contact_size() * contact_size(), [](double v) { return v != 0; });
  const auto count = [&sum](std::int64_t, double) { ++sum; };
  for (const BodiesEquations::Body& body : bodies_.bodies())
    sum += static_cast<std::int64_t>(body.equations->dense.size() + body.equations->matrix.value.size());
  for (const Unknown& unknown : unknown_)
    for (int c = 0; c < 3; ++c) {
      if (unknown.image[at(c)] != 0) images_.per_unknown(unknown.node, c, count);
      for (const BodiesEquations::Body& body : bodies_.bodies())
        if (unknown.traction[at(c)] != 0) entries(body.load, 3 * unknown.node + c, count);
    }
  return sum;
}

}  // namespace rollcon
