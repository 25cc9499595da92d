#pragma once
/// Finds local normals and the undeformed gap of a contact frame from the surfaces of the bodies.

#include <vector>

#include "bodies/contact_surface.hpp"
#include "contact/scene/known_gap.hpp"
#include "contact/scene/scene.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Returns the body (0 or 1) whose surface gives the normals, the first that has a mesh; -1: none has. Profiles leave a
/// frame flat: half-spaces, which have no other compliance than that of a plane, are what carries them.
int normal_source(const PairOfBodies& pair);

/// Finds the outward normals of body 1 at the frame's nodes, not normalised: from its surface if it has a mesh, else
/// from that of body 2, turned over. At nodes taken from that body it is the mean normal of the fan of its faces, else
/// the normal where the line along the axes' normal meets it. One body at least must have a mesh. Throws err_mesh
/// naming the frame nodes that do not lie over the body's contact faces, see MissedNodes.
std::vector<Vec3> surface_normals(const Frame& frame, const FrameSource& source, const PairOfBodies& pair);

/// Finds the distance from the surface of body 1 to that of body 2 along the normals of the frame's nodes (the axes' on
/// a flat frame), negative where they overlap; 0 at nodes of no element. A body without a surface of its own has the
/// plane through the axes' origin normal to n. Throws err_mesh where surface_normals() does.
std::vector<double> undeformed_gap(const Frame& frame, const FrameSource& source, const PairOfBodies& pair);

/// Tells that bodies lie where their partners should.
inline constexpr const char* exchange_bodies =
    "body 1 lies on the side of n, where body 2 should be: exchange the bodies, or turn n, the outward normal of body "
    "1 "
    "(rollcon_contact_set_axes)";

/// Says whether a gap is least at the frame's rim and nowhere greater there than inside, so that its sign is wrong.
bool is_turned(const std::vector<double>& gap, const std::vector<std::uint8_t>& rim);

/// Counts frame nodes where the bodies overlap before they approach each other, with the greatest depth.
struct InitialOverlap {
  std::int64_t nodes = 0;
  double depth = 0;
};
InitialOverlap initial_overlap(const Frame& frame, const std::vector<double>& gap);

/// Throws err_argument where bodies overlap by more than one with a mesh is thick (the least side of its bounding box):
/// a pose was forgotten, or lengths have different units.
void refuse_deep_overlap(const Frame& frame, const std::vector<double>& gap, const PairOfBodies& pair);

/// Finds the nodes at which the frame cuts the contact off: those on its boundary, but for nodes on an edge of a body
/// that ends there or goes on too steeply for a frame, or at which the gap says so (null: it does not).
void find_rim(Frame& frame, const PairOfBodies& pair, const KnownGap* gap);

}  // namespace rollcon
