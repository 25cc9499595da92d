#pragma once
/// Floating-point environments: ours inside the library, the host's in its callbacks. A host may
/// trap on invalid operations (LAPACK's eigenvalue code divides by zero on purpose), round
/// otherwise, or flush subnormals; it gets all of that back.

#include <cfenv>

namespace rollcon {

/// While it lives, this thread traps nothing, rounds to nearest and keeps subnormals. The
/// destructor restores the former environment, flags included. Also wanted at the start of OpenMP
/// regions: threads of a pool keep the environment in which they were born.
class QuietFloatingPoint {
 public:
  QuietFloatingPoint() noexcept;
  ~QuietFloatingPoint();
  QuietFloatingPoint(const QuietFloatingPoint&) = delete;
  QuietFloatingPoint& operator=(const QuietFloatingPoint&) = delete;

 private:
  friend class HostFloatingPoint;
  std::fenv_t former_;
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
  std::fenv_t quiet_;
};

}  // namespace rollcon
