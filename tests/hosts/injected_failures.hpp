#pragma once
/// Replaces the allocator of the whole process, linked libraries included, by one whose allocations can be made to
/// fail: malloc, calloc, realloc, aligned_alloc, posix_memalign, memalign, and with them operator new. It needs glibc.

#include <cstdint>

namespace hosts {

/// Returns the number of blocks that were given out and not freed.
std::int64_t live_blocks();
/// Returns the number of allocations since the program began.
std::int64_t allocations();

/// Makes the allocation after `successes` more of them fail, in whatever thread, and with `lasting` all after it, until
/// the next call; negative: none fails.
void fail_after(std::int64_t successes, bool lasting);
/// Says whether one has failed since the last call of fail_after.
bool has_failed();
/// Returns the number of allocations that still succeed; negative: all.
std::int64_t successes_left();

/// Spares allocations that are made from the code of a shared library with this in its name: the runtimes of compilers
/// end the process when one fails.
void spare(const char* library);
/// Returns how many were spared since fail_after.
std::int64_t spared();
/// Returns the name of the library whose code made the first allocation that failed; "" if none did.
const char* failed_in();

}  // namespace hosts
