#pragma once
/// Finds the forces of linear theory: all of a contact on strips sticks, whatever its friction.

#include "framing/strips/strip_bridge.hpp"
#include "framing/strips/strip_contact.hpp"

namespace rollcon::strips {

/// Holds Fx, Fy and the moment about the origin, for each longitudinal creepage, lateral creepage, spin and the slip
/// that a scene adds.
struct Adhesion {
  std::array<std::array<double, 3>, 4> force{};
};

/// Finds derivatives of a solution's forces by all of these. Returns false where its equations are singular.
bool creep_rates(StripContact& contact, const StripScene& scene, const StripSolution& solution, Adhesion& found);

/// Finds the forces for the pressures of a solution. Returns false where its equations are singular.
bool adhere(StripContact& contact, StripScene scene, const StripSolution& solution, Adhesion& found);

/// Finds the forces of a Hertzian contact with these semi-axes along and across, on strips that are found as any
/// others: they have the errors of the strips of a patch. Returns its largest pressure; 0 where no strips are found.
double adhere_on_ellipse(StripContact& contact, const StripBodies& bodies, double along, double across,
                         StripCounts counts, StripSolution& solution, Adhesion& found);

}  // namespace rollcon::strips
