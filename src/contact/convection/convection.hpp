#pragma once
/// Provides the discrete convective derivative on the contact frame (docs/theory.md, section 5): rows of the operator D
/// with (D w)_I ~ v . grad w at node I for unit speed, v = -(ex, ey).

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

struct SparseRows {
  std::vector<std::int64_t> start;  ///< rows + 1
  std::vector<std::int32_t> column;
  std::vector<double> value;
  std::vector<std::uint8_t> fallback;  ///< 1 where the scheme's own stencil was not usable
};

/// Holds a scheme as the operators take it: slip per unit speed, D w, is a sum of displacements at samples, which are
/// the nodes and, for some schemes, one point ahead (upstream) of each.
struct Convection {
  SparseRows rows;  ///< by node; column n + j: the sample ahead of node j of n
  /// Factor on each row's sum: samples that lie close are subtracted before, lest digits are lost.
  std::vector<double> factor;
  std::vector<double> ahead;           ///< distances along t1, in the projection; empty: no such samples
  std::vector<double> slip_x, slip_y;  ///< where the rigid slip of each row is taken
};

/// Makes a scheme's convection. step: characteristic_step or another; ends_at_edge: the frame ends where the contact
/// does, so that the characteristic scheme takes slip at the nodes (take_slip_at_nodes).
using MakeConvection = Convection(const Frame& frame, double step, bool ends_at_edge);

/// Describes a row of the table in scheme.cpp, made in a file of its own. Rolling is along t1 of the frame.
struct Scheme {
  const char* name = nullptr;  ///< value of the option `convection`
  MakeConvection* make = nullptr;
  bool operator==(const Scheme&) const = default;
  /// time_step: slip is a shift, displacements count as they are; the option does not offer it.
  static const Scheme characteristic, time_step;
};

/// Returns "a|b|c", the standard one first.
const std::string& scheme_names();
/// Returns the scheme with one of these names.
const Scheme& scheme_of(const std::string& name);

/// Usual distance ahead of the characteristic scheme, over the local spacing along the flow.
inline constexpr double characteristic_step = 0.6;

/// Makes a scheme, along the surface of a curved frame: as in the projection, times t1 . (rolling direction).
Convection make_convection(const Frame& frame, const Scheme& scheme, bool ends_at_edge,
                           double step = characteristic_step);
/// Takes the steps and places of strips for a characteristic scheme on them.
void convect_on_strips(const Frame& frame, Convection& convection);
/// Makes a sum for each node, with nothing ahead and slip taken at the nodes.
Convection at_nodes(const Frame& frame, SparseRows rows);

/// Computes tangential D w from displacements w[3 * k + c] at the nodes and `ahead` at the samples ahead of them.
void convect(const Convection& convection, const double* w, const double* ahead, std::vector<double> (&slip)[2]);

/// Makes rows of the first-order Godunov flux on median-dual cells, equations (41)-(42). (ex, ey): unit rolling
/// direction in the frame's axes. The row of a node without inflow is empty.
SparseRows godunov(const Frame& frame, double ex, double ey);

/// Makes rows of the upwind least-squares gradient, equations (43)-(45), over neighbours along edges of the linear
/// cells, exact for linear fields at every node whose path upstream enters the frame. Where the fit over upwind
/// neighbours would let errors grow along the path, two neighbours that enclose the path are interpolated instead
/// (upwind ones out of two rings first); where the path leaves the frame, the fit may widen to two rings, and Godunov's
/// row is the last choice. The row of a node without upwind neighbour is empty.
SparseRows least_squares(const Frame& frame, double ex, double ey);

/// Returns the characteristic scheme's distance from each node to its upstream point, in the projection. part: that of
/// the node spacing along the flow (t1); nodes whose own traction acts upstream of them get more.
std::vector<double> characteristic_steps(const Frame& frame, double part);

/// Carries slip, which differences of the characteristic scheme give half a step upstream of the node whose traction it
/// turns (errors of first order where the direction of slip changes, as under spin), to the node by the next node's
/// upstream on the same line: s + part (s - s of the next one). Both vanish where both nodes stick, so that stick is
/// what it was. The next node has to be in contact, for without it there is any slip: rows of nodes near the upstream
/// end of their line stay, as do those without a next node.
void take_slip_at_nodes(const Frame& frame, Convection& convection);

}  // namespace rollcon
