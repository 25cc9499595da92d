#include "support/context.hpp"

#include <algorithm>
#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "support/error.hpp"
#include "support/fpenv.hpp"
#include "support/last_error.hpp"
#include "support/parallel.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace rollcon {

namespace {

constexpr std::int32_t max_threads = 4096;
constexpr std::size_t room_for_text = 2048;  ///< room for the text of a call that finds no memory

}  // namespace

Context::Context() = default;

void Context::set_log(std::int32_t max_level, LogFunction function, void* user) {
  if (max_level < 0 || max_level > static_cast<std::int32_t>(LogLevel::debug))
    fail(Status::err_argument, "max_level is %d; allowed: 0 (off), 1, 2, 3, 4", max_level);
  const std::lock_guard lock(mutex_);
  log_level_.store(function ? max_level : 0, std::memory_order_relaxed);
  log_ = function;
  log_user_ = user;
}

void Context::log(LogLevel level, const char* format, ...) const {
  std::va_list args;
  va_start(args, format);
  tell(static_cast<std::int32_t>(level), format, args);
  va_end(args);
}

void Context::caveat(Status status, const char* format, ...) const {
  char line[768];
  std::va_list args;
  va_start(args, format);
  std::vsnprintf(line, sizeof line, format, args);
  va_end(args);
  note_caveat(status, line);
  log(LogLevel::warning, "%s", line);
}

void Context::tell(std::int32_t level, const char* format, std::va_list args) const {
  if (level > log_level_.load(std::memory_order_relaxed)) return;
  LogFunction sink = nullptr;
  void* user = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (level > log_level_) return;
    sink = log_;
    user = log_user_;
  }
  // The buffer is on the stack, because solves that must not allocate may log. Longer lines are cut.
  char line[1024];
  // NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized): log() has started it
  std::vsnprintf(line, sizeof line, format, args);
  const HostFloatingPoint host;
  sink(level, line, user);
}

void Context::set_threads(std::int32_t n) {
  if (n < 0 || n > max_threads)
    fail(Status::err_argument, "n is %d; allowed: 0 (OpenMP decides) to %d", n, max_threads);
  const std::lock_guard lock(mutex_);
  threads_ = n;
}

int Context::threads() const {
#ifdef _OPENMP
  if (omp_in_parallel() || in_threads()) return 1;
  const std::lock_guard lock(mutex_);
  return threads_ > 0 ? threads_ : omp_get_max_threads();
#else
  return 1;
#endif
}

void Context::set_latch(bool on) {
  const std::lock_guard lock(mutex_);
  if (on) kept_text_.reserve(room_for_text);
  latch_ = on;
  kept_ = Status::ok;
  latched_.store(Status::ok, std::memory_order_relaxed);
  kept_text_.clear();
}

void Context::keep(Status status, const char* text) noexcept {
  const std::lock_guard lock(mutex_);
  const bool failure = static_cast<std::int32_t>(status) < 0;
  if (!latch_ || status == Status::ok || static_cast<std::int32_t>(kept_) < 0) return;
  if (!failure && kept_ != Status::ok) return;
  kept_ = status;
  if (failure) latched_.store(status, std::memory_order_relaxed);
  kept_text_.assign(text, std::min(std::strlen(text), kept_text_.capacity()));
}

Status Context::tell_kept() const noexcept {
  const std::lock_guard lock(mutex_);
  if (kept_ != Status::ok) set_last_error(nullptr, kept_text_.c_str());
  return kept_;
}

}  // namespace rollcon
