#pragma once
/// Checks what callers hand in. Each check throws Error with a message that names the argument and, in arrays, the
/// entry in the caller's count.

#include <cmath>
#include <cstdint>

#include "support/error.hpp"

namespace rollcon {

inline void require_pointer(const void* pointer, const char* name) {
  if (!pointer) fail(Status::err_argument, "%s is NULL", name);
}

inline void require_finite(double value, const char* name) {
  if (!std::isfinite(value)) fail(Status::err_nonfinite, "%s is %g", name, value);
}

/// Checks arrays of n entries with `components` values each; entries are counted from `base`.
inline void require_finite(std::int64_t n, int components, const double* value, const char* name, std::int32_t base) {
  for (std::int64_t i = 0; i < n; ++i) {
    for (int j = 0; j < components; ++j) {
      const double v = value[i * components + j];
      if (std::isfinite(v)) continue;
      if (components == 1)
        fail(Status::err_nonfinite, "%s of node %lld (counting from %d) is %g", name, static_cast<long long>(i) + base,
             base, v);
      fail(Status::err_nonfinite, "component %d of %s of node %lld (both counting from %d) is %g", j + base, name,
           static_cast<long long>(i) + base, base, v);
    }
  }
}

/// Checks a list of n numbers.
inline void require_list(std::int64_t n, const double* value, const char* name) {
  require_pointer(value, name);
  for (std::int64_t i = 0; i < n; ++i)
    if (!std::isfinite(value[i]))
      fail(Status::err_nonfinite, "entry %lld of %s (counting from 0) is %g", static_cast<long long>(i), name,
           value[i]);
}

/// Checks n results with `components` values each, before they go out: a result that is no number is no success.
inline void require_finite_results(std::int64_t n, int components, const double* value, const char* name) {
  for (std::int64_t k = 0; k < n * components; ++k)
    if (!std::isfinite(value[k]))
      fail(Status::err_nonfinite,
           "value %lld of %s of entry %lld (both counting from 0) comes out as %g: inputs so "
           "large or small leave no digits",
           static_cast<long long>(k % components), name, static_cast<long long>(k / components), value[k]);
}

inline void require_count(std::int64_t n, const char* name) {
  if (n < 0) fail(Status::err_argument, "%s is %lld; allowed: 0 or more", name, static_cast<long long>(n));
}

inline void require_ascending(double less, const char* name, double greater, const char* name_of_greater) {
  require_finite(less, name);
  require_finite(greater, name_of_greater);
  if (!(less < greater))
    fail(Status::err_argument, "%s is %g and %s is %g; allowed: the first less than the second", name, less,
         name_of_greater, greater);
}

inline void require_index_base(std::int32_t index_base) {
  if (index_base != 0 && index_base != 1) fail(Status::err_argument, "index_base is %d; allowed: 0, 1", index_base);
}

/// Checks the components x, y, z of v.
inline void require_finite_vector(const double* v, const char* name) {
  require_pointer(v, name);
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(v[i])) fail(Status::err_nonfinite, "component %c of %s is %g", "xyz"[i], name, v[i]);
  }
}

}  // namespace rollcon
