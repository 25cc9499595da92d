#pragma once
/// Tells how deep an overlap is along the normal of a contact.

#include "wheelrail/overlap_patch.hpp"

namespace rollcon {

/// Returns the greatest distance from the rail to the wheel's outline along the normal of this angle. Where it is
/// deepest along z it is less by about depth^2 tan^2(angle) / (2 radius), with the relative radius of both.
double greatest_depth_along(const ProfileGap& gap, const Overlap& overlap, double angle);

}  // namespace rollcon
