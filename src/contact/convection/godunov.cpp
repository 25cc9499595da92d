#include <cmath>

#include "contact/convection/convection.hpp"
#include "contact/convection/rows.hpp"
#include "mesh/dual_cells.hpp"

namespace rollcon {

SparseRows godunov(const Frame& frame, double ex, double ey) {
  const LinearCells cells = split_elements(frame.mesh);
  const DualCells dual = build_dual_cells(cells, frame.x, frame.y);
  RowBuilder rows(frame.nodes());
  for (const DualFace& face : dual.face) {
    // f_k = v . n_k L_k seen from the cell of `from`; v = -e. Inflow there is outflow from `to`.
    const double flux = -(ex * face.nx + ey * face.ny);
    const double across = std::hypot(face.nx, face.ny);
    if (std::abs(flux) <= flow_rounding * across) continue;
    const std::int32_t into = flux < 0 ? face.from : face.to;
    const std::int32_t upwind = flux < 0 ? face.to : face.from;
    const double c = -std::abs(flux) / dual.area[static_cast<std::size_t>(into)];
    rows.add(into, upwind, c);
    rows.add(into, into, -c);
  }
  return rows.finish();
}

Convection make_godunov(const Frame& frame, double /*step*/, bool /*ends_at_edge*/) {
  return at_nodes(frame, godunov(frame, 1, 0));
}

}  // namespace rollcon
