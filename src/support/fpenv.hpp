#pragma once
/// Floating-point environments and locales: ours inside the library, the host's in its callbacks. A host may trap on
/// invalid operations (LAPACK's eigenvalue code divides by zero on purpose), round otherwise, flush subnormals, or
/// write numbers with a comma; it gets all of that back.

#include <locale.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif

#include "support/fp_state.hpp"

namespace rollcon {

/// While it lives, this thread traps nothing, rounds to nearest, keeps subnormals and writes numbers as C does. The
/// destructor restores the former environment, flags included. Also wanted at the start of threads: they have the
/// environment in which they were born.
class QuietFloatingPoint {
 public:
  QuietFloatingPoint() noexcept;
  ~QuietFloatingPoint();
  QuietFloatingPoint(const QuietFloatingPoint&) = delete;
  QuietFloatingPoint& operator=(const QuietFloatingPoint&) = delete;

 private:
  friend class HostFloatingPoint;
  FpState former_;
  locale_t former_locale_;
  const QuietFloatingPoint* outer_;  ///< of the same thread
};

/// While it lives, this thread has the environment that the innermost QuietFloatingPoint replaced.
class HostFloatingPoint {
 public:
  HostFloatingPoint() noexcept;
  ~HostFloatingPoint();
  HostFloatingPoint(const HostFloatingPoint&) = delete;
  HostFloatingPoint& operator=(const HostFloatingPoint&) = delete;

 private:
  FpState quiet_;
  locale_t quiet_locale_;
};

}  // namespace rollcon
