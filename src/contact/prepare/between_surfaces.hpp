#pragma once
/// Finds where the velocities of both bodies are compared: between their undeformed surfaces.

#include <array>

namespace rollcon {

struct Preparation;

/// Returns the weights of both bodies' heights where velocities are compared, from their curvatures towards each other
/// along the rolling direction, over which the contact is `half` long to either side.
std::array<double, 2> weights_between(double curvature1, double curvature2, double half);

/// Finds origin_between and point_between. The points divide the distance of the surfaces by their curvatures along the
/// rolling direction: on the wheel where the rail is straight, in the middle between equal discs (docs/theory.md,
/// section 1). Where one body is absent they lie on the other.
void find_points_between(Preparation& preparation);

}  // namespace rollcon
