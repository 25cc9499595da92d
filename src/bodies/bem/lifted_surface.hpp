#pragma once
/// The surface that the equations are written on. A linear element cannot bend: its sides stay straight, and a body
/// that is thin beside it is too stiff (or leaks force) by the square of length over thickness. So its displacements
/// are made quadratic without a new unknown: the element gets midside nodes, each a fixed sum of the nodes around it,
/// found so that quadratic fields on flat faces come out exactly. Midside nodes are placed by the same sums as they are
/// displaced: then rigid motions and uniform strains stay exact on curved faces as well.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bodies/model/body_mesh.hpp"

namespace rollcon::bem {

/// What one value (of a node or of a column) has of another.
struct Part {
  std::int32_t of = 0;
  double value = 0;
};

struct LiftedSurface {
  /// The body's elements, linear ones as tri6 and quad8; the body's nodes, then the midside nodes.
  SurfaceMesh mesh;
  std::int64_t nodes = 0;              ///< the body's own
  std::vector<std::int64_t> start{0};  ///< midside nodes + 1, into part
  std::vector<Part> part;              ///< body's nodes
  std::span<const Part> parts_of(std::int32_t midside) const {
    const std::int64_t* from = start.data() + (midside - nodes);
    return {part.data() + from[0], part.data() + from[1]};
  }
};

/// edge_angle, degrees: beyond it a midside node takes nothing from across an edge. Held faces are parts of their own,
/// so that what is held stays held.
LiftedSurface lift(const BodyMesh& mesh, double edge_angle);

/// Columns for tractions that stay linear along the elements.
struct LiftedColumns {
  std::vector<std::int32_t> of;                  ///< by entry of the lifted connectivity, -1: none
  std::vector<std::array<std::int32_t, 2>> end;  ///< of each midside column, -1: none
  std::int64_t own = 0;                          ///< columns asked for; midside columns follow
  std::int64_t size() const { return own + static_cast<std::int64_t>(end.size()); }
};
/// column: by entry of the body's own connectivity, which `surface` has.
LiftedColumns lift_columns(const SurfaceMesh& surface, const LiftedSurface& lifted,
                           const std::vector<std::int32_t>& column, std::int64_t columns);

/// Columns on a mesh of its own, which is not lifted.
inline LiftedColumns columns_of_layer(const SurfaceMesh& layer) {
  return {layer.connectivity, {}, layer.nodes()};
}

/// Adds the midside nodes' shares to the body's nodes: rows of `integrals` (their h and g).
void fold_displacements(const LiftedSurface& lifted, double* h);
void fold_tractions(const LiftedColumns& columns, double* g);

}  // namespace rollcon::bem
