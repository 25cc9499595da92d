#pragma once
/// What a context owns: log sink, thread budget, text of the last failure.

#include <atomic>
#include <cstdarg>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

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

  void set_threads(std::int32_t n);
  /// Threads to use now: the budget (0: OpenMP's default); 1 inside a parallel region.
  int threads() const;

  /// Keeps "function: message", cut where there is no memory for it.
  void set_error(const char* function, const char* message) noexcept;
  std::string error() const;

  /// The prepared bodies of this context, kept by weak references (set by the first of them).
  template <class Make>
  EqualBodies& bodies(Make make) {
    const std::lock_guard lock(mutex_);
    if (!bodies_) bodies_ = make();
    return *bodies_;
  }

 private:
  void tell(std::int32_t level, const char* format, std::va_list args) const;

  mutable std::mutex mutex_;
  std::string error_;
  LogFunction log_ = nullptr;
  void* log_user_ = nullptr;
  std::atomic<std::int32_t> log_level_{0};  ///< solves ask some ten times: read without the lock
  std::int32_t threads_ = 0;
  std::shared_ptr<EqualBodies> bodies_;
};

}  // namespace rollcon
