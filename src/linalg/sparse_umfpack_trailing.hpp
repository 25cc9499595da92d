#pragma once
/// The end of UMFPACK's factors. Where the condensed unknowns are the last pivots, of rows and of columns, the trailing
/// blocks are the factors of the condensed matrix.

#include <cstdint>
#include <span>
#include <vector>

namespace rollcon {

/// Inverse of the condensed matrix, condensed unknowns in the order given, column-major. Empty when UMFPACK has taken
/// other pivots last. While it runs, one of the two factors is held a second time, with its indices; `copied` tells the
/// bytes.
std::vector<double> invert_trailing(void* numeric, std::int64_t n, std::span<const std::int64_t> condensed,
                                    std::size_t* copied);

}  // namespace rollcon
