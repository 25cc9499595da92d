#pragma once
/// Makes lattices on which operators by offset are compared with assembled ones.

#include <cstdint>
#include <utility>
#include <vector>

#include "bodies/halfspace/halfspace_kernel.hpp"
#include "contact/operators/dense_operators.hpp"
#include "support/frames.hpp"

namespace rollcon {

/// Makes nx by ny cells of dx by dy, turned, with nodes and elements renumbered. With holes, a corner cell, one at a
/// side, two that meet in a node and four around one lack, and a node lies loose.
inline Frame lattice_frame(int nx, int ny, double dx, double dy, double angle, bool holes = false) {
  SurfaceMesh mesh = frames::rotate(frames::rectangle(ElementType::quad4, frames::uniform_lines(-1, -1 + nx * dx, nx),
                                                      frames::uniform_lines(0.5, 0.5 + ny * dy, ny)),
                                    angle);
  const auto n = static_cast<std::size_t>(mesh.nodes());
  std::vector<std::int32_t> number(n);
  for (std::size_t k = 0; k < n; ++k)
    number[k] = static_cast<std::int32_t>(k * 7919 % n);  // 7919 is prime, and no divisor of n
  std::vector<Vec3> node(n);
  for (std::size_t k = 0; k < n; ++k) node[static_cast<std::size_t>(number[k])] = mesh.node[k];
  mesh.node = node;
  for (std::int32_t& k : mesh.connectivity) k = number[static_cast<std::size_t>(k)];
  if (holes) {
    mesh.node.push_back({-7, 3, 0});
    const int gone[][2] = {{5, 6}, {5, 5}, {4, 6}, {4, 5}, {2, 3}, {1, 2}, {3, 0}, {0, 0}};
    for (const auto& cell : gone) {  // the last one first
      const auto e = static_cast<std::ptrdiff_t>(cell[1] * nx + cell[0]);
      mesh.connectivity.erase(mesh.connectivity.begin() + 4 * e, mesh.connectivity.begin() + 4 * e + 4);
      mesh.type.pop_back(), mesh.tag.pop_back(), mesh.offset.pop_back();
    }
  }
  return build_frame(std::move(mesh), Axes{});
}

inline Convection convection_of(const Frame& frame, Scheme scheme) {
  return make_convection(frame, scheme, false);
}

inline constexpr HalfspaceConstants alike{0.7, 0.3, 0}, unlike{0.7, 0.3, 0.11}, incompressible{0.7, 0, 0.2};

struct LatticeCase {
  const char* name;
  int nx, ny;
  double dx, dy, angle;
  HalfspaceConstants c;
};

inline constexpr LatticeCase lattice_cases[] = {
    {"square cells", 12, 9, 0.1, 0.1, 0, alike},
    {"unlike bodies", 9, 14, 0.1, 0.2, 0, unlike},
    {"no shear term", 9, 9, 0.2, 0.1, 0, incompressible},
    {"turned", 10, 11, 0.1, 0.15, 0.4, unlike},
    {"turned by half a right angle", 8, 9, 0.1, 0.1, 0.25 * 3.14159265358979323846, unlike},
    {"turned back", 10, 8, 0.1, 0.1, -2.9, alike},
    {"slender cells", 8, 9, 0.5, 0.01, 0.1, unlike}};

}  // namespace rollcon
