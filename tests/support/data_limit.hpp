#pragma once
/// Limits what a test's process may have, to see what it does where memory is short.

#include <sys/resource.h>

#include "support/memory_limit.hpp"

namespace rollcon {

/// Limits this process to so many bytes of data beyond those that it has.
class DataLimit {
 public:
  explicit DataLimit(double bytes) {
    getrlimit(RLIMIT_DATA, &before_);
    rlimit least = before_;
    const double huge = 1e15;
    least.rlim_cur = static_cast<rlim_t>(huge);
    setrlimit(RLIMIT_DATA, &least);
    const double held = huge - memory_sources().data;
    least.rlim_cur = static_cast<rlim_t>(held + bytes);
    setrlimit(RLIMIT_DATA, &least);
  }
  ~DataLimit() { setrlimit(RLIMIT_DATA, &before_); }
  DataLimit(const DataLimit&) = delete;
  DataLimit& operator=(const DataLimit&) = delete;

 private:
  rlimit before_{};
};

}  // namespace rollcon
