#pragma once
/// An allocator for the whole process, linked libraries included, whose allocations can be made to fail: malloc,
/// calloc, realloc, aligned_alloc, posix_memalign, memalign, and with them operator new. Of glibc.

#include <cstdint>

namespace hosts {

/// Blocks that were given out and not freed.
std::int64_t live_blocks();
/// Allocations since the program began.
std::int64_t allocations();

/// The allocation after `successes` more of them fails, in whatever thread; `lasting`: so do all after it. Until the
/// next call; negative: none fails.
void fail_after(std::int64_t successes, bool lasting);
/// Whether one has failed since the last call of fail_after.
bool has_failed();
/// Allocations that still succeed; negative: all.
std::int64_t successes_left();

/// Allocations that are made from the code of a shared library with this in its name never fail: the runtimes of
/// compilers end the process when one does.
void spare(const char* library);
/// How many were spared since fail_after.
std::int64_t spared();
/// Name of the library whose code made the first allocation that failed; "" if none did.
const char* failed_in();

}  // namespace hosts
