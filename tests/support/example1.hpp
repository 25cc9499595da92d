#pragma once
/// Sets up the first example of Rodriguez-Tembleque and Abascal (Int. J. Solids Struct. 47, 2010): two equal rings roll
/// on each other. Units are N, mm, MPa, s.

#include <algorithm>
#include <cmath>
#include <memory>

#include "support/scene.hpp"
#include "support/surface_meshes.hpp"

namespace rollcon::scenes::example1 {

inline constexpr double radius = 50, width = 8, young = 1e4, poisson = 0.3, mu = 0.1;
inline constexpr double load = 1233.85, force_ratio = 0.6271, speed = 0.2 * radius;
inline const closed_forms::Elastic material{.shear = young / (2 * (1 + poisson)), .poisson = poisson};
/// Describes two long cylinders under the load per length of the rings (Hertz), and the creepage that Carter's closed
/// form gives for their force; body 1 is driven by a force along +t1.
inline const double hertz_a =
    std::sqrt(4 * (load / width) * (radius / 2) * 2 * (1 - poisson * poisson) / (std::acos(-1.0) * young));
inline const double hertz_p0 = 2 * (load / width) / (std::acos(-1.0) * hertz_a);
/// The pressure and creepage of these rings, whose sides are free, at mid-plane and at Carter's force come from finite
/// elements, 36 x 12 hex20 in the zone, 148,716 unknowns a ring. Other fine meshes (hex8 36 x 16 and 48 x 12, hex20 32
/// x 8 and 48 x 8) are within 0.1 % of the pressure and 1.6 % of the creepage.
inline constexpr double fine_p0 = 106.45, fine_creepage = -1.505e-3;
/// The arm of the spin moment is the mean semi-axis of a contact as long as the rings are wide.
inline const double arm = std::sqrt(hertz_a * width / 2);
inline const double carter_creepage = -mu * hertz_a / (radius / 2) * (1 - std::sqrt(1 - force_ratio));

/// Returns the paper's ring: 1472 nodes and quadrilaterals, 12 x 12 of them in the zone.
inline surfaces::Ring paper_ring() {
  return {};
}

/// Takes as `parts` the elements along and across the zone; the rest of the ring follows.
inline surfaces::Ring bem_ring(int parts) {
  surfaces::Ring shape = paper_ring();
  shape.zone_around = parts;
  shape.across = parts;
  shape.around = 2 * ((46 * parts / 12) / 2);
  shape.deep = std::max(2, 4 * parts / 12);
  return shape;
}

/// Returns the bound of the elements around a ring for which `rest` elements outside the zone grow steadily: a lower
/// one makes a few of them leap to it.
inline double longest(int rest) {
  return std::max(40.0, 4 * std::acos(-1.0) * radius / rest);
}

/// Returns a ring for finite elements, finer below the zone and coarser elsewhere than bem_ring().
inline surfaces::Ring fem_ring(int parts) {
  surfaces::Ring shape = bem_ring(parts);
  shape.around = 2 * ((28 * parts / 12) / 2);
  shape.deep = std::max(4, 10 * parts / 12);
  shape.top_layer = shape.zone / parts;
  shape.largest = longest(shape.around - shape.zone_around);
  return shape;
}

inline void hold(MeshedBody& body, const surfaces::Ring& shape) {
  body.held_tag = {3};
  if (shape.sector > 0) body.held_tag.insert(body.held_tag.end(), {6, 7});
  body.contact_tag = {1, 2};
}

inline MeshedBody ring_body(const surfaces::Ring& shape, ElementType type) {
  MeshedBody body = meshed(surfaces::ring(shape, type), material);
  hold(body, shape);
  return body;
}

inline MeshedBody ring_body(const surfaces::Ring& shape, VolumeType type) {
  MeshedBody body = meshed(volumes::ring(shape, type), material);
  hold(body, shape);
  return body;
}

/// Stands rings one above the other, the axle of each along y; the second is turned upside down. The frame is the first
/// one's zone.
inline std::unique_ptr<RollingPair> pair(const AnyBody& ring1, const AnyBody& ring2, const char* scheme,
                                         int threads = 1) {
  auto p = std::make_unique<RollingPair>(ring1, ring2, threads);
  p->pose(2, {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, {0, 0, 2 * radius});
  p->axes({0, 0, radius}, {1, 0, 0}, {0, 0, 1}).frame_from_body(1, 2);
  p->friction(mu).load(load).speed(speed);
  p->tangential_force(ROLLCON_LONGITUDINAL, force_ratio * mu * load).option("convection", scheme);
  return p;
}

/// Makes a pair of equal rings of boundary elements.
inline std::unique_ptr<RollingPair> pair(const surfaces::Ring& shape, ElementType type, const char* scheme,
                                         int threads = 1) {
  return pair(ring_body(shape, type), TwinBody{}, scheme, threads);
}

}  // namespace rollcon::scenes::example1
