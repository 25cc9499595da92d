#pragma once
/// Numbers the unknown displacements and tractions of a boundary-element body, and says where its equations are
/// written.
///
/// A free displacement component is unknown, and so is the traction component of every fan of a held face (all nodes of
/// one of the fan's elements held in that component). A held component with one such fan takes the equation of its
/// node. Where several held faces meet there are more unknown tractions than a node has equations: each fan then gets
/// an equation at a point inside one of its own elements, so that the matrix is regular at clamped-clamped edges and
/// corners.

#include <cstdint>
#include <map>
#include <vector>

#include "bodies/bem/boundary_integrals.hpp"
#include "bodies/model/body_mesh.hpp"
#include "mesh/traction_nodes.hpp"

namespace rollcon::bem {

/// Describes a node held alone, without a held face: its reaction is spread over its first fan like a linear shape
/// function. (The shape function of a quadratic element's corner has no mean, or a negative one.)
struct SpreadReaction {
  std::int32_t fan = 0;  ///< first fan of the node, whose traction is the unknown
  int component = 0;
  std::map<std::int32_t, double> others;  ///< parts of the value that fans of other nodes get
};

struct Unknowns {
  /// Column of (node, component), -1: held. Columns that contact may ask for come last.
  std::vector<std::int32_t> displacement;
  std::vector<std::int32_t> traction;  ///< column of (traction node, component), -1: known
  std::vector<SpreadReaction> spread;
  std::int64_t columns = 0;

  std::vector<CollocationPoint> point;  ///< points, in an order that keeps neighbours in space together
  std::vector<std::int32_t> row;        ///< row of (point, component), -1: not an equation
  std::vector<std::int32_t> fan;        ///< traction node that an element's inner point belongs to; -1: a node's point
  /// Returns, for each row, the unknown that belongs to the place at which the row's equation is written.
  std::vector<std::int32_t> column_of_rows(const TractionNodes& fans) const;
};

Unknowns choose_unknowns(const BodyMesh& mesh, const TractionNodes& fans);

}  // namespace rollcon::bem
