#pragma once
/// Checks what a contact frame must satisfy; every failure is Error(err_mesh) with the first offender, in the caller's
/// index base, and the number of offenders.

#include <span>

#include "mesh/topology.hpp"

namespace rollcon {

/// Checks that nodes are in range, no node comes twice in an element, and no element twice. It runs before anything is
/// computed.
void check_connectivity(const SurfaceMesh& mesh);

/// Checks the elements: no coinciding nodes, Jacobian of the projection positive, normals within 60 degrees of n. The
/// nodal coordinates x, y, z are in the axes.
void check_elements(const SurfaceMesh& mesh, std::span<const double> x, std::span<const double> y,
                    std::span<const double> z);

/// Checks that linear cells are convex, that edges belong to at most two cells, on opposite sides, with one midside
/// node, and that no cell lies over another.
void check_cells(const SurfaceMesh& mesh, const LinearCells& cells, std::span<const Side> side,
                 std::span<const double> x, std::span<const double> y);

}  // namespace rollcon
