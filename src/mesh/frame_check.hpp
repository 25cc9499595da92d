#pragma once
/// What a contact frame must satisfy; every failure is Error(err_mesh) with the first offender, in the caller's index
/// base, and the number of offenders.

#include <span>

#include "mesh/topology.hpp"

namespace rollcon {

/// Nodes in range, no node twice in an element, no element twice. Before anything is computed.
void check_connectivity(const SurfaceMesh& mesh);

/// Elements: no coinciding nodes, Jacobian of the projection positive, normals within 60 degrees of n. x, y, z: nodal
/// coordinates in the axes.
void check_elements(const SurfaceMesh& mesh, std::span<const double> x, std::span<const double> y,
                    std::span<const double> z);

/// Linear cells convex; edges shared by at most two cells, on opposite sides, with the same midside node; no cell lies
/// over another.
void check_cells(const SurfaceMesh& mesh, const LinearCells& cells, std::span<const Side> side,
                 std::span<const double> x, std::span<const double> y);

}  // namespace rollcon
