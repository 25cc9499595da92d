#include "support/fpenv.hpp"

namespace rollcon {

namespace {

thread_local const QuietFloatingPoint* innermost = nullptr;

}  // namespace

QuietFloatingPoint::QuietFloatingPoint() noexcept : outer_(innermost) {
  std::fegetenv(&former_);
  std::fesetenv(FE_DFL_ENV);
  innermost = this;
}

QuietFloatingPoint::~QuietFloatingPoint() {
  innermost = outer_;
  std::fesetenv(&former_);
}

HostFloatingPoint::HostFloatingPoint() noexcept {
  std::fegetenv(&quiet_);
  if (innermost) std::fesetenv(&innermost->former_);
}

HostFloatingPoint::~HostFloatingPoint() {
  std::fesetenv(&quiet_);
}

}  // namespace rollcon
