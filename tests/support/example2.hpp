#pragma once
/// Sets up the second example of Rodriguez-Tembleque and Abascal (Int. J. Solids Struct. 47, 2010): a ring of finite
/// elements rolls on an elastic half-space a hundred times as stiff. N, mm, MPa, s.

#include <memory>

#include "support/scene.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::scenes::example2 {

inline constexpr double radius = 50, width = 8, poisson = 0.3, mu = 0.1;
inline constexpr double load = 1345, force_ratio = 0.5373, speed = 0.2 * radius;
inline const closed_forms::Elastic ring{.shear = 1e4 / (2 * (1 + poisson)), .poisson = poisson};
inline const closed_forms::Elastic ground{.shear = 1e6 / (2 * (1 + poisson)), .poisson = poisson};

/// Describes a long cylinder on a half-space under the ring's load per length.
inline const closed_forms::HertzLine hertz =
    closed_forms::hertz_line_from_load(radius, closed_forms::effective_modulus(ring, ground), load / width);
/// The arm of the spin moment is the mean semi-axis of a contact as long as the ring is wide.
inline const double arm = std::sqrt(hertz.a * width / 2);
/// Carter's creepage at the ring's force is that of equal bodies; body 1 is driven along +t1.
inline const double carter_creepage = -mu * hertz.a / radius * (1 - std::sqrt(1 - force_ratio));
/// Returns the creepage of long cylinders of these two materials, by half-spaces.
double plane_creepage();

/// Takes as `parts` the elements along and across the zone. With 12 it has the paper's counts: 2016 hexahedra (28
/// around, 12 across, 6 deep), 12 x 12 of their faces in the zone. The paper does not give the zone's length; the
/// greatest gaps of both examples tell of 3 mm.
surfaces::Ring ring_of(int parts = 12);
/// Makes a block in place of the half-space: its top has the paper's 288 quadrilaterals (16 x 18), 12 x 12 of them in
/// the zone; it is 80 mm wide and 40 mm deep, held at its bottom.
SurfaceMesh ground_block(ElementType type);

enum class Ground { half_space, block };
MeshedBody ring_body(const surfaces::Ring& shape, VolumeType type);
/// Gives the force, but not the convection scheme.
std::unique_ptr<RollingPair> pair(const surfaces::Ring& shape, VolumeType type, Ground on, int threads = 1);

}  // namespace rollcon::scenes::example2
