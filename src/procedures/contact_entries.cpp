/// Entries of a step's whole matrix, column by column.

#include <algorithm>

#include "procedures/contact_equations.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Rows become columns; those of the result ascend, and entries that fall on one another are added.
SparseColumns transposed(const SparseColumns& a) {
  std::vector<std::int64_t> next(at(a.rows + 1), 0);
  for (const std::int64_t i : a.row) ++next[at(i + 1)];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<std::int64_t> end(next.begin(), next.end() - 1);
  std::vector<std::int64_t> row(a.row.size());
  std::vector<double> value(a.row.size());
  for (std::int64_t j = 0; j < a.columns; ++j)
    entries(a, j, [&](std::int64_t i, double v) {
      const std::size_t last = at(end[at(i)]);
      if (end[at(i)] > next[at(i)] && row[last - 1] == j) {
        value[last - 1] += v;
      } else {
        row[last] = j;
        value[last] = v;
        ++end[at(i)];
      }
    });
  SparseColumns t{a.columns, a.rows, {0}, std::move(row), std::move(value)};
  std::int64_t to = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    for (std::int64_t from = next[i]; from < end[i]; ++from, ++to) {
      t.row[at(to)] = t.row[at(from)];
      t.value[at(to)] = t.value[at(from)];
    }
    t.start.push_back(to);
  }
  t.row.resize(at(to));
  t.value.resize(at(to));
  return t;
}

}  // namespace

// R, by unknown of the bodies.
SparseColumns ContactEquations::body_rows() const {
  SparseColumns rows{inner(), static_cast<std::int64_t>(unknown_.size()), {0}, {}, {}};
  for (const Unknown& row : unknown_) {
    for (int r = 0; r < 3; ++r)
      if (const double w = row.image[at(r)]; w != 0)
        images_.per_unknown(row.node, r, [&](std::int64_t i, double v) {
          rows.row.push_back(i);
          rows.value.push_back(w * v);
        });
    rows.start.push_back(static_cast<std::int64_t>(rows.row.size()));
  }
  return transposed(rows);
}

// -B, by unknown traction.
SparseColumns ContactEquations::loads() const {
  SparseColumns loads{inner(), static_cast<std::int64_t>(unknown_.size()), {0}, {}, {}};
  for (const Unknown& column : unknown_) {
    for (int c = 0; c < 3; ++c)
      if (const double t = column.traction[at(c)]; t != 0)
        for (const BodiesEquations::Body& body : bodies_.bodies())
          entries(body.load, 3 * column.node + c, [&](std::int64_t i, double v) {
            loads.row.push_back(body.first + i);
            loads.value.push_back(-t * body.row[at(i)] * v);
          });
    loads.start.push_back(static_cast<std::int64_t>(loads.row.size()));
  }
  return transposed(transposed(loads));
}

void ContactEquations::assemble(SparseMatrix& out) const {
  const SparseColumns rows = body_rows(), loads = this->loads();
  const std::int64_t first = inner(), nu = rows.rows, n = contact_size();
  out.n = size();
  out.start.assign(1, 0);
  out.row.clear();
  out.value.clear();
  const auto add = [&](std::int64_t row, double value) {
    out.row.push_back(row);
    out.value.push_back(value);
  };
  for (const BodiesEquations::Body& body : bodies_.bodies())
    for (std::int64_t j = 0; j < body.equations->unknowns; ++j) {
      body.scaled(j, [&](std::int64_t i, double v) { add(body.first + i, v); });
      entries(rows, body.first + j, [&](std::int64_t a, double v) { add(first + a, v); });
      out.start.push_back(static_cast<std::int64_t>(out.row.size()));
    }
  for (std::int64_t b = 0; b < n; ++b) {
    if (b < nu) entries(loads, b, add);
    for (std::int64_t a = 0; a < n; ++a)
      if (const double v = contact_.row(a)[b]; v != 0 || a == b) add(first + a, v);
    out.start.push_back(static_cast<std::int64_t>(out.row.size()));
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
  const SparseColumns rows = body_rows(), loads = this->loads();
  for (std::int64_t j = 0; j < first; ++j)
    entries(rows, j, [&](std::int64_t a, double v) { dense[first + a + j * n] = v; });
  for (std::int64_t b = 0; b < loads.columns; ++b)
    entries(loads, b, [&](std::int64_t i, double v) { dense[i + (first + b) * n] = v; });
  for (std::int64_t a = 0; a < contact_size(); ++a)
    for (std::int64_t b = 0; b < contact_size(); ++b)
      dense[first + a + (first + b) * n] = contact_.row(a)[b];
}

std::int64_t ContactEquations::nonzeros() const {
  if (inner() == 0) return contact_size() * contact_size();
  const double* first = contact_.data();
  std::int64_t sum = std::count_if(first, first + contact_size() * contact_size(),
                                   [](double v) { return v != 0; });
  const auto count = [&sum](std::int64_t, double) { ++sum; };
  for (const BodiesEquations::Body& body : bodies_.bodies())
    sum += static_cast<std::int64_t>(body.equations->dense.size() +
                                     body.equations->matrix.value.size());
  for (const Unknown& unknown : unknown_)
    for (int c = 0; c < 3; ++c) {
      if (unknown.image[at(c)] != 0) images_.per_unknown(unknown.node, c, count);
      for (const BodiesEquations::Body& body : bodies_.bodies())
        if (unknown.traction[at(c)] != 0) entries(body.load, 3 * unknown.node + c, count);
    }
  return sum;
}

}  // namespace rollcon
