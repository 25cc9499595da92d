/// Solves lists of load cases over threads, which take chains of neighbouring cases: every thread solves a chain alike,
/// so that results do not depend on how many there are.

#include "contact/cases/solve_many.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>

#include "contact/cases/case_order.hpp"
#include "contact/cases/case_solver.hpp"
#include "linalg/blas_threads.hpp"
#include "support/batch.hpp"
#include "support/clock.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"
#include "support/parallel.hpp"

namespace rollcon {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Orders columns of CaseList::value: cases with the same normal problem come one after the other.
std::vector<std::int64_t> priority(std::span<const Parameter> parameter) {
  std::vector<std::int64_t> columns;
  for (const Parameter p :
       {Parameter::normal, Parameter::friction, Parameter::spin, Parameter::lateral, Parameter::longitudinal})
    for (std::size_t j = 0; j < parameter.size(); ++j)
      if (parameter[j] == p) columns.push_back(static_cast<std::int64_t>(j));
  return columns;
}

class ManyCases final : public Interrupt {
 public:
  ManyCases(const CaseList& list, const CaseResults& results, const Host& host)
      : list_(list),
        results_(results),
        host_(host),
        order_(order_cases(list.cases, parameters(), list.value, priority(list.parameter))),
        batch_(list.cases, *host.context) {
    for (const CaseColumn& c : results.column) width_ += c.width;
    for (const std::int64_t i : order_.solved) forget_results(i);
  }

  /// Solves the chains; returns what all solvers held. Rethrows what a progress callback threw.
  std::size_t run(const std::function<std::unique_ptr<CaseSolver>()>& make, int threads);
  /// Copies results to the repeated cases, and says what the call returns.
  Status finish();
  bool wanted() const override { return host_.cancel->load(); }

 private:
  void tell() override { tell(Phase::cases, solved_.load(), 0); }
  /// Tells of iterations in the calling thread and is silent in others.
  class Watch final : public Monitor {
   public:
    Watch(ManyCases& many, bool calling) : many_(many), calling_(calling) {}
    bool step(const StepRecord& r) override {
      if (calling_)
        many_.tell(static_cast<Phase>(r.part), r.iteration, std::max(r.residual_normal, r.residual_tangential));
      return cancelled();
    }
    bool cancelled() const override { return many_.wanted(); }

   private:
    ManyCases& many_;
    bool calling_;
  };

  std::int64_t parameters() const { return static_cast<std::int64_t>(list_.parameter.size()); }
  const double* values_of(std::int64_t i) const { return list_.value + i * parameters(); }
  void solve_chain(CaseSolver& solver, std::size_t chain, bool calling);
  Status solve_case(CaseSolver& solver, std::int64_t i, Monitor& monitor);
  void forget_results(std::int64_t i);
  double* row(std::int64_t i) const { return results_.row + i * results_.stride; }
  void tell(Phase phase, std::int64_t iteration, double residual);

  const CaseList& list_;
  const CaseResults& results_;
  const Host& host_;
  std::int64_t width_ = 0;  ///< numbers in a row
  const CaseOrder order_;
  const double start_ = now_seconds();
  Batch batch_;
  std::atomic<std::int64_t> solved_{0};
  std::exception_ptr thrown_;  ///< exception from a callback
};

void ManyCases::forget_results(std::int64_t i) {
  if (width_ > 0) std::fill_n(row(i), width_, none);
}

void ManyCases::tell(Phase phase, std::int64_t iteration, double residual) {
  if (!host_.progress || thrown_) return;
  Event event;
  event.phase = static_cast<std::int32_t>(phase);
  event.iteration = iteration;
  event.residual = residual;
  event.seconds = now_seconds() - start_;
  try {
    if (host_.progress(event, host_.user) != 0) host_.cancel->store(true);
  } catch (...) {
    thrown_ = std::current_exception();
    host_.cancel->store(true);
  }
}

Status ManyCases::solve_case(CaseSolver& solver, std::int64_t i, Monitor& monitor) {
  const Status status = solver.solve(list_.parameter, values_of(i), monitor);
  double* to = row(i);
  for (const CaseColumn& c : results_.column) {
    if (status != Status::cancelled) solver.write(c, list_.parameter, values_of(i), to);
    to += c.width;
  }
  return status;
}

void ManyCases::solve_chain(CaseSolver& solver, std::size_t chain, bool calling) {
  const BlasThreads blas(1);  // each thread needs a buffer of its own
  Watch watch(*this, calling);
  solver.begin_chain();
  for (std::int64_t k = order_.chain_begin[chain]; k < order_.chain_begin[chain + 1] && !wanted(); ++k) {
    const std::int64_t i = order_.solved[at(k)];
    if (!batch_.take(i, [&] { return solve_case(solver, i, watch); })) {
      forget_results(i);
      solver.begin_chain();
    }
    const std::int64_t done = solved_.fetch_add(1) + 1;
    if (calling) tell(Phase::cases, done, 0);
  }
}

std::size_t ManyCases::run(const std::function<std::unique_ptr<CaseSolver>()>& make, int threads) {
  std::vector<std::unique_ptr<CaseSolver>> solver;
  do solver.push_back(make());
  while (std::ssize(solver) < std::min<std::int64_t>(threads, order_.chains()));
  try {
    parallel_for(order_.chains(), 1, static_cast<int>(solver.size()), [&](std::int64_t chain, int thread) {
      if (host_.context->ranks().mine(chain)) solve_chain(*solver[at(thread)], at(chain), thread == 0);
    });
  } catch (const Cancelled&) {
    // Cases that were solved before keep their results.
  }
  if (thrown_) std::rethrow_exception(thrown_);
  std::size_t bytes = 0;
  for (const auto& s : solver) bytes += s->bytes();
  return bytes;
}

Status ManyCases::finish() {
  batch_.give(results_.row, width_, results_.stride);
  for (std::int64_t i = 0; i < list_.cases; ++i) {
    const std::int64_t from = order_.solved_as[at(i)];
    batch_.repeat(i, from);
    if (from != i && width_ > 0) std::copy_n(row(from), width_, row(i));
  }
  return batch_.finish("case", results_.status);
}

}  // namespace

Status solve_cases(const std::function<std::unique_ptr<CaseSolver>()>& make, int threads, const CaseList& cases,
                   const CaseResults& results, const Host& host, std::size_t& bytes) {
  const double start = now_seconds();
  ManyCases many(cases, results, host);
  {
    const BlasThreads blas(1);
    bytes = many.run(make, threads);
  }
  const Status status = many.finish();
  host.context->log(LogLevel::info, "%lld cases, %.3f s", static_cast<long long>(cases.cases), now_seconds() - start);
  return status;
}

void cancel_cases(const CaseList& cases, const CaseResults& results, const Host& host) {
  ManyCases(cases, results, host).finish();
}

}  // namespace rollcon
