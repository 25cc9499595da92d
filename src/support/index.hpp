#pragma once
/// Converts counts and numbers, which are signed, with 64 bits, like those of the public interface, for the C++
/// library's containers, which ask for unsigned ones.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "support/error.hpp"

namespace rollcon {

constexpr std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

/// Turns a floating number into an index or a count, cut off towards zero. Throws Error(err_argument) beyond 2^53 and
/// for NaN, which overflow makes of lengths that have nothing to do with each other: a cast would return any number
/// there.
inline std::int64_t to_index(double x) {
  if (!(std::abs(x) <= 0x1p53))
    fail(Status::err_argument,
         "a length of the scene is %g times the size that it is compared with; allowed: up to 9e15 (units?)",
         std::abs(x));
  return static_cast<std::int64_t>(x);
}

}  // namespace rollcon
