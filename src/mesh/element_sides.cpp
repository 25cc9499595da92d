#include "mesh/element_sides.hpp"

#include <algorithm>

namespace rollcon {

LinearCells corner_cells(const SurfaceMesh& mesh) {
  LinearCells cells;
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto n = mesh.element(e);
    if (corner_count(mesh.type[static_cast<std::size_t>(e)]) == 3)
      cells.add(e, {n[0], n[1], n[2]});
    else
      cells.add(e, {n[0], n[1], n[2], n[3]});
  }
  return cells;
}

int side_number(const SurfaceMesh& mesh, const Side& side) {
  const auto nodes = mesh.element(side.cell);
  return static_cast<int>(std::find(nodes.begin(), nodes.end(), side.from) - nodes.begin());
}

std::int32_t midside_node(const SurfaceMesh& mesh, const Side& side) {
  const ElementType type = mesh.type[static_cast<std::size_t>(side.cell)];
  if (!is_quadratic(type)) return -1;
  return mesh.element(side.cell)[static_cast<std::size_t>(corner_count(type) + side_number(mesh, side))];
}

ReferencePoint side_middle(ElementType type, int number) {
  const auto at = reference_nodes(type);
  const auto i = static_cast<std::size_t>(number);
  const auto j = static_cast<std::size_t>((number + 1) % corner_count(type));
  return {0.5 * (at[i].xi + at[j].xi), 0.5 * (at[i].eta + at[j].eta)};
}

}  // namespace rollcon
