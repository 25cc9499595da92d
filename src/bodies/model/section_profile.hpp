#pragma once
/// Reads a profile from the boundary of a section.

#include "geometry/profile_curve.hpp"
#include "mesh/swept_section.hpp"

namespace rollcon {

/// Holds the curve through the nodes of a section's contact edges. Of a section revolved about y it has y of the body,
/// and z = r - radius; of one extruded along x it has y and z of the body.
struct SectionProfile {
  ProfileCurve curve;
  double radius = 0;  ///< r where y = 0, or the largest one if the edges have none there; 0: extruded
};

/// Takes a section that was swept. err_argument: it has another axis; err_mesh: the edges are not one line.
SectionProfile profile_of(const SweptSection& section);

}  // namespace rollcon
