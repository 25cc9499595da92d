#pragma once
/// Writes VTK unstructured-grid files (.vtu, ASCII) for viewers. Numbers have a decimal point in any locale and are
/// read back to the same bits.

#include <cstdint>
#include <span>
#include <string>

#include "mesh/frame.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

/// Holds values at the mesh's nodes, `components` per node, node by node. One of the two pointers is set.
struct PointArray {
  std::string name;
  int components = 1;
  const double* real = nullptr;
  const std::int32_t* integer = nullptr;
};

/// Writes the mesh, its tags (cell data "tag") and the arrays. The file appears complete or not at all: it is written
/// beside its place and renamed. Throws Error(err_io) naming the path and the reason, Error(err_nonfinite) naming the
/// array and the node (in the mesh's index base).
void write_vtu(const std::string& path, const SurfaceMesh& mesh, std::span<const PointArray> arrays);
/// Writes volume elements in this way, whose nodes are those of the surface.
void write_vtu(const std::string& path, const SurfaceMesh& surface, const VolumeElements& volume,
               std::span<const PointArray> arrays);

}  // namespace rollcon
