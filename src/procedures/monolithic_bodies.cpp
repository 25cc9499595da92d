#include "procedures/monolithic_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "build_info.hpp"
#include "linalg/lapack.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

template <class Visit>
void entries(const SparseMatrix& a, std::int64_t column, Visit visit) {
  for (std::int64_t k = a.start[at(column)]; k < a.start[at(column + 1)]; ++k)
    visit(a.row[at(k)], a.value[at(k)]);
}

/// Point p and component c behind a place.
std::int64_t point_column(std::int64_t place, std::int64_t nodes) {
  if (place < 3 * nodes) return place;
  const std::int64_t upstream = place - 3 * nodes;
  return 3 * (nodes + upstream / 2) + upstream % 2;
}

SparseMatrix choose_columns(const SparseMatrix& all, std::int64_t places, std::int64_t nodes) {
  SparseMatrix some;
  some.rows = all.rows;
  some.columns = places;
  some.start.push_back(0);
  for (std::int64_t place = 0; place < places; ++place) {
    entries(all, point_column(place, nodes), [&](std::int64_t i, double v) {
      some.row.push_back(i);
      some.value.push_back(v);
    });
    some.start.push_back(static_cast<std::int64_t>(some.row.size()));
  }
  return some;
}

double largest(const std::vector<double>& v) {
  double m = 0;
  for (const double x : v) m = std::max(m, std::abs(x));
  return m;
}

template <class Visit>
void matrix_entries(const BodyEquations& e, Visit visit) {
  if (e.dense.empty()) {
    for (std::int64_t j = 0; j < e.unknowns; ++j)
      entries(e.matrix, j, [&](std::int64_t i, double v) { visit(i, j, v); });
    return;
  }
  for (std::int64_t j = 0; j < e.unknowns; ++j)
    for (std::int64_t i = 0; i < e.unknowns; ++i) visit(i, j, e.dense[at(i + j * e.unknowns)]);
}

// Unknowns times scale become tractions: the largest entry of each column of K then equals the
// largest one of B. Rows are divided by their largest entry. Both carry the units along, whatever
// the unknowns are (displacements, reactions).
void set_scales(MonolithicBodies::Body& body) {
  const BodyEquations& e = *body.equations;
  const double unit = std::max(largest(body.load.value), 1e-300);
  body.column.assign(at(e.unknowns), 0.0);
  body.row.assign(at(e.unknowns), 0.0);
  matrix_entries(e, [&](std::int64_t, std::int64_t j, double v) {
    body.column[at(j)] = std::max(body.column[at(j)], std::abs(v));
  });
  for (double& c : body.column) c = c > 0 ? unit / c : 1;
  matrix_entries(e, [&](std::int64_t i, std::int64_t j, double v) {
    body.row[at(i)] = std::max(body.row[at(i)], std::abs(v) * body.column[at(j)]);
  });
  for (std::int64_t j = 0; j < body.load.columns; ++j)
    entries(body.load, j, [&](std::int64_t i, double v) {
      body.row[at(i)] = std::max(body.row[at(i)], std::abs(v));
    });
  for (double& r : body.row) r = r > 0 ? 1 / r : 1;
}

// Positive everywhere: the mean where the problem has none.
std::vector<double> filled(const std::vector<double>& scale, std::size_t n) {
  std::vector<double> full(scale);
  full.resize(n, 0.0);
  double sum = 0, count = 0;
  for (const double r : full)
    if (r > 0) sum += r, count += 1;
  const double mean = count > 0 ? sum / count : 1;
  for (double& r : full)
    if (!(r > 0)) r = mean;
  return full;
}

}  // namespace

MonolithicBodies::MonolithicBodies(const Problem& problem, const Frame& frame,
                                   const Compliance& compliance)
    : nodes_(problem.nodes),
      rn_(filled(problem.rn, at(problem.nodes))),
      rt_(filled(problem.rt, at(problem.nodes))) {
  const bool ahead = !problem.op.upstream.empty();
  std::vector<double> x(frame.x), y(frame.y);
  if (ahead) {
    for (std::size_t k = 0; k < at(nodes_); ++k) {
      x.push_back(frame.x[k] + problem.op.upstream[k]);
      y.push_back(frame.y[k]);
    }
  }
  ExpandedCompliance expanded;
  if (!compliance.expand({x, y}, expanded))
    fail(
        Status::err_unsupported,
        "option 'system' is 'monolithic': the equations of these bodies cannot be written out (%s)",
        compliance.description().c_str());
  places_ = ahead ? 5 * nodes_ : 3 * nodes_;
  take(problem, std::move(expanded));
}

void MonolithicBodies::take(const Problem&, ExpandedCompliance expanded) {
  for (ExpandedBody& from : expanded.body) {
    Body& body = body_.emplace_back();
    body.equations = std::move(from.equations);
    body.first = unknowns_;
    body.load = std::move(from.load);
    body.place = choose_columns(from.displacement, places_, nodes_);
    body.unknown = transposed(body.place);
    set_scales(body);
    unknowns_ += body.equations->unknowns;
  }
  if (expanded.direct.empty()) return;
  direct_.resize(at(places_ * 3 * nodes_));
  for (std::int64_t p = 0; p < places_; ++p) {
    const double* row = expanded.direct.row(point_column(p, nodes_));
    for (std::int64_t j = 0; j < 3 * nodes_; ++j) direct_[at(p + j * places_)] = row[j];
  }
}

void MonolithicBodies::balance(const double* d, const double* t, double* y) const {
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
    for (std::int64_t j = 0; j < body.load.columns; ++j)
      if (t[j] != 0) entries(body.load, j, [&](std::int64_t i, double v) { out[i] -= v * t[j]; });
    for (std::size_t i = 0; i < scaled.size(); ++i) out[i] *= body.row[i];
  }
}

void MonolithicBodies::displacements(const double* d, const double* t, double* u) const {
  std::fill(u, u + places_, 0.0);
  if (!direct_.empty()) {
    const auto m = static_cast<int>(places_), n = static_cast<int>(3 * nodes_);
    const int one = 1;
    const double unit = 1, zero = 0;
    dgemv_("N", &m, &n, &unit, direct_.data(), &m, t, &one, &zero, u, &one);
  }
  for (const Body& body : body_)
    for (std::int64_t p = 0; p < places_; ++p)
      entries(body.place, p, [&](std::int64_t i, double v) {
        u[p] += v * body.column[at(i)] * d[body.first + i];
      });
}

void MonolithicBodies::normal_displacements(const double* d, const double* t, double* u) const {
  std::fill(u, u + nodes_, 0.0);
  if (!direct_.empty()) {
    if (normal_direct_.empty()) {
      normal_direct_.resize(at(nodes_ * nodes_));
      for (std::int64_t j = 0; j < nodes_; ++j)
        for (std::int64_t k = 0; k < nodes_; ++k)
          normal_direct_[at(k + j * nodes_)] = direct_[at(3 * k + 2 + (3 * j + 2) * places_)];
    }
    const auto n = static_cast<int>(nodes_);
    const int one = 1;
    const double unit = 1, zero = 0;
    dgemv_("N", &n, &n, &unit, normal_direct_.data(), &n, t, &one, &zero, u, &one);
  }
  for (const Body& body : body_)
    for (std::int64_t k = 0; k < nodes_; ++k)
      entries(body.place, 3 * k + 2, [&](std::int64_t i, double v) {
        u[k] += v * body.column[at(i)] * d[body.first + i];
      });
}

const std::vector<std::int64_t>& MonolithicBodies::own_rows() const {
  if (!own_rows_.empty() || unknowns_ == 0) return own_rows_;
  own_rows_.resize(at(unknowns_));
  std::iota(own_rows_.begin(), own_rows_.end(), 0);
  for (const Body& body : body_) {
    const BodyEquations& e = *body.equations;
    if (e.dense.empty()) continue;
    std::vector<std::int64_t> heaviest(at(e.unknowns), -1);  // free row for each unknown
    std::vector<char> taken(at(e.unknowns), 0);
    for (int pass = 0; pass < 2; ++pass)
      for (std::int64_t j = 0; j < e.unknowns; ++j) {
        if (heaviest[at(j)] >= 0) continue;
        std::int64_t best = -1;
        double weight = -1;
        for (std::int64_t i = 0; i < e.unknowns; ++i) {
          const double v = std::abs(e.dense[at(i + j * e.unknowns)]) * body.row[at(i)];
          if (v > weight && (pass == 0 || !taken[at(i)])) weight = v, best = i;
        }
        if (best < 0 || taken[at(best)]) continue;  // left for the second pass
        taken[at(best)] = 1;
        heaviest[at(j)] = best;
      }
    for (std::int64_t j = 0; j < e.unknowns; ++j)
      own_rows_[at(body.first + j)] = body.first + heaviest[at(j)];
  }
  return own_rows_;
}

void MonolithicBodies::factor() {
  if (!factor_.empty()) return;
  std::vector<Factor> made(body_.size());
  for (std::size_t b = 0; b < body_.size(); ++b) {
    const BodyEquations& e = *body_[b].equations;
    bool good = true;
    if (!e.dense.empty()) {
      std::copy(e.dense.begin(), e.dense.end(), made[b].dense.prepare(e.unknowns));
      good = made[b].dense.factor();
    } else if (e.symmetric) {
      SparseMatrix lower;
      lower.columns = e.unknowns;
      lower.start.push_back(0);
      for (std::int64_t j = 0; j < e.unknowns; ++j) {
        entries(e.matrix, j, [&](std::int64_t i, double v) {
          if (i < j) return;
          lower.row.push_back(i);
          lower.value.push_back(v);
        });
        lower.start.push_back(static_cast<std::int64_t>(lower.row.size()));
      }
      made[b].symmetric =
          ROLLCON_BUILD_CHOLMOD != 0 ? factor_by_cholmod(lower, {}) : factor_by_umfpack(lower, {});
    } else {
      good = made[b].sparse.factor(e.matrix);
    }
    if (!good)
      fail(Status::err_singular, "the equations of a body with %lld unknowns are singular",
           static_cast<long long>(e.unknowns));
    ++factorizations_;
  }
  factor_ = std::move(made);
}

void MonolithicBodies::solve(double* y) {
  factor();
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

double MonolithicBodies::factor_entries() const {
  double sum = 0;
  for (const Factor& f : factor_) {
    if (f.symmetric) sum += 2.0 * static_cast<double>(f.symmetric->statistics().nonzeros);
    sum += static_cast<double>(f.sparse.statistics().nonzeros);
    sum += static_cast<double>(f.dense.size()) * static_cast<double>(f.dense.size());
  }
  return sum;
}

std::size_t MonolithicBodies::bytes() const {
  std::size_t sum = sizeof(double) * (direct_.capacity() + normal_direct_.capacity());
  for (const Body& body : body_)
    sum += body.load.bytes() + body.place.bytes() + body.unknown.bytes() +
           body.equations->matrix.bytes() +
           sizeof(double) * (body.equations->dense.capacity() + 2 * body.row.capacity());
  for (const Factor& f : factor_) {
    if (f.symmetric) sum += f.symmetric->statistics().bytes;
    sum += f.sparse.statistics().bytes + f.dense.bytes();
  }
  return sum;
}

}  // namespace rollcon
