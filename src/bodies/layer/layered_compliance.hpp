#pragma once
/// Adds a thin elastic layer between two bodies: at each point it gives way along the surface in proportion to the
/// traction there, in series with the bodies.

#include <memory>

#include "bodies/model/compliance.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Puts a layer on the compliance of bodies. flexibility: tangential displacement per traction, thickness over shear
/// modulus. Tractions between nodes are those of linear triangles. The frame must outlive it.
std::unique_ptr<Compliance> make_layered(const Frame& frame, std::unique_ptr<Compliance> bodies, double flexibility);

}  // namespace rollcon
