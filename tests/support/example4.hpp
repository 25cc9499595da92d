#pragma once
/// Sets up the fourth example of Rodriguez-Tembleque and Abascal (Int. J. Solids Struct. 47, 2010): a wheel on a rigid
/// rail head. N, mm, MPa, s. The paper does not give the profiles; those here are stated in docs/examples.md.

#include <memory>

#include "support/scene.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::scenes::example4 {

inline constexpr double radius = 355.6, rail = 203.2, young = 1e4, poisson = 0.3, mu = 0.1;
inline constexpr double cone = 0.05, depth = 0.015, force_ratio = 0.57, speed = 0.1 * radius;
inline const closed_forms::Elastic material{.shear = young / (2 * (1 + poisson)), .poisson = poisson};

/// Puts a 28-inch wheel with a conical tread on a rigid rail head, a cylinder along the rolling direction crowned with
/// a radius of 8 inches. The approach is given, the tangential force is not.
std::unique_ptr<RollingPair> pair(ElementType type, const char* scheme, int threads = 1);
/// Uses another mesh of the wheel, or of a part of it around its top.
std::unique_ptr<RollingPair> pair(const MeshedBody& wheel, const char* scheme, int threads = 1);

/// Makes a part of the wheel around its top from a block with its zone, held except for the tread.
MeshedBody part_of_wheel(const surfaces::ZoneBlock& block);

}  // namespace rollcon::scenes::example4
