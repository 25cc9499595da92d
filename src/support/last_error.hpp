#pragma once
/// The text of the last failure in each thread.

namespace rollcon {

/// Valid until the thread's next failure; empty before the first one.
const char* last_error() noexcept;

/// Keeps "function: message", or the message alone (function null); cut to the room there is.
void set_last_error(const char* function, const char* message) noexcept;

}  // namespace rollcon
