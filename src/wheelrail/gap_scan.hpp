#pragma once
/// Scans the gap along a wheel's profile, span by span, for its least value and for the intervals in which it is
/// negative, each with one least value: those with several are divided where it is greatest between them. Spans in
/// which neither can be are passed by.

#include <optional>
#include <vector>

#include "wheelrail/overlap_patch.hpp"

namespace rollcon {

/// Returns the point where the gap is least; nullopt where the wheel is beside the rail.
std::optional<GapPoint> least_gap(ProfileGap gap);
/// Finds the overlaps in the order of s; overwrites `overlap`.
void find_overlaps(ProfileGap gap, std::vector<Overlap>& overlap);

}  // namespace rollcon
