/// LU factorisation with the condensed unknowns last. UMFPACK keeps to that as long as it finds pivots on the diagonal;
/// then the condensed matrix is inverted from the ends of the factors. Otherwise its inverse is found column by column
/// from full solves.

#include <umfpack.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "linalg/condensed_factor.hpp"
#include "linalg/sparse_checks.hpp"
#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_order.hpp"
#include "linalg/sparse_umfpack_trailing.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon {
namespace {

using Long = SuiteSparse_long;
static_assert(sizeof(Long) == sizeof(std::int64_t));

/// Of one right side: x from b.
struct Workspace {
  std::vector<double> b, x, work;
  std::vector<Long> rows;
  explicit Workspace(std::int64_t n) : b(at(n)), x(at(n)), work(at(n)), rows(at(n)) {}
};

struct FreeNumeric {
  void operator()(void* numeric) const { umfpack_dl_free_numeric(&numeric); }
};

class UmfpackFactor final : public SparseFactor {
 public:
  UmfpackFactor(const SparseMatrix& matrix, std::span<const std::int64_t> condensed, int threads)
      : size_(matrix.columns), threads_(threads), condensed_(condensed.begin(), condensed.end()) {
    check_sparse(matrix, condensed);
    statistics_.condition = 1;
    if (size_ == 0) return;
    umfpack_dl_defaults(control_);
    control_[UMFPACK_PRL] = 0;
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    control_[UMFPACK_IRSTEP] = 0;
    factorise(matrix);
    statistics_.condition = estimate_condition(matrix, [this](double* x) { solve(x, 1); });
    if (!(statistics_.condition < singular_condition)) throw ZeroPivot(smallest_pivot());
  }
  std::int64_t size() const override { return size_; }
  void solve(double* b, std::int64_t count) override;
  void solve_condensed(double* b, std::int64_t count) override;
  void keep_condensed() override;
  CondensedView condensed() const override {
    const auto unknowns = static_cast<std::int64_t>(condensed_.size());
    return {CondensedForm::inverse, unknowns, compliance_.data(), {}};
  }
  SparseStatistics statistics() const override {
    SparseStatistics now = statistics_;
    now.bytes = (numeric_ ? numeric_bytes_ : 0) + sizeof(double) * compliance_.size() +
                sizeof(std::int64_t) * condensed_.size();
    return now;
  }

 private:
  void factorise(const SparseMatrix& matrix);
  void check_status(Long status, const double* info, const SparseMatrix& matrix) const;
  std::int64_t smallest_pivot() const;
  void solve_one(Workspace& w) const;
  /// Calls one(right side, workspace) within the thread budget.
  template <class One>
  void for_right_sides(std::int64_t count, One one) const;
  void form_compliance();
  void solve_units();

  std::int64_t size_;
  int threads_;
  std::vector<std::int64_t> condensed_;
  double control_[UMFPACK_CONTROL];
  std::unique_ptr<void, FreeNumeric> numeric_;
  std::size_t numeric_bytes_ = 0;
  std::vector<double> compliance_;  // of the condensed unknowns, column-major, once asked for
  SparseStatistics statistics_;
};

void UmfpackFactor::check_status(Long status, const double* info, const SparseMatrix& matrix) const {
  if (status >= 0) return;
  if (status == UMFPACK_ERROR_out_of_memory)
    out_of_memory(matrix.columns, info[UMFPACK_PEAK_MEMORY_ESTIMATE] * info[UMFPACK_SIZE_OF_UNIT]);
  const char* what = "an internal error";
  if (status == UMFPACK_ERROR_ordering_failed) what = "no order of the unknowns found";
  if (status == UMFPACK_ERROR_invalid_matrix) what = "columns of the matrix are not in order";
  fail(Status::err_internal, "UMFPACK failed with status %lld: %s", static_cast<long long>(status), what);
}

void UmfpackFactor::factorise(const SparseMatrix& matrix) {
  SparseOrder order;
  {
    const Stopwatch watch(statistics_.seconds_order);
    order = order_unknowns(matrix, condensed_, dissect_by_umfpack);
  }
  const Stopwatch watch(statistics_.seconds_factor);
  const SparseMatrix full = both_triangles(matrix);
  double info[UMFPACK_INFO] = {};
  void *symbolic = nullptr, *numeric = nullptr;
  Long status = umfpack_dl_qsymbolic(size_, size_, full.start.data(), full.row.data(), full.value.data(),
                                     order.unknown.data(), &symbolic, control_, info);
  check_status(status, info, matrix);
  status =
      umfpack_dl_numeric(full.start.data(), full.row.data(), full.value.data(), symbolic, &numeric, control_, info);
  numeric_.reset(numeric);
  umfpack_dl_free_symbolic(&symbolic);
  const double unit = info[UMFPACK_SIZE_OF_UNIT];
  check_status(status, info, matrix);
  numeric_bytes_ = static_cast<std::size_t>(unit * info[UMFPACK_NUMERIC_SIZE]);
  statistics_.nonzeros = static_cast<std::int64_t>(info[UMFPACK_LNZ] + info[UMFPACK_UNZ]) - size_;
  statistics_.flops = info[UMFPACK_FLOPS];
  statistics_.peak_bytes =
      std::max(order.peak_bytes, full.bytes() + static_cast<std::size_t>(unit * info[UMFPACK_PEAK_MEMORY]));
  if (status == UMFPACK_WARNING_singular_matrix) throw ZeroPivot(smallest_pivot());
}

std::int64_t UmfpackFactor::smallest_pivot() const {
  std::vector<double> diagonal(at(size_));
  std::vector<Long> column(at(size_));
  if (umfpack_dl_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, column.data(),
                             diagonal.data(), nullptr, nullptr, numeric_.get()) < 0)
    throw std::bad_alloc();
  std::size_t smallest = 0;
  for (std::size_t k = 0; k < diagonal.size(); ++k)
    if (!(std::abs(diagonal[k]) >= std::abs(diagonal[smallest]))) smallest = k;
  return column[smallest];
}

void UmfpackFactor::solve_one(Workspace& w) const {
  umfpack_dl_wsolve(UMFPACK_A, nullptr, nullptr, nullptr, w.x.data(), w.b.data(), numeric_.get(), control_, nullptr,
                    w.rows.data(), w.work.data());
}

template <class One>
void UmfpackFactor::for_right_sides(std::int64_t count, One one) const {
  if (count <= 0) return;
  const int threads = static_cast<int>(std::min<std::int64_t>(std::max(threads_, 1), count));
  std::vector<Workspace> workspaces(static_cast<std::size_t>(threads), Workspace(size_));
  parallel_for(count, 1, threads,
               [&](std::int64_t r, int thread) { one(r, workspaces[static_cast<std::size_t>(thread)]); });
}

void UmfpackFactor::solve(double* b, std::int64_t count) {
  if (size_ == 0) return;
  for_right_sides(count, [&](std::int64_t r, Workspace& w) {
    std::copy_n(b + r * size_, size_, w.b.data());
    solve_one(w);
    std::copy_n(w.x.data(), size_, b + r * size_);
  });
}

void UmfpackFactor::solve_condensed(double* b, std::int64_t count) {
  form_compliance();
  rollcon::solve_condensed(condensed(), b, count);
}

void UmfpackFactor::solve_units() {
  const auto n = static_cast<std::int64_t>(condensed_.size());
  compliance_.resize(at(n * n));
  for_right_sides(n, [&](std::int64_t r, Workspace& w) {
    w.b[at(condensed_[at(r)])] = 1;
    solve_one(w);
    w.b[at(condensed_[at(r)])] = 0;
    for (std::int64_t k = 0; k < n; ++k) compliance_[at(r * n + k)] = w.x[at(condensed_[at(k)])];
  });
}

void UmfpackFactor::form_compliance() {
  const auto n = static_cast<std::int64_t>(condensed_.size());
  if (n == 0 || !compliance_.empty()) return;
  const double dense = 8.0 * static_cast<double>(n) * static_cast<double>(n);
  const auto held = static_cast<double>(numeric_bytes_);
  require_memory(size_, held + 2 * dense, held);
  std::size_t copied = 0;
  compliance_ = invert_trailing(numeric_.get(), size_, condensed_, &copied);
  if (compliance_.empty()) solve_units();
  // The inverse of a symmetric matrix; rounding must not spoil reciprocity.
  for (std::int64_t j = 0; j < n; ++j) {
    for (std::int64_t i = 0; i < j; ++i) {
      double &upper = compliance_[at(j * n + i)], &lower = compliance_[at(i * n + j)];
      upper = lower = 0.5 * (upper + lower);
    }
  }
  statistics_.peak_bytes =
      std::max(statistics_.peak_bytes, numeric_bytes_ + std::max(copied, sizeof(double) * compliance_.size()));
}

void UmfpackFactor::keep_condensed() {
  form_compliance();
  numeric_.reset();
}

}  // namespace

std::unique_ptr<SparseFactor> factor_by_umfpack(const SparseMatrix& matrix, std::span<const std::int64_t> condensed,
                                                int threads) {
  return std::make_unique<UmfpackFactor>(matrix, condensed, threads);
}

}  // namespace rollcon
