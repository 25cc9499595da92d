#include "support/fpenv.hpp"

namespace rollcon {

namespace {

thread_local const QuietFloatingPoint* innermost = nullptr;

/// Returns the C locale for this thread, in the form that uselocale takes and gives; null changes nothing.
locale_t c_locale() noexcept {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", locale_t{});
  return plain;
}

}  // namespace

QuietFloatingPoint::QuietFloatingPoint() noexcept : outer_(innermost) {
  former_.save();
  former_.quiet();
  former_locale_ = uselocale(c_locale());
  innermost = this;
}

QuietFloatingPoint::~QuietFloatingPoint() {
  innermost = outer_;
  uselocale(former_locale_);
  former_.restore();
}

HostFloatingPoint::HostFloatingPoint() noexcept {
  quiet_.save();
  quiet_locale_ = uselocale(innermost ? innermost->former_locale_ : locale_t{});
  if (innermost) innermost->former_.restore();
}

HostFloatingPoint::~HostFloatingPoint() {
  uselocale(quiet_locale_);
  quiet_.restore();
}

}  // namespace rollcon
