#pragma once
/// Implements the discrete schemes of docs/theory.md, section 5, and the integrals of a frame once more, written from
/// their description for the tests alone.

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace rollcon::laws {

enum class Scheme { characteristic, least_squares, godunov };

/// Is an entry of node I: c (w_J - w_I), summed over the entries, is v . grad w for unit speed along -x.
struct Difference {
  std::int32_t node;
  double c;
};
using Rows = std::vector<std::vector<Difference>>;

/// Holds positions in the axes, rolling along +x.
struct Plane {
  std::vector<double> x, y;
};

/// Returns straight triangles and quadrilaterals on the frame's nodes: elements, or parts of quadratic ones.
std::vector<std::vector<std::int32_t>> linear_cells(const SurfaceMesh& mesh);

Rows godunov_rows(const SurfaceMesh& mesh, const Plane& at);
Rows least_squares_rows(const SurfaceMesh& mesh, const Plane& at);

/// Returns steps upstream of the characteristic scheme: a fraction of the distance of neighbours along the flow, or
/// past the place where the node's traction acts if that is further (theory.md, section 5). With `regular`, a full grid
/// of equal cells, nodes on the rim have the step of the others.
std::vector<double> steps(const SurfaceMesh& mesh, const Plane& at, double part_of_spacing, bool regular);

/// Integrates every shape function N over the flat frame, N x and N y.
std::vector<std::array<double, 3>> shape_integrals(const SurfaceMesh& mesh, const Plane& at);

}  // namespace rollcon::laws
