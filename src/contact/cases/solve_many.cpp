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
#include "contact/prepare/reach.hpp"
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
        user_(user),
        again_(order_.chain_begin.size(), false) {
    for (const CaseColumn& c : results.column) width_ += c.width;
    clear();
  }

  /// Solves the chains not solved yet. Rethrows what a progress callback threw.
  void run(SolverState& scene, const Options& options, int threads);
  /// Chains whose cases reached beyond the rows that are there; they are to be solved again.
  bool any_again() const { return std::find(again_.begin(), again_.end(), 1) != again_.end(); }
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
  bool solve_case(CaseSolver& solver, std::int64_t i, Monitor& monitor);
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
  std::vector<std::uint8_t> again_;
  std::vector<std::size_t> waiting_;  ///< chains
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
  for (std::size_t chain = 0; chain + 1 < order_.chain_begin.size(); ++chain) waiting_.push_back(chain);
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
    switch (c.kind) {
      case CaseColumn::Kind::force:
        solver.resultant(to, nullptr);
        break;
      case CaseColumn::Kind::moment:
        solver.resultant(nullptr, to);
        break;
      case CaseColumn::Kind::approach:
        solver.motion(to, nullptr);
        break;
      case CaseColumn::Kind::creep:
        solver.motion(nullptr, to);
        break;
      case CaseColumn::Kind::derivatives:
        solver.derivatives(list_.parameter, values_of(i), to);
        break;
      case CaseColumn::Kind::tractions:
        solver.tractions(to);
        break;
      case CaseColumn::Kind::number:
        *to = solver.number(c.number);
        break;
    }
    to += c.width;
  }
}

// False: the whole chain has to wait for more rows.
bool ManyCases::solve_case(CaseSolver& solver, std::int64_t i, Monitor& monitor) {
  try {
    const Status status = solver.solve(list_.parameter, values_of(i), monitor);
    if (solver.out_of_reach()) return false;
    status_[static_cast<std::size_t>(i)] = status;
    if (status != Status::cancelled) keep(solver, i);
    return true;
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
  return true;
}

void ManyCases::solve_chain(CaseSolver& solver, std::size_t chain, Monitor& monitor, bool calling) {
  solver.begin_chain();
  for (std::int64_t k = order_.chain_begin[chain]; k < order_.chain_begin[chain + 1]; ++k) {
    if (cancel_.load()) return;
    const std::int64_t i = order_.solved[static_cast<std::size_t>(k)];
    if (!solve_case(solver, i, monitor)) {
      again_[chain] = true;
      return;
    }
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
    if (k >= waiting_.size()) break;
    solve_chain(solver, waiting_[k], watch, calling);
  }
}

void ManyCases::run(SolverState& scene, const Options& options, int threads) {
  if (any_again()) {
    waiting_.clear();
    for (std::size_t chain = 0; chain < again_.size(); ++chain) {
      if (!again_[chain]) continue;
      again_[chain] = false;
      waiting_.push_back(chain);
      for (std::int64_t k = order_.chain_begin[chain]; k < order_.chain_begin[chain + 1]; ++k) {
        const std::int64_t i = order_.solved[static_cast<std::size_t>(k)];
        status_[static_cast<std::size_t>(i)] = Status::cancelled;
        forget_results(i);
        std::erase_if(failures_, [i](const Failure& f) { return f.number == i; });
      }
    }
  }
  next_.store(0);
  const auto chains = static_cast<std::int64_t>(waiting_.size());
  const auto wanted = can_share(scene) ? std::clamp<std::int64_t>(threads, 1, chains) : 1;
  std::vector<std::unique_ptr<CaseSolver>> solver;
  for (std::int64_t t = 0; t < wanted; ++t) solver.push_back(std::make_unique<CaseSolver>(scene, options));
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
  bool stopped = false, missed = false, coarse = false, rim = false, open = false;
  for (std::int64_t i = 0; i < list_.cases; ++i) {
    const std::int64_t from = order_.solved_as[static_cast<std::size_t>(i)];
    const Status status = status_[static_cast<std::size_t>(from)];
    if (results_.status) results_.status[i] = static_cast<std::int32_t>(status);
    if (from != i && width_ > 0) std::copy_n(row(from), width_, row(i));
    stopped = stopped || status == Status::cancelled;
    missed = missed || status == Status::not_converged || static_cast<std::int32_t>(status) < 0;
    coarse = coarse || status == Status::coarse;
    rim = rim || status == Status::rim_contact;
    open = open || status == Status::no_contact;
  }
  std::sort(failures_.begin(), failures_.end(), [](const Failure& a, const Failure& b) { return a.number < b.number; });
  if (stopped) return Status::cancelled;
  if (missed) return Status::not_converged;
  if (coarse) return Status::coarse;
  return rim ? Status::rim_contact : open ? Status::no_contact : Status::ok;
}

}  // namespace

void reach_for_cases(SolverState& s, const Options& options, const CaseList& list) {
  if (!s.procedure.standard() || !s.prepared->problem.op->dense() || list.cases == 0) return;
  const Prescribed given = s.given;
  const auto width = static_cast<std::int64_t>(list.parameter.size());
  for (std::size_t j = 0; j < list.parameter.size(); ++j) {
    double most = -INFINITY;
    for (std::int64_t i = 0; i < list.cases; ++i)
      most = std::max(most, list.value[i * width + static_cast<std::int64_t>(j)]);
    if (list.parameter[j] == Parameter::normal)
      s.given.prescribe_normal(s.given.by_force[approach], most, s.prepared->problem.datum);
    if (list.parameter[j] == Parameter::friction) s.given.friction = most;
  }
  try {
    choose_reach(s, options);
    require_rows(s, options, s.reach.wanted);
  } catch (...) {
    s.given = given;
    throw;
  }
  s.given = given;
}

Status solve_cases(SolverState& s, const Options& options, const CaseList& cases, const CaseResults& results,
                   const CaseHost& host) {
  const double start = now_seconds();
  ManyCases many(cases, results, host.cancel, host.progress, host.user);
  {
    const BlasThreads blas(1);
    many.run(s, options, host.context.threads());
  }
  if (many.any_again() && !host.cancel.load()) {
    require_rows(s, options, {});
    const BlasThreads blas(1);
    many.run(s, options, host.context.threads());
  }
  s.peak_bytes = std::max(s.peak_bytes, s.bytes() + many.bytes());
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
