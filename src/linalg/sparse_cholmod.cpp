/// Computes Cholesky factors with the condensed unknowns last: the trailing block L_cc of the factor is then that of
/// the condensed matrix, K_cc - K_ci K_ii^-1 K_ic = L_cc L_cc'.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "linalg/condensed_factor.hpp"
#include "linalg/sparse_checks.hpp"
#include "linalg/sparse_cholmod_common.hpp"
#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_order.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// So many right sides solved at a time are enough for products of matrices, and need little workspace.
constexpr std::int64_t block = 32;

/// Holds columns [first, last) of L as a dense panel of `rows` rows from `values`, numbered in `row`.
struct Supernode {
  std::int64_t first, last, rows;
  const SuiteSparse_long* row;
  const double* values;
};

Supernode supernode(const cholmod_factor& l, std::size_t s) {
  const auto* super = static_cast<const SuiteSparse_long*>(l.super);
  const auto* pi = static_cast<const SuiteSparse_long*>(l.pi);
  const auto* px = static_cast<const SuiteSparse_long*>(l.px);
  return {super[s], super[s + 1], pi[s + 1] - pi[s], static_cast<const SuiteSparse_long*>(l.s) + pi[s],
          static_cast<const double*>(l.x) + px[s]};
}

cholmod_sparse lower_view(SparseMatrix& matrix) {
  cholmod_sparse a{};
  a.nrow = a.ncol = at(matrix.columns);
  a.nzmax = matrix.row.size();
  a.p = matrix.start.data();
  a.i = matrix.row.data();
  a.x = matrix.value.data();
  a.stype = -1;
  a.itype = CHOLMOD_LONG;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.packed = 1;
  return a;
}

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_l_free_factor(&factor, common); }
};

class CholmodFactor final : public SparseFactor {
 public:
  CholmodFactor(const SparseMatrix& matrix, std::span<const std::int64_t> condensed,
                std::span<const std::int64_t> known_order)
      : size_(matrix.columns), condensed_(static_cast<std::int64_t>(condensed.size())) {
    check_sparse(matrix, condensed);
    check_diagonal(matrix);
    if (!known_order.empty()) {
      unknown_.assign(known_order.begin(), known_order.end());
    } else {
      const Stopwatch watch(statistics_.seconds_order);
      SparseOrder order = order_unknowns(matrix, condensed);
      unknown_ = std::move(order.unknown);
      statistics_.peak_bytes = order.peak_bytes;
    }
    {
      const Stopwatch watch(statistics_.seconds_factor);
      factorise(matrix);
      copy_condensed(matrix, condensed);
    }
    judge(matrix);
  }
  std::int64_t size() const override { return size_; }
  void solve(double* b, std::int64_t count) override;
  void solve_condensed(double* b, std::int64_t count) override { rollcon::solve_condensed(condensed(), b, count); }
  CondensedView condensed() const override { return {condensed_, trailing_.get(), place_}; }
  void keep_condensed() override {
    factor_.reset();
    cholmod_l_free_work(&common_.c);
    std::vector<std::int64_t>().swap(unknown_);
    std::vector<double>().swap(work_);
  }
  SparseStatistics statistics() const override {
    SparseStatistics now = statistics_;
    now.bytes = common_.c.memory_inuse + own_bytes();
    return now;
  }

 private:
  static void check_diagonal(const SparseMatrix& matrix) {
    for (std::int64_t j = 0; j < matrix.columns; ++j)
      if (!(matrix.value[at(matrix.start[at(j)])] > 0)) throw ZeroPivot(j);
  }
  std::size_t own_bytes() const {
    return sizeof(double) * (at(condensed_ * condensed_) + work_.size()) +
           sizeof(std::int64_t) * (unknown_.size() + place_.size());
  }
  void factorise(const SparseMatrix& matrix);
  void copy_condensed(const SparseMatrix& matrix, std::span<const std::int64_t> condensed);
  void judge(const SparseMatrix& matrix);
  void solve_block(double* b, std::int64_t count);

  std::int64_t size_, condensed_;
  CholmodCommon common_;
  std::unique_ptr<cholmod_factor, FreeFactor> factor_{nullptr, FreeFactor{&common_.c}};
  std::vector<std::int64_t> unknown_;   // the unknown at each place of the order
  std::vector<std::int64_t> place_;     // places of the condensed unknowns within the trailing block
  std::unique_ptr<double[]> trailing_;  // L_cc, column-major, with nothing above the diagonal
  std::vector<double> work_;
  SparseStatistics statistics_;
};

void CholmodFactor::factorise(const SparseMatrix& matrix) {
  if (size_ == 0) return;
  SparseMatrix ordered = permuted(matrix, unknown_);
  cholmod_sparse view = lower_view(ordered);
  cholmod_common& c = common_.c;
  c.nmethods = 1;
  c.method[0].ordering = CHOLMOD_NATURAL;
  c.postorder = 0;
  c.supernodal = CHOLMOD_SUPERNODAL;
  c.final_ll = 1;
  c.quick_return_if_not_posdef = 1;

  const SerialLoops serial;
  factor_.reset(cholmod_l_analyze(&view, &c));
  if (!factor_) out_of_memory(matrix.columns, 0);
  const double condensed_bytes = 8.0 * static_cast<double>(condensed_) * static_cast<double>(condensed_);
  const double need =
      8.0 * static_cast<double>(factor_->xsize) +
      std::max(8.0 * static_cast<double>(factor_->maxcsize) + static_cast<double>(ordered.bytes()), condensed_bytes);
  require_memory(matrix.columns, need);
  statistics_.nonzeros = static_cast<std::int64_t>(c.lnz);
  statistics_.flops = c.fl;

  cholmod_l_factorize(&view, factor_.get(), &c);
  statistics_.peak_bytes = std::max(statistics_.peak_bytes, c.memory_usage + ordered.bytes() + own_bytes());
  if (c.status == CHOLMOD_NOT_POSDEF) throw ZeroPivot(unknown_[factor_->minor]);
  if (c.status == CHOLMOD_OUT_OF_MEMORY || c.status == CHOLMOD_TOO_LARGE) out_of_memory(matrix.columns, need);
  if (c.status < 0) fail(Status::err_internal, "CHOLMOD failed with status %d", c.status);
}

void CholmodFactor::copy_condensed(const SparseMatrix& matrix, std::span<const std::int64_t> condensed) {
  if (condensed_ == 0) return;
  const std::int64_t first = size_ - condensed_;
  std::vector<std::int64_t> inverse(at(size_));
  for (std::int64_t k = first; k < size_; ++k) inverse[at(unknown_[at(k)])] = k - first;
  for (const std::int64_t u : condensed) place_.push_back(inverse[at(u)]);

  const auto entries = at(condensed_ * condensed_);
  try {
    trailing_ = std::make_unique<double[]>(entries);
  } catch (const std::bad_alloc&) {
    out_of_memory(matrix.columns, 8.0 * static_cast<double>(entries));
  }
  for (std::size_t s = factor_->nsuper; s-- > 0;) {
    const Supernode node = supernode(*factor_, s);
    if (node.last <= first) break;
    for (std::int64_t j = std::max(first, node.first); j < node.last; ++j) {
      const std::int64_t diagonal = j - node.first;
      const double* from = node.values + diagonal * node.rows;
      double* to = trailing_.get() + (j - first) * condensed_;
      for (std::int64_t r = diagonal; r < node.rows; ++r) to[node.row[r] - first] = from[r];
    }
  }
  statistics_.peak_bytes = std::max(statistics_.peak_bytes, common_.c.memory_inuse + own_bytes());
}

// Judges the factors: Cholesky stops at pivots that are not positive only, and rounding may leave a small positive one.
void CholmodFactor::judge(const SparseMatrix& matrix) {
  if (size_ == 0) {
    statistics_.condition = 1;
    return;
  }
  double smallest = HUGE_VAL;
  std::int64_t where = 0;
  for (std::size_t s = 0; s < factor_->nsuper; ++s) {
    const Supernode node = supernode(*factor_, s);
    for (std::int64_t j = node.first; j < node.last; ++j) {
      const std::int64_t u = unknown_[at(j)];
      const double pivot = node.values[(j - node.first) * (node.rows + 1)];
      const double part = pivot * pivot / matrix.value[at(matrix.start[at(u)])];
      if (!std::isfinite(part)) throw ZeroPivot(u);
      if (part < smallest) smallest = part, where = u;
    }
  }
  statistics_.condition = estimate_condition(matrix, [this](double* x) { solve(x, 1); });
  if (!(statistics_.condition < singular_condition)) throw ZeroPivot(where);
}

void CholmodFactor::solve(double* b, std::int64_t count) {
  for (std::int64_t k = 0; k < count && size_ > 0; k += block) solve_block(b + k * size_, std::min(block, count - k));
}

void CholmodFactor::solve_block(double* b, std::int64_t count) {
  const std::size_t unknowns = at(size_ * count), edges = factor_->maxesize * at(count);
  if (work_.size() < unknowns + edges) work_.resize(unknowns + edges);
  cholmod_dense x{};
  x.nrow = x.d = at(size_);
  x.ncol = at(count);
  x.nzmax = unknowns;
  x.x = work_.data();
  x.xtype = CHOLMOD_REAL;
  x.dtype = CHOLMOD_DOUBLE;
  cholmod_dense e = x;
  e.nrow = e.d = factor_->maxesize;
  e.nzmax = edges;
  e.x = work_.data() + unknowns;
  for (std::int64_t r = 0; r < count; ++r)
    for (std::int64_t k = 0; k < size_; ++k) work_[at(r * size_ + k)] = b[r * size_ + unknown_[at(k)]];
  const SerialLoops serial;
  cholmod_l_super_lsolve(factor_.get(), &x, &e, &common_.c);
  cholmod_l_super_ltsolve(factor_.get(), &x, &e, &common_.c);
  for (std::int64_t r = 0; r < count; ++r)
    for (std::int64_t k = 0; k < size_; ++k) b[r * size_ + unknown_[at(k)]] = work_[at(r * size_ + k)];
}

}  // namespace

std::unique_ptr<SparseFactor> factor_definite(const SparseMatrix& matrix, std::span<const std::int64_t> condensed,
                                              std::span<const std::int64_t> order) {
  return std::make_unique<CholmodFactor>(matrix, condensed, order);
}

}  // namespace rollcon
