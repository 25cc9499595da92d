#pragma once
/// Defines a solution: what a solve found, and what it was found for.

#include <cstdint>
#include <memory>
#include <vector>

#include "contact/newton/report.hpp"
#include "contact/prepared.hpp"
#include "contact/problem/settled_friction.hpp"
#include "contact/scene/procedure.hpp"
#include "support/line.hpp"

namespace rollcon {

/// Holds one solve's result as a value: to go back to it takes no more than a copy.
struct Solution {
  std::shared_ptr<const Prepared> prepared;  ///< null: nothing was prepared yet
  Prescribed given;
  bool frictionless = false;  ///< mu is 0 at every node, or the factor on it is
  double load_factor = 1;     ///< factor on the tangential loads of the scene
  Procedure procedure;

  bool solved = false;
  bool warm_usable = false;                 ///< the next solve may start from it
  std::int64_t number = 0;                  ///< number that no other solution in this process has
  Revisions revision;                       ///< revisions of the scene that the solve read
  std::int64_t options = -1;                ///< revision of the scene's options
  Iterate iterate;                          ///< tractions and motions
  bool images_known = false;                ///< images of the iterate are known at all nodes, slip included
  NewtonReport report;                      ///< how it was found
  SettledFriction settled;                  ///< friction that follows the whole solution
  mutable std::vector<std::uint8_t> marks;  ///< storage of nodes_inside()
};

/// Throws err_load if a frictionless problem prescribes what only friction can carry.
void refuse_tangential_loads(const Prescribed& given);
/// Throws err_load if a normal load and moments act beside the nodes of a flat frame.
void refuse_load_beside_frame(const Solution& solution);
/// Throws err_argument, with the node, where the gaps and motions of the prepared scene go beyond what double precision
/// can calculate with.
void refuse_overflow(const Solution& solution);

/// Returns what a finished solve is worth; throws err_load where there is no steady solution.
Status status_of(const Solution& solution);
/// Counts the nodes in contact on the rim of the frame.
std::int64_t nodes_at_rim(const Solution& solution);

}  // namespace rollcon
