#pragma once
/// Says how finely patches are solved, by the options of a wheel.

#include "wheelrail/patch_contact.hpp"
#include "wheelrail/wheel_options.hpp"

namespace rollcon {

/// Returns the counts of strips and lattices for a patch; on_lattices: on no strips.
Fineness fineness_for(const WheelOptions& options, bool on_lattices, const OverlapPatch& patch);

}  // namespace rollcon
