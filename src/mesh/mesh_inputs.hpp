#pragma once
/// Turns a caller's arrays into a SurfaceMesh: pointers, strides, ids and numbers are checked here, shapes of elements
/// later, once the mesh is complete.

#include <cstdint>

#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

/// Makes a mesh with these nodes and no elements. Component j of node i is x[i * node_stride + j * component_stride];
/// messages count nodes from index_base.
SurfaceMesh mesh_of_nodes(std::int64_t n, const double* x, std::int64_t node_stride, std::int64_t component_stride,
                          std::int32_t index_base);

/// Adds n elements and takes over their index_base; n = 0 only checks. Throws Error and then leaves the mesh unchanged.
/// Messages use `owner` ("frame", "body") and the name of the function that sets its nodes.
void append_elements(SurfaceMesh& mesh, std::int32_t type, std::int64_t n, const std::int32_t* connectivity,
                     std::int32_t index_base, std::int32_t tag, const char* owner, const char* node_setter);
/// Adds elements to the inside of a body with `nodes` nodes; type must be one of VolumeType.
void append_elements(VolumeElements& volume, std::int64_t nodes, std::int32_t type, std::int64_t n,
                     const std::int32_t* connectivity, std::int32_t index_base, std::int32_t tag,
                     const char* node_setter);

}  // namespace rollcon
