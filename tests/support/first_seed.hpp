#pragma once

#include <cstdint>
#include <cstdlib>

namespace rollcon::extremes {

/// Returns where tests of random scenes begin to count seeds: at 1, or at the value of ROLLCON_FIRST_SEED in the
/// environment (scripts/nightly.sh).
inline std::uint32_t first_seed() {
  const char* asked = std::getenv("ROLLCON_FIRST_SEED");
  return asked ? static_cast<std::uint32_t>(std::strtoul(asked, nullptr, 10)) : 1;
}

}  // namespace rollcon::extremes
