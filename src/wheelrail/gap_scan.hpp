#pragma once
/// Scans the gap along a wheel's profile, span by span, for its least value and for the intervals in which it is
/// negative. Spans in which neither can be are passed by.

#include <vector>

#include "wheelrail/overlap_patch.hpp"

namespace rollcon {

/// Infinite where the wheel is beside the rail.
double least_gap(ProfileGap gap);
/// In the order of s; overwritten.
void find_overlaps(ProfileGap gap, std::vector<Overlap>& overlap);

}  // namespace rollcon
