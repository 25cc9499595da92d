#include "procedures/bodies_equations.hpp"

#include <algorithm>
#include <cmath>

#include "build_info.hpp"
#include "linalg/lapack.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

double largest(const std::vector<double>& v) {
  double m = 0;
  for (const double x : v) m = std::max(m, std::abs(x));
  return m;
}

// Scales the unknowns so that times scale they are tractions: the largest entry of each column of K then equals the
// largest one of B. Rows are divided by their largest entry. Both carry the units along, whatever the unknowns are
// (displacements, reactions).
void set_scales(BodiesEquations::Body& body) {
  const double unit = std::max(largest(body.load.value), 1e-300);
  const std::int64_t n = body.equations->unknowns;
  body.column.assign(at(n), 1.0);
  body.row.assign(at(n), 1.0);
  std::vector<double> row(at(n), 0.0);
  for (std::int64_t j = 0; j < n; ++j) {
    double most = 0;
    body.scaled(j, [&](std::int64_t, double v) { most = std::max(most, std::abs(v)); });
    if (most > 0) body.column[at(j)] = unit / most;
    body.scaled(j, [&](std::int64_t i, double v) { row[at(i)] = std::max(row[at(i)], std::abs(v)); });
  }
  for (std::int64_t j = 0; j < body.load.columns; ++j)
    entries(body.load, j, [&](std::int64_t i, double v) { row[at(i)] = std::max(row[at(i)], std::abs(v)); });
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i] > 0) body.row[i] = 1 / row[i];
}

SparseMatrix lower_triangle(const SparseMatrix& whole) {
  SparseMatrix lower;
  lower.begin(whole.rows);
  for (std::int64_t j = 0; j < whole.columns; ++j) {
    entries(whole, j, [&](std::int64_t i, double v) {
      if (i >= j) lower.push(i, v);
    });
    lower.end_column();
  }
  return lower;
}

// Returns the row in which each unknown of a dense matrix weighs most; an unknown whose row is taken gets its heaviest
// free one.
std::vector<std::int64_t> heaviest_rows(const BodiesEquations::Body& body) {
  const std::int64_t n = body.equations->unknowns;
  std::vector<std::int64_t> heaviest(at(n), -1);
  std::vector<char> taken(at(n), 0);
  for (int pass = 0; pass < 2; ++pass)
    for (std::int64_t j = 0; j < n; ++j) {
      if (heaviest[at(j)] >= 0) continue;
      std::int64_t best = -1;
      double weight = -1;
      body.scaled(j, [&](std::int64_t i, double v) {
        if (std::abs(v) > weight && (pass == 0 || !taken[at(i)])) weight = std::abs(v), best = i;
      });
      if (best < 0 || taken[at(best)]) continue;  // left for the second pass
      taken[at(best)] = 1;
      heaviest[at(j)] = best;
    }
  return heaviest;
}

}  // namespace

BodiesEquations::BodiesEquations(ExpandedCompliance& expanded) {
  for (ExpandedBody& from : expanded.body) {
    Body& body = body_.emplace_back();
    body.equations = std::move(from.equations);
    body.first = unknowns_;
    body.load = std::move(from.load);
    set_scales(body);
    unknowns_ += body.equations->unknowns;
  }
}

void BodiesEquations::balance(const double* d, const double* t, double* y) const {
  std::vector<double> scaled;
  for (const Body& body : body_) {
    const BodyEquations& e = *body.equations;
    const double* own = d + body.first;
    double* out = y + body.first;
    std::fill(out, out + e.unknowns, 0.0);
    scaled.resize(at(e.unknowns));
    for (std::size_t j = 0; j < scaled.size(); ++j) scaled[j] = body.column[j] * own[j];
    if (e.dense.empty()) {
      for (std::int64_t j = 0; j < e.unknowns; ++j)
        entries(e.matrix, j, [&](std::int64_t i, double v) { out[i] += v * scaled[at(j)]; });
    } else {
      const auto n = static_cast<int>(e.unknowns);
      const int one = 1;
      const double unit = 1, zero = 0;
      dgemv_("N", &n, &n, &unit, e.dense.data(), &n, scaled.data(), &one, &zero, out, &one);
    }
    for (std::size_t i = 0; i < scaled.size(); ++i) out[i] *= -body.row[i];
  }
  add_loads(t, y);
  for (std::int64_t i = 0; i < unknowns_; ++i) y[i] = -y[i];
}

void BodiesEquations::add_loads(const double* t, double* y) const {
  for (const Body& body : body_)
    for (std::int64_t j = 0; j < body.load.columns; ++j)
      if (t[j] != 0)
        entries(body.load, j, [&](std::int64_t i, double v) { y[body.first + i] += body.row[at(i)] * v * t[j]; });
}

const std::vector<std::int64_t>& BodiesEquations::own_rows() {
  if (!own_rows_.empty()) return own_rows_;
  for (const Body& body : body_) {
    std::vector<std::int64_t> rows;
    if (!body.equations->dense.empty()) rows = heaviest_rows(body);
    for (std::int64_t j = 0; j < body.equations->unknowns; ++j)
      own_rows_.push_back(body.first + (rows.empty() ? j : rows[at(j)]));
  }
  return own_rows_;
}

BodiesEquations::Factor BodiesEquations::factor(const BodyEquations& e) {
  Factor made;
  bool good = true;
  if (!e.dense.empty()) {
    std::copy(e.dense.begin(), e.dense.end(), made.dense.prepare(e.unknowns));
    good = made.dense.factor();
  } else if (e.symmetric) {
    const SparseMatrix lower = lower_triangle(e.matrix);
    made.symmetric = factor_definite(lower, {});
  } else {
    good = made.sparse.factor(e.matrix);
  }
  if (!good)
    fail(Status::err_singular, "the equations of a body with %lld unknowns are singular",
         static_cast<long long>(e.unknowns));
  return made;
}

void BodiesEquations::solve(double* y) {
  if (factor_.empty()) {
    std::vector<Factor> made;
    for (const Body& body : body_) {
      made.push_back(factor(*body.equations));
      ++factorizations_;
    }
    factor_ = std::move(made);
  }
  for (std::size_t b = 0; b < body_.size(); ++b) {
    const Body& body = body_[b];
    double* own = y + body.first;
    for (std::size_t i = 0; i < body.row.size(); ++i) own[i] /= body.row[i];
    if (factor_[b].symmetric)
      factor_[b].symmetric->solve(own, 1);
    else if (factor_[b].dense.factored())
      factor_[b].dense.solve(own, 1);
    else
      factor_[b].sparse.solve(own);
    for (std::size_t i = 0; i < body.column.size(); ++i) own[i] /= body.column[i];
  }
}

std::size_t BodiesEquations::bytes() const {
  std::size_t sum = 0;
  for (const Body& body : body_)
    sum += body.load.bytes() + body.equations->matrix.bytes() +
           sizeof(double) * (body.equations->dense.capacity() + 2 * body.row.capacity());
  for (const Factor& f : factor_) {
    if (f.symmetric) sum += f.symmetric->statistics().bytes;
    sum += f.sparse.statistics().bytes + f.dense.bytes();
  }
  return sum;
}

}  // namespace rollcon
