#pragma once
/// Holds CHOLMOD's control block for the length of a scope, silent and within the caller's threads.

#include <cholmod.h>

#ifdef _OPENMP
#include <omp.h>

#include <mutex>
#endif

namespace rollcon {

struct CholmodCommon {
  cholmod_common c;
  CholmodCommon() {
    cholmod_l_start(&c);
    c.print = 0;
    c.error_handler = nullptr;
  }
  ~CholmodCommon() { cholmod_l_finish(&c); }
  CholmodCommon(const CholmodCommon&) = delete;
  CholmodCommon& operator=(const CholmodCommon&) = delete;
};

/// Runs CHOLMOD's own parallel loops, which only move data and ask for a fixed number of threads whatever the budget,
/// on one thread inside this scope. The BLAS has threads of its own. Where the setting is the process's, a scope that
/// finds the zero of another one restores what that one found.
class [[maybe_unused]] SerialLoops {
 public:
#ifdef _OPENMP
  SerialLoops() {
    const std::lock_guard lock(mutex_);
    levels_ = omp_get_max_active_levels();
    if (users_++ == 0)
      first_ = levels_;
    else if (levels_ == 0)
      levels_ = first_;
    omp_set_max_active_levels(0);
  }
  ~SerialLoops() {
    const std::lock_guard lock(mutex_);
    --users_;
    omp_set_max_active_levels(levels_);
  }

 private:
  int levels_ = 1;
  static inline std::mutex mutex_;
  static inline int users_ = 0, first_ = 1;

 public:
#else
  SerialLoops() = default;
#endif
  SerialLoops(const SerialLoops&) = delete;
  SerialLoops& operator=(const SerialLoops&) = delete;
};

}  // namespace rollcon
