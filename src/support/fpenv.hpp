#pragma once
/// Sets floating-point environments and locales: rollcon's inside the library, the host's in its callbacks. A host may
/// trap on invalid operations (LAPACK's eigenvalue code divides by zero on purpose), round otherwise, flush subnormals,
/// or write numbers with a comma; it gets all of that back.

#include <locale.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif

#include "support/fp_state.hpp"

namespace rollcon {

/// Makes this thread trap nothing, round to nearest, keep subnormals and write numbers the way C does, while it lives.
/// The destructor restores the former environment, flags included. New threads need it, too, because they have the
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
  const QuietFloatingPoint* outer_;  ///< enclosing one of this thread
};

/// Gives this thread, while it lives, the environment that the innermost QuietFloatingPoint replaced.
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
