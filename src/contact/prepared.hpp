#pragma once
/// Holds what a solve stands on.

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

/// Holds what prepare() makes of the scene; no solve changes it, and the cases of a list use it together.
struct Prepared {
  Frame frame;
  FrameSource frame_source;  ///< faces of a body, as far as it still has them
  bool placed = false;       ///< frame at a place of its own, which solves may change
  FramePlace place;
  bool ends_at_edge = false;               ///< contact covers the frame; nodes on its rim carry nothing
  PairOfBodies pair;                       ///< bodies where they stood
  std::shared_ptr<Compliance> compliance;  ///< compliance of the pair
  std::array<MeshOnFrame, 2> meshes;
  double bears = INFINITY;  ///< length, thickness or radius; approaches make sense up to half of it
  double accuracy = 0;
  Scheme scheme = Scheme::characteristic;
  /// Displacements of the bodies without any contact traction; empty: none.
  std::vector<double> offset_depth, offset_slip[2];
  /// Regular grid of the frame's nodes; nothing: see no_lattice.
  std::optional<Lattice> lattice;
  std::string no_lattice;     ///< clause that says why there is no lattice
  bool table = false;         ///< dense rows are copied from a table of one node's influence
  bool frictionless = false;  ///< mu is 0 at every node
  Problem problem;
  double speed = 1;     ///< slip velocity per unit of slip: V, or 1 / dt in a time step
  double distance = 0;  ///< way that material travels in a time step
  StepKind step = StepKind::steady;
  BothHeats heat;
};

}  // namespace rollcon
