#pragma once
/// Finds the Hertzian contact that stands for a patch, from its overlap alone: no pressures are solved for
/// (docs/wheelrail.md, Ellipses from the overlap).

#include "contact/results/equivalent_ellipse.hpp"
#include "wheelrail/overlap_patch.hpp"

namespace rollcon {

/// Holds the semi-axes along x and the lateral axis; there is no load where all of the overlap gives way.
struct HertzianPatch {
  double a = 0, b = 0, load = 0, max_pressure = 0;
};

/// Makes the patch's contact; modulus: E* of both bodies; give_way: part of the overlap that does not press.
HertzianPatch hertzian_patch(const OverlapPatch& patch, double modulus, double give_way);

}  // namespace rollcon
