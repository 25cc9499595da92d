#pragma once
/// Holds what each thread remembers in words: its last failure, and its last call that ended with a status above zero.

#include "support/error.hpp"

namespace rollcon {

/// Returns the last failure's text, valid until the thread's next failure; it is empty before the first one.
const char* last_error() noexcept;

/// Stores "function: message", or the message alone (function null), cut to the room there is.
void set_last_error(const char* function, const char* message) noexcept;

/// Returns the last caveat's text, valid until the thread's next call with a caveat; it is empty before the first one.
const char* last_caveat() noexcept;

/// Notes what a call that is about to return this status knows beside the status's text; replaces what it said before.
void note_caveat(Status status, const char* detail) noexcept;
/// Forgets, as a call begins, what earlier ones noted.
void forget_caveat_note() noexcept;
/// Stores "function: general; detail" where the detail was noted for this status, else without it.
void set_last_caveat(const char* function, Status status, const char* general) noexcept;

}  // namespace rollcon
