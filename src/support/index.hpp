#pragma once
/// Counts and numbers are signed, with 64 bits, as in the public interface; the C++ library's containers ask for
/// unsigned ones.

#include <cstddef>
#include <cstdint>

namespace rollcon {

constexpr std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace rollcon
