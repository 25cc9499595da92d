#pragma once
/// Reads the peak memory of the process, and counts heap allocations.

#include <cstdint>

namespace rollcon::bench {

/// Returns the peak resident set since the last reset, from /proc/self/status (VmHWM); 0 where there is none.
std::int64_t peak_resident_bytes();
void reset_peak_resident();

/// Returns the calls of malloc, calloc, realloc and aligned_alloc by any thread since the start of the process.
std::int64_t heap_allocations();

}  // namespace rollcon::bench
