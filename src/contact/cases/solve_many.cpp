/// Lists of load cases over threads. Chains of neighbouring cases are what threads take: a chain is solved alike by
/// whichever thread, so that results do not depend on how many there are.

#include "contact/cases/solve_many.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <string>
#include <thread>

#ifdef _OPENMP
#include <omp.h>
#endif

#include "contact/cases/case_order.hpp"
#include "contact/cases/case_solver.hpp"
#include "contact/scene/host_interrupt.hpp"
#include "contact/solution.hpp"
#include "linalg/blas_threads.hpp"
#include "support/clock.hpp"
#include "support/fpenv.hpp"

namespace rollcon {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Columns of CaseList::value, what changes the normal problem first: cases that share it come one after the other.
std::vector<std::int64_t> priority(std::span<const Parameter> parameter) {
  std::vector<std::int64_t> columns;
  for (const Parameter p :
       {Parameter::normal, Parameter::friction, Parameter::spin, Parameter::lateral, Parameter::longitudinal})
    for (std::size_t j = 0; j < parameter.size(); ++j)
      if (parameter[j] == p) columns.push_back(static_cast<std::int64_t>(j));
  return columns;
}

struct Failure {
  std::int64_t number;  ///< of the case
  Status status;
  std::string message;
};

/// Threads of a library keep off the host's: loops in them run on one thread.
struct OneLoopThread {
#ifdef _OPENMP
  const int before = omp_get_max_threads();
  OneLoopThread() {
    omp_set_num_threads(1);
  }
  ~OneLoopThread() {
    omp_set_num_threads(before);
  }
#endif
  // Without OpenMP there is nothing to do.
};

class ManyCases {
 public:
  ManyCases(const CaseList& list, const CaseResults& results, std::atomic<bool>& cancel, ProgressFunction function,
            void* user)
      : list_(list),
        results_(results),
        order_(order_cases(list.cases, parameters(), list.value, priority(list.parameter))),
        cancel_(cancel),
        function_(function),
        user_(user) {
    for (const CaseColumn& c : results.column) width_ += c.width;
    clear();
  }

  /// Solves the chains. Rethrows what a progress callback threw.
  void run(const std::function<std::unique_ptr<CaseSolver>()>& make, int threads);
  /// Copies to the repeated cases, and says what the call returns.
  Status finish();
  std::vector<Failure>& failures() { return failures_; }
  std::size_t bytes() const { return bytes_; }

 private:
  /// Told of iterations in the calling thread, silent in others.
  class Watch final : public Monitor {
   public:
    Watch(ManyCases& many, bool calling) : many_(many), calling_(calling) {}
    bool step(const StepRecord& r) override {
      if (calling_)
        many_.tell(static_cast<Phase>(r.part), r.iteration, std::max(r.residual_normal, r.residual_tangential));
      return cancelled();
    }
    bool cancelled() const override { return many_.cancel_.load(); }

   private:
    ManyCases& many_;
    bool calling_;
  };

  std::int64_t parameters() const { return static_cast<std::int64_t>(list_.parameter.size()); }
  const double* values_of(std::int64_t i) const { return list_.value + i * parameters(); }
  void clear();
  void work(CaseSolver& solver, bool calling);
  void solve_chain(CaseSolver& solver, std::size_t chain, Monitor& monitor, bool calling);
  void solve_case(CaseSolver& solver, std::int64_t i, Monitor& monitor);
  void keep(CaseSolver& solver, std::int64_t i);
  void fail_case(std::int64_t i, Status status, const char* message);
  void forget_results(std::int64_t i);
  double* row(std::int64_t i) const { return results_.row + i * results_.stride; }
  void tell(Phase phase, std::int64_t iteration, double residual);

  const CaseList& list_;
  const CaseResults& results_;
  std::int64_t width_ = 0;  ///< numbers in a row
  const CaseOrder order_;
  std::atomic<bool>& cancel_;
  ProgressFunction function_;
  void* user_;
  const double start_ = now_seconds();
  std::vector<Status> status_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::int64_t> solved_{0};
  std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  int working_ = 0;
  std::vector<Failure> failures_;
  std::exception_ptr thrown_;  ///< by a callback
  std::size_t bytes_ = 0;
};

void ManyCases::clear() {
  status_.assign(static_cast<std::size_t>(list_.cases), Status::cancelled);
  for (const std::int64_t i : order_.solved) forget_results(i);
}

void ManyCases::forget_results(std::int64_t i) {
  if (width_ > 0) std::fill_n(row(i), width_, none);
}

void ManyCases::tell(Phase phase, std::int64_t iteration, double residual) {
  if (!function_ || thrown_) return;
  Event event;
  event.phase = static_cast<std::int32_t>(phase);
  event.iteration = iteration;
  event.residual = residual;
  event.seconds = now_seconds() - start_;
  try {
    if (function_(event, user_) != 0) cancel_.store(true);
  } catch (...) {
    thrown_ = std::current_exception();
    cancel_.store(true);
  }
}

void ManyCases::fail_case(std::int64_t i, Status status, const char* message) {
  status_[static_cast<std::size_t>(i)] = status;
  forget_results(i);
  const std::lock_guard lock(mutex_);
  try {
    failures_.push_back({i, status, message});
  } catch (const std::bad_alloc&) {
    // The status tells.
  }
}

void ManyCases::keep(CaseSolver& solver, std::int64_t i) {
  double* to = row(i);
  for (const CaseColumn& c : results_.column) {
    solver.write(c, list_.parameter, values_of(i), to);
    to += c.width;
  }
}

void ManyCases::solve_case(CaseSolver& solver, std::int64_t i, Monitor& monitor) {
  try {
    const Status status = solver.solve(list_.parameter, values_of(i), monitor);
    status_[static_cast<std::size_t>(i)] = status;
    if (status != Status::cancelled) keep(solver, i);
    return;
  } catch (const Error& error) {
    fail_case(i, error.status(), error.what());
  } catch (const std::bad_alloc&) {
    fail_case(i, Status::err_memory, "out of memory");
  } catch (const std::exception& error) {
    fail_case(i, Status::err_internal, error.what());
  } catch (...) {
    fail_case(i, Status::err_internal, "an unknown exception");
  }
  solver.begin_chain();
}

void ManyCases::solve_chain(CaseSolver& solver, std::size_t chain, Monitor& monitor, bool calling) {
  solver.begin_chain();
  for (std::int64_t k = order_.chain_begin[chain]; k < order_.chain_begin[chain + 1]; ++k) {
    if (cancel_.load()) return;
    const std::int64_t i = order_.solved[static_cast<std::size_t>(k)];
    solve_case(solver, i, monitor);
    const std::int64_t done = solved_.fetch_add(1) + 1;
    if (calling) tell(Phase::cases, done, 0);
  }
}

void ManyCases::work(CaseSolver& solver, bool calling) {
  const QuietFloatingPoint quiet;
  [[maybe_unused]] const OneLoopThread loops;
  Watch watch(*this, calling);
  while (!cancel_.load()) {
    const std::size_t k = next_.fetch_add(1);
    if (k + 1 >= order_.chain_begin.size()) break;
    solve_chain(solver, k, watch, calling);
  }
}

void ManyCases::run(const std::function<std::unique_ptr<CaseSolver>()>& make, int threads) {
  const auto wanted = std::clamp<std::int64_t>(threads, 1, order_.chains());
  std::vector<std::unique_ptr<CaseSolver>> solver;
  for (std::int64_t t = 0; t < wanted; ++t) solver.push_back(make());
  std::vector<std::thread> helper;
  helper.reserve(solver.size() - 1);
  for (std::size_t t = 1; t < solver.size(); ++t) {
    try {
      helper.emplace_back([this, &own = *solver[t]] {
        work(own, false);
        const std::lock_guard lock(mutex_);
        --working_;
        changed_.notify_all();
      });
    } catch (const std::exception&) {
      break;  // no more threads to be had
    }
    const std::lock_guard lock(mutex_);
    ++working_;
  }
  work(*solver[0], true);
  // The caller hears of the others' cases, and may cancel, while it waits.
  for (bool busy = true; busy;) {
    {
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, std::chrono::milliseconds(50), [this] { return working_ == 0; });
      busy = working_ != 0;
    }
    if (busy) tell(Phase::cases, solved_.load(), 0);
  }
  for (std::thread& t : helper) t.join();
  bytes_ = 0;
  for (const auto& s : solver) bytes_ += s->bytes();
  if (thrown_) std::rethrow_exception(thrown_);
}

Status ManyCases::finish() {
  bool stopped = false, missed = false, coarse = false, rim = false, inaccurate = false, open = false;
  for (std::int64_t i = 0; i < list_.cases; ++i) {
    const std::int64_t from = order_.solved_as[static_cast<std::size_t>(i)];
    const Status status = status_[static_cast<std::size_t>(from)];
    if (results_.status) results_.status[i] = static_cast<std::int32_t>(status);
    if (from != i && width_ > 0) std::copy_n(row(from), width_, row(i));
    stopped = stopped || status == Status::cancelled;
    missed = missed || status == Status::not_converged || static_cast<std::int32_t>(status) < 0;
    coarse = coarse || status == Status::coarse;
    rim = rim || status == Status::rim_contact;
    inaccurate = inaccurate || status == Status::inaccurate;
    open = open || status == Status::no_contact;
  }
  std::sort(failures_.begin(), failures_.end(), [](const Failure& a, const Failure& b) { return a.number < b.number; });
  if (stopped) return Status::cancelled;
  if (missed) return Status::not_converged;
  if (coarse) return Status::coarse;
  if (rim) return Status::rim_contact;
  return inaccurate ? Status::inaccurate : open ? Status::no_contact : Status::ok;
}

}  // namespace

Status solve_cases(const std::function<std::unique_ptr<CaseSolver>()>& make, int threads, const CaseList& cases,
                   const CaseResults& results, const CaseHost& host, std::size_t& bytes) {
  const double start = now_seconds();
  ManyCases many(cases, results, host.cancel, host.progress, host.user);
  {
    const BlasThreads blas(1);
    many.run(make, threads);
  }
  bytes = many.bytes();
  const Status status = many.finish();
  for (const Failure& f : many.failures())
    host.context.log(LogLevel::warning, "case %lld (counting from 0): %s", static_cast<long long>(f.number),
                     f.message.c_str());
  host.context.log(LogLevel::info, "%lld cases, %.3f s", static_cast<long long>(cases.cases), now_seconds() - start);
  return status;
}

void cancel_cases(const CaseList& cases, const CaseResults& results, const CaseHost& host) {
  ManyCases(cases, results, host.cancel, host.progress, host.user).finish();
}

}  // namespace rollcon
