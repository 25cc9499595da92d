#pragma once
/// Makes the surface that the equations are written on. A linear element cannot bend: its sides stay straight, and a
/// body that is thin beside it is too stiff (or leaks force) by the square of length over thickness. So displacements
/// are made quadratic without a new unknown: the element gets midside nodes, each a fixed sum of the nodes around it,
/// found so that quadratic fields on flat faces come out exactly. Midside nodes are placed by the same sums as they are
/// displaced: then rigid motions and uniform strains stay exact on curved faces as well.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bodies/model/body_mesh.hpp"

namespace rollcon::bem {

/// Says how much of another value a node or a column takes.
struct Part {
  std::int32_t of = 0;
  double value = 0;
};

struct LiftedSurface {
  /// Elements of the body, linear ones as tri6 and quad8; nodes of the body, then midside nodes.
  SurfaceMesh mesh;
  std::int64_t nodes = 0;              ///< count of the body's own nodes
  std::vector<std::int64_t> start{0};  ///< first entry in `part` of each midside node, and the end
  std::vector<Part> part;              ///< parts that midside nodes take of the body's nodes
  std::span<const Part> parts_of(std::int32_t midside) const {
    const std::int64_t* from = start.data() + (midside - nodes);
    return {part.data() + from[0], part.data() + from[1]};
  }
};

/// Lifts the surface of a mesh. Across edges sharper than edge_angle (degrees) a midside node takes nothing. Held faces
/// are lifted by themselves, so that what is held stays held.
LiftedSurface lift(const BodyMesh& mesh, double edge_angle);

/// Holds columns for tractions that stay linear along the elements.
struct LiftedColumns {
  std::vector<std::int32_t> of;                  ///< column by entry of the lifted connectivity, -1: none
  std::vector<std::array<std::int32_t, 2>> end;  ///< both ends' columns of each midside column, -1: none
  std::int64_t own = 0;                          ///< columns asked for; midside columns follow
  std::int64_t size() const { return own + static_cast<std::int64_t>(end.size()); }
};
/// Lifts columns given by entry of the body's own connectivity, which `surface` has.
LiftedColumns lift_columns(const SurfaceMesh& surface, const LiftedSurface& lifted,
                           const std::vector<std::int32_t>& column, std::int64_t columns);

/// Returns columns on a frame's own mesh, which is not lifted.
inline LiftedColumns columns_of_layer(const SurfaceMesh& layer) {
  return {layer.connectivity, {}, layer.nodes()};
}

// Both add what midside nodes or columns have in rows h or g of integrals to the body's own.
void fold_displacements(const LiftedSurface& lifted, double* h);
void fold_tractions(const LiftedColumns& columns, double* g);

}  // namespace rollcon::bem
