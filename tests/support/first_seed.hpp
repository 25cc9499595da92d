#pragma once

#include <cstdint>
#include <cstdlib>

namespace rollcon::extremes {

/// Where tests of random scenes begin to count seeds: at 1, or as the environment's ROLLCON_FIRST_SEED says
/// (scripts/nightly.sh).
inline std::uint32_t first_seed() {
  const char* asked = std::getenv("ROLLCON_FIRST_SEED");
  return asked ? static_cast<std::uint32_t>(std::strtoul(asked, nullptr, 10)) : 1;
}

}  // namespace rollcon::extremes
