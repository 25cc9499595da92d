#pragma once
/// Checks what the laws' parameters have in common.

#include "support/error.hpp"

namespace rollcon {

inline void require_coefficient(double mu, const char* name) {
  if (mu < 0) fail(Status::err_argument, "%s is %g; allowed: 0 or more", name, mu);
}

}  // namespace rollcon
