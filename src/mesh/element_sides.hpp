#pragma once
/// Gives the sides of whole elements (topology.hpp speaks of linear cells), from corner to corner with the midside node
/// of quadratic elements.

#include "mesh/shape.hpp"
#include "mesh/topology.hpp"

namespace rollcon {

/// Makes one cell per element, of its corners; sorted_sides() of them are the elements' sides.
LinearCells corner_cells(const SurfaceMesh& mesh);

/// Returns which side of its element it is (0: from the first corner to the second); side.cell is the element.
int side_number(const SurfaceMesh& mesh, const Side& side);

/// Returns the side's midside node, -1 on linear elements.
std::int32_t midside_node(const SurfaceMesh& mesh, const Side& side);

/// Returns the reference coordinates of the middle of a side.
ReferencePoint side_middle(ElementType type, int number);

}  // namespace rollcon
