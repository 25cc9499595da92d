#include "support/interrupt.hpp"

#include "support/clock.hpp"

namespace rollcon {
namespace {

constexpr double between = 0.1;  // seconds, which a person takes for at once

thread_local Interrupt* asked = nullptr;

}  // namespace

Interrupt::Interrupt() : former_(asked), told_(now_seconds()) {
  asked = this;
}

Interrupt::~Interrupt() {
  asked = former_;
}

Interrupt* Interrupt::current() {
  return asked;
}

void Interrupt::check(bool own) {
  if (wanted()) throw Cancelled{};
  if (!own) return;
  const double now = now_seconds();
  if (now - told_ < between) return;
  tell();
  told_ = now_seconds();
  if (wanted()) throw Cancelled{};
}

void check_interrupt() {
  if (asked) asked->check();
}

}  // namespace rollcon
