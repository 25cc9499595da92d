#pragma once
/// CHOLMOD's control block for the length of a scope: silent, and within the caller's threads.

#include <cholmod.h>

#ifdef _OPENMP
#include <omp.h>
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

/// CHOLMOD's own parallel loops, which only move data, ask for a fixed number of threads whatever
/// the budget: inside this scope they run on one. The BLAS has threads of its own.
class [[maybe_unused]] SerialLoops {
 public:
#ifdef _OPENMP
  SerialLoops() : levels_(omp_get_max_active_levels()) {
    omp_set_max_active_levels(0);
  }
  ~SerialLoops() {
    omp_set_max_active_levels(levels_);
  }

 private:
  int levels_;

 public:
#else
  SerialLoops() = default;
#endif
  SerialLoops(const SerialLoops&) = delete;
  SerialLoops& operator=(const SerialLoops&) = delete;
};

}  // namespace rollcon
