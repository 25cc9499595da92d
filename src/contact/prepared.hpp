#pragma once
/// What a solve stands on.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bodies/pair.hpp"
#include "contact/heat/flash_temperature.hpp"
#include "contact/problem/problem.hpp"
#include "contact/scene/enumerators.hpp"
#include "contact/scene/scene.hpp"
#include "mesh/lattice.hpp"

namespace rollcon {

/// Made from the scene by prepare(), not changed by a solve, shared by the cases of a list.
struct Prepared {
  Frame frame;
  FrameSource frame_source;  ///< as far as the body still has these faces
  bool placed = false;       ///< a frame at a place of its own, which solves may change
  bool in_steps = false;     ///< the shapes of a placed frame are a few that come again
  FramePlace place;
  bool ends_at_edge = false;               ///< the contact covers the frame, nodes on its rim carry nothing
  PairOfBodies pair;                       ///< where the bodies stood
  std::shared_ptr<Compliance> compliance;  ///< of the pair
  std::array<MeshOnFrame, 2> meshes;
  double bears = INFINITY;  ///< length, thickness or radius, of which an approach makes sense up to the half
  double accuracy = 0;
  Scheme scheme = Scheme::characteristic;
  /// From displacements of the bodies without any contact traction; empty: none.
  std::vector<double> offset_depth, offset_slip[2];
  /// The frame as a regular grid; nothing: see no_lattice.
  std::optional<Lattice> lattice;
  std::string no_lattice;     ///< why there is none: a clause
  bool table = false;         ///< dense rows are copied from a table of one node's influence
  bool frictionless = false;  ///< mu is 0 at every node
  Problem problem;
  double speed = 1;     ///< slip velocity per unit of slip: V, or 1 / dt in a time step
  double distance = 0;  ///< that material travels in a time step
  StepKind step = StepKind::steady;
  BothHeats heat;
};

}  // namespace rollcon
