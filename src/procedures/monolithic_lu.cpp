#include "procedures/monolithic_lu.hpp"

#include "support/clock.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// Without UMFPACK: as large as LAPACK takes in bearable time (half a minute on two cores).
constexpr std::int64_t largest_dense = 12000;

bool prefers_dense(const MonolithicCore& core) {
  double dense = 0;
  for (const MonolithicBodies::Body& body : core.matrix().bodies().bodies())
    dense += static_cast<double>(body.equations->dense.size());
  const auto n = static_cast<double>(core.size());
  const auto own = static_cast<double>(core.unknowns().size());
  if (core.matrix().bodies().direct()) dense += own * own;
  return dense > 0.4 * n * n;
}

}  // namespace

bool MonolithicLu::factor(const MonolithicMatrix& matrix) {
  valid_ = false;
  {
    const Stopwatch watch(seconds_matrix);
    core_.take(matrix);
  }
  const std::int64_t n = core_.size();
  is_dense_ = prefers_dense(core_);
  if (!is_dense_ && !SparseLu::available()) {
    if (n > largest_dense)
      fail(Status::err_unsupported,
           "option 'system' is 'monolithic': a sparse system of %lld unknowns needs UMFPACK, which "
           "this build of rollcon does not have (ROLLCON_WITH_UMFPACK is OFF; without it at most "
           "%lld)",
           static_cast<long long>(n), static_cast<long long>(largest_dense));
    is_dense_ = true;
  }
  if (is_dense_) {
    double* entries = dense_.prepare(n);
    {
      const Stopwatch watch(seconds_matrix);
      core_.assemble(entries);
    }
    return valid_ = dense_.factor();
  }
  {
    const Stopwatch watch(seconds_matrix);
    core_.assemble(entries_);
  }
  return valid_ = sparse_.factor(entries_);
}

void MonolithicLu::solve(const double* b, double* x) {
  whole_.assign(b, b + core_.matrix().size());
  core_.reduce(whole_.data(), right_);
  if (is_dense_)
    dense_.solve(right_.data(), 1);
  else
    sparse_.solve(right_.data());
  core_.recover(whole_.data(), right_, x);
}

void MonolithicLu::release() {
  valid_ = false;
  dense_.release();
  sparse_.release(false);
}

}  // namespace rollcon
