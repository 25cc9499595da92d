#pragma once
/// Lattices on which operators by offset are compared with assembled ones.

#include <cstdint>
#include <utility>
#include <vector>

#include "bodies/halfspace/halfspace.hpp"
#include "contact/operators.hpp"
#include "support/frames.hpp"

namespace rollcon {

/// nx by ny cells of dx by dy, turned, with nodes and elements renumbered.
inline Frame lattice_frame(int nx, int ny, double dx, double dy, double angle) {
  SurfaceMesh mesh = frames::rotate(
      frames::rectangle(ElementType::quad4, frames::uniform_lines(-1, -1 + nx * dx, nx),
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
  return build_frame(std::move(mesh), Axes{});
}

inline ContactOperators convection_of(const Frame& frame, Scheme scheme) {
  ContactOperators op;
  prepare_convection(frame, scheme, 0.6, op);
  return op;
}

inline constexpr HalfspaceConstants alike{0.7, 0.3, 0}, unlike{0.7, 0.3, 0.11},
    incompressible{0.7, 0, 0.2};

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
