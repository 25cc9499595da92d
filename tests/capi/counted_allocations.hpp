#pragma once
/// Declares the operator new of these tests, which is in allocation_test.cpp: it counts, and fails where it is told to.

#include <cstdint>

namespace capi_test {

extern thread_local std::int64_t allocations;
extern thread_local bool failed;
extern thread_local std::int64_t until_failure;  ///< allocations that still succeed; < 0: all

}  // namespace capi_test
