#pragma once
/// Copies results out to the caller's arrays.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "support/input_checks.hpp"

namespace rollcon::capi {

/// Sets `needed`, then says whether to copy: returns false for capacity 0, when the caller only asks; throws
/// err_capacity when the array is too small.
inline bool wants_copy(std::int64_t count, std::int64_t capacity, const void* to, const char* name,
                       std::int64_t* needed, const char* unit) {
  if (capacity < 0)
    fail(Status::err_argument, "capacity is %lld; allowed: 0 or more", static_cast<long long>(capacity));
  if (capacity == 0) {
    if (!needed) fail(Status::err_argument, "capacity is 0 and there is no place for the need");
    *needed = count;
    return false;
  }
  require_pointer(to, name);
  if (needed) *needed = count;
  if (capacity < count)
    fail(Status::err_capacity, "capacity is %lld %s; needed: %lld", static_cast<long long>(capacity), unit,
         static_cast<long long>(count));
  return true;
}

/// Checks that the fields at n points are finite; either may be null.
inline void require_finite_fields(std::int64_t n, const double* displacement, const double* stress) {
  if (displacement) require_finite_results(n, 3, displacement, "displacement");
  if (stress) require_finite_results(n, 6, stress, "stress");
}

/// Copies the text with its terminating NUL, which counts in capacity and `needed`.
inline void copy_text(std::string_view from, std::int64_t capacity, char* text, std::int64_t* needed) {
  const auto count = static_cast<std::int64_t>(from.size()) + 1;
  if (!wants_copy(count, capacity, text, "text", needed, "bytes")) return;
  std::memcpy(text, from.data(), from.size());
  text[from.size()] = '\0';
}

/// Checks the number of points; `doubles` is how many numbers the longest array holds for each point.
inline void require_points(std::int64_t n, std::int64_t doubles) {
  require_count(n, "n");
  if (n > PTRDIFF_MAX / (doubles * std::int64_t{sizeof(double)}))
    fail(Status::err_argument, "n is %lld: beyond the address space", static_cast<long long>(n));
}

/// Checks that the coordinates of n points are finite; `names` holds one letter for each coordinate.
inline void require_finite_points(std::int64_t n, const double* x, std::int64_t coordinates, const char* names) {
  for (std::int64_t i = 0; i < coordinates * n; ++i)
    if (!std::isfinite(x[i]))
      fail(Status::err_nonfinite, "coordinate %c of point %lld (counting from 0) is %g", names[i % coordinates],
           static_cast<long long>(i / coordinates), x[i]);
}

}  // namespace rollcon::capi
