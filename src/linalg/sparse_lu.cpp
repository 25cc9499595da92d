#include "linalg/sparse_lu.hpp"

#include <umfpack.h>

#include <algorithm>
#include <cmath>

#include "linalg/sparse_checks.hpp"
#include "linalg/sparse_metis_random.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

using Long = SuiteSparse_long;
static_assert(sizeof(Long) == sizeof(std::int64_t));

struct FreeSymbolic {
  void operator()(void* symbolic) const { umfpack_dl_free_symbolic(&symbolic); }
};
struct FreeNumeric {
  void operator()(void* numeric) const { umfpack_dl_free_numeric(&numeric); }
};

void check_status(Long status, const double* info, const SparseMatrix& matrix) {
  if (status >= 0) return;
  if (status == UMFPACK_ERROR_out_of_memory)
    out_of_memory(matrix.columns, info[UMFPACK_PEAK_MEMORY_ESTIMATE] * info[UMFPACK_SIZE_OF_UNIT]);
  fail(Status::err_internal, "UMFPACK failed with status %lld on a matrix of %lld unknowns",
       static_cast<long long>(status), static_cast<long long>(matrix.columns));
}

}  // namespace

struct SparseLu::Factors {
  double control[UMFPACK_CONTROL];
  std::unique_ptr<void, FreeSymbolic> symbolic;
  std::unique_ptr<void, FreeNumeric> numeric;
  std::vector<Long> start, row;  ///< pattern that was analysed
  std::vector<double> x, work;
  std::vector<Long> rows;
};

SparseLu::SparseLu() : factors_(std::make_unique<Factors>()) {
  umfpack_dl_defaults(factors_->control);
  factors_->control[UMFPACK_PRL] = 0;
  factors_->control[UMFPACK_IRSTEP] = 0;
  // Callers pair unknowns with their equations, and the pattern is nearly symmetric. Singletons taken out first would
  // make what is left unsymmetric, which takes 1.7 times the operations.
  factors_->control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
  factors_->control[UMFPACK_SINGLETONS] = 0;
}
SparseLu::~SparseLu() = default;
SparseLu::SparseLu(SparseLu&&) noexcept = default;
SparseLu& SparseLu::operator=(SparseLu&&) noexcept = default;

bool SparseLu::available() {
  return true;
}

bool SparseLu::factored() const {
  return factors_->numeric != nullptr;
}

bool SparseLu::factor(const SparseMatrix& matrix) {
  Factors& f = *factors_;
  f.numeric.reset();
  for (const double v : matrix.value)
    if (!std::isfinite(v))
      fail(Status::err_nonfinite, "sparse matrix: an entry is not finite (%lld unknowns)",
           static_cast<long long>(matrix.columns));
  double info[UMFPACK_INFO] = {};
  const auto same = [](const std::vector<Long>& a, const std::vector<std::int64_t>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  };
  if (!f.symbolic || !same(f.start, matrix.start) || !same(f.row, matrix.row)) {
    f.symbolic.reset();
    f.start.assign(matrix.start.begin(), matrix.start.end());
    f.row.assign(matrix.row.begin(), matrix.row.end());
    // METIS dissects a mesh with a fifth of minimum degree's operations; where much of the matrix is dense, it has
    // nothing to gain and takes its time.
    const bool dense = static_cast<double>(f.row.size()) > 300 * static_cast<double>(matrix.columns);
    f.control[UMFPACK_ORDERING] = dense ? UMFPACK_ORDERING_AMD : UMFPACK_ORDERING_METIS;
    void* symbolic = nullptr;
    const MetisRandom random;
    const Long status = umfpack_dl_symbolic(matrix.columns, matrix.columns, f.start.data(), f.row.data(),
                                            matrix.value.data(), &symbolic, f.control, info);
    f.symbolic.reset(symbolic);
    ++statistics_.analyses;
    check_status(status, info, matrix);
    const auto n = static_cast<std::size_t>(matrix.columns);
    f.x.resize(n);
    f.work.resize(n);
    f.rows.resize(n);
  }
  void* numeric = nullptr;
  const Long status = umfpack_dl_numeric(f.start.data(), f.row.data(), matrix.value.data(), f.symbolic.get(), &numeric,
                                         f.control, info);
  f.numeric.reset(numeric);
  ++statistics_.factorizations;
  check_status(status, info, matrix);
  const double unit = info[UMFPACK_SIZE_OF_UNIT];
  statistics_.nonzeros = static_cast<std::int64_t>(info[UMFPACK_LNZ] + info[UMFPACK_UNZ]);
  statistics_.flops = info[UMFPACK_FLOPS];
  statistics_.bytes =
      static_cast<std::size_t>(unit * info[UMFPACK_NUMERIC_SIZE]) + sizeof(Long) * (f.start.size() + f.row.size());
  statistics_.peak_bytes = std::max(statistics_.peak_bytes, static_cast<std::size_t>(unit * info[UMFPACK_PEAK_MEMORY]));
  if (status == UMFPACK_WARNING_singular_matrix) f.numeric.reset();
  return f.numeric != nullptr;
}

void SparseLu::solve(double* b) {
  Factors& f = *factors_;
  umfpack_dl_wsolve(UMFPACK_A, nullptr, nullptr, nullptr, f.x.data(), b, f.numeric.get(), f.control, nullptr,
                    f.rows.data(), f.work.data());
  std::copy(f.x.begin(), f.x.end(), b);
}

void SparseLu::release(bool all) {
  Factors& f = *factors_;
  f.numeric.reset();
  statistics_.bytes = 0;
  if (!all) return;
  f.symbolic.reset();
  std::vector<Long>().swap(f.start);
  std::vector<Long>().swap(f.row);
}

}  // namespace rollcon
