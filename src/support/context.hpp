#pragma once
/// Holds what a context owns: log sink, thread budget, the failure that its latch keeps.

#include <atomic>
#include <cstdarg>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "support/error.hpp"
#include "support/ranks.hpp"

namespace rollcon {

class EqualBodies;

enum class LogLevel : std::int32_t { error = 1, warning = 2, info = 3, debug = 4 };

class Context {
 public:
  using LogFunction = void (*)(std::int32_t level, const char* message, void* user);

  Context();

  void set_log(std::int32_t max_level, LogFunction function, void* user);
  /// Calls the sink, in the floating-point environment of the host, if the level is wanted.
  void log(LogLevel level, const char* format, ...) const __attribute__((format(printf, 3, 4)));

  /// Logs what a call that is about to return this status > 0 tells, as a warning, and makes it part of the thread's
  /// last caveat.
  void caveat(Status status, const char* format, ...) const __attribute__((format(printf, 3, 4)));

  /// Says whether anybody hears of that level: texts that nobody reads need not be made.
  bool hears(LogLevel level) const {
    return static_cast<std::int32_t>(level) <= log_level_.load(std::memory_order_relaxed);
  }

  /// Takes the ranks that share lists, by the Fortran handle of MPI's communicator.
  void set_communicator(std::int32_t communicator) { ranks_ = Ranks::of(communicator); }
  const Ranks& ranks() const { return ranks_; }

  void set_threads(std::int32_t n);
  /// Returns the threads to use now: the budget (0: OpenMP's default), or 1 inside a parallel region and in loops of
  /// parallel.hpp.
  int threads() const;

  /// Sets the latch, which while on keeps the first failure from here on. Either way, what it kept is forgotten.
  void set_latch(bool on);
  /// Returns the first failure since the latch was set, ok if there was none.
  Status latched() const noexcept { return latched_.load(std::memory_order_relaxed); }
  /// Keeps, if the latch is on, the first failure, and the first caveat until there is one.
  void keep(Status status, const char* text) noexcept;
  /// Returns what the latch keeps; its text becomes the thread's last error.
  Status tell_kept() const noexcept;

  /// Returns the prepared bodies of this context, held by weak references (made by the first of them).
  template <class Make>
  EqualBodies& bodies(Make make) {
    const std::lock_guard lock(mutex_);
    if (!bodies_) bodies_ = make();
    return *bodies_;
  }

 private:
  void tell(std::int32_t level, const char* format, std::va_list args) const;

  mutable std::mutex mutex_;
  LogFunction log_ = nullptr;
  void* log_user_ = nullptr;
  std::atomic<std::int32_t> log_level_{0};  ///< solves ask some ten times, so it is read without the lock
  std::int32_t threads_ = 0;
  bool latch_ = false;
  std::atomic<Status> latched_{Status::ok};  ///< every call asks, so it is read without the lock
  Status kept_ = Status::ok;
  std::string kept_text_;
  std::shared_ptr<EqualBodies> bodies_;
  Ranks ranks_;
};

}  // namespace rollcon
