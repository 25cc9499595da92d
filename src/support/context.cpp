#include "support/context.hpp"

#include <cstdarg>
#include <cstdio>
#include <utility>

#include "support/error.hpp"
#include "support/fpenv.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace rollcon {

namespace {

constexpr std::int32_t max_threads = 4096;

}  // namespace

void Context::set_log(std::int32_t max_level, LogFunction function, void* user) {
  if (max_level < 0 || max_level > static_cast<std::int32_t>(LogLevel::debug))
    fail(Status::err_argument, "max_level is %d; allowed: 0 (off), 1, 2, 3, 4", max_level);
  const std::lock_guard lock(mutex_);
  log_level_ = function ? max_level : 0;
  log_ = function;
  log_user_ = user;
}

void Context::log(LogLevel level, const char* format, ...) const {
  const auto number = static_cast<std::int32_t>(level);
  LogFunction sink = nullptr;
  void* user = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (number > log_level_) return;
    sink = log_;
    user = log_user_;
  }
  // A buffer on the stack: solves that must not allocate may log. Longer lines are cut.
  char line[1024];
  std::va_list args;
  va_start(args, format);
  std::vsnprintf(line, sizeof line, format, args);
  va_end(args);
  const HostFloatingPoint host;
  sink(number, line, user);
}

void Context::set_threads(std::int32_t n) {
  if (n < 0 || n > max_threads)
    fail(Status::err_argument, "n is %d; allowed: 0 (OpenMP decides) to %d", n, max_threads);
  const std::lock_guard lock(mutex_);
  threads_ = n;
}

int Context::threads() const {
#ifdef _OPENMP
  if (omp_in_parallel()) return 1;
  const std::lock_guard lock(mutex_);
  return threads_ > 0 ? threads_ : omp_get_max_threads();
#else
  return 1;
#endif
}

void Context::set_error(std::string text) {
  const std::lock_guard lock(mutex_);
  error_ = std::move(text);
}

std::string Context::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

}  // namespace rollcon
