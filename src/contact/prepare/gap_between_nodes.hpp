#pragma once
/// Integrates the deformed gap between the nodes of the frame, where nothing keeps it closed.

#include <vector>

namespace rollcon {

struct Solution;

/// Returns the integral of the gap over the contact and its edge times `rate`, nodal values of the pressure that an
/// approach adds: the force that the discrete solution lacks to close the gap everywhere. The undeformed gap is taken
/// to be smooth between the nodes; displacements are exact there.
double gap_force(const Solution& solution, const std::vector<double>& rate);

}  // namespace rollcon
