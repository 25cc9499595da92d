#pragma once
/// Gives what a contact does to a body as forces on the body's own nodes.

#include <span>
#include <vector>

#include "bodies/contact_surface.hpp"
#include "bodies/model/surface_response.hpp"

namespace rollcon {

struct NodalLoads {
  std::vector<Vec3> force;  ///< force on each node of the body, in its axes
  Resultant sum;            ///< their force and moment about the origin of these axes
  double moved = 0;         ///< largest change, beside the largest force, that gave them this resultant
};

/// Returns the consistent nodal forces of tractions t[3 * node + c] on a frame, in its local directions, that act on
/// body 1 (which = 0) or against body 2. A frame and curved faces under it are not one surface: forces that grow
/// linearly over the loaded nodes give them the contact's own force and moment (about the axes' origin, in the axes).
/// err_unsupported: the body has no mesh; else as lay_on_body.
NodalLoads nodal_loads(const Frame& frame, const PairOfBodies& pair, int which, std::span<const double> traction,
                       const Resultant& contact);

}  // namespace rollcon
