#pragma once
/// What each thread keeps in words: its last failure, and its last call that ended with a status above zero.

#include "support/error.hpp"

namespace rollcon {

/// Valid until the thread's next failure; empty before the first one.
const char* last_error() noexcept;

/// Keeps "function: message", or the message alone (function null); cut to the room there is.
void set_last_error(const char* function, const char* message) noexcept;

/// Valid until the thread's next call with a caveat; empty before the first one.
const char* last_caveat() noexcept;

/// What a call that is about to return this status knows beside the status' text; replaces what it said before.
void note_caveat(Status status, const char* detail) noexcept;
/// A call begins: forgets what earlier ones noted.
void forget_caveat_note() noexcept;
/// Keeps "function: general; detail" where the detail was noted for this status, else without it.
void set_last_caveat(const char* function, Status status, const char* general) noexcept;

}  // namespace rollcon
