#pragma once
/// From the surfaces of the bodies to local normals and the undeformed gap of a contact frame.

#include <vector>

#include "bodies/contact_surface.hpp"
#include "contact/scene/known_gap.hpp"
#include "contact/scene/scene.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Body (0 or 1) whose surface gives the normals: the first that has a mesh; -1: none has. Profiles leave a frame flat:
/// half-spaces, which have no other compliance than that of a plane, are what carries them.
int normal_source(const PairOfBodies& pair);

/// Outward normals of body 1 at the frame's nodes, not normalised: of the surface of body 1 if it has a mesh,
/// else minus those of body 2. At nodes that were taken from that body the mean normal of the fan of its faces, else
/// what the line along the axes' normal meets. One body at least must have a mesh. Throws err_mesh naming the frame
/// nodes that do not lie over the body's contact faces, see MissedNodes.
std::vector<Vec3> surface_normals(const Frame& frame, const FrameSource& source, const PairOfBodies& pair);

/// Distance from the surface of body 1 to that of body 2 along the normals of the frame's nodes (the axes' on a flat
/// frame), negative where they overlap; 0 at nodes of no element. The surface of a body that has none of its own is the
/// plane through the axes' origin normal to n. Throws err_mesh likewise.
std::vector<double> undeformed_gap(const Frame& frame, const FrameSource& source, const PairOfBodies& pair);

/// The text about bodies that lie where their partners should.
inline constexpr const char* exchange_bodies =
    "body 1 lies on the side of n, where body 2 should be: exchange the bodies, or turn n, the outward normal of body "
    "1 "
    "(rollcon_contact_set_axes)";

/// Whether a gap is least at the frame's rim and nowhere greater there than inside: it has the wrong sign.
bool is_turned(const std::vector<double>& gap, const std::vector<std::uint8_t>& rim);

/// Frame nodes where the bodies overlap before they approach each other, and the greatest depth.
struct InitialOverlap {
  std::int64_t nodes = 0;
  double depth = 0;
};
InitialOverlap initial_overlap(const Frame& frame, const std::vector<double>& gap);

/// err_argument where bodies overlap by more than one with a mesh is thick (the least side of its bounding box): a pose
/// was forgotten, or lengths have different units.
void refuse_deep_overlap(const Frame& frame, const std::vector<double>& gap, const PairOfBodies& pair);

/// Nodes at which the frame cuts the contact off: those on its boundary, but for nodes on an edge of either body beyond
/// which the body does not go on, or only too steeply for a frame, or at which the gap says so (null: it does not).
void find_rim(Frame& frame, const PairOfBodies& pair, const KnownGap* gap);

}  // namespace rollcon
