#pragma once
/// Peak memory of the process, and a count of heap allocations.

#include <cstdint>

namespace rollcon::bench {

/// Peak resident set since the last reset, from /proc/self/status (VmHWM); 0 where there is none.
std::int64_t peak_resident_bytes();
void reset_peak_resident();

/// Calls of malloc, calloc, realloc and aligned_alloc by any thread since the start of the process.
std::int64_t heap_allocations();

}  // namespace rollcon::bench
