#pragma once
/// Finds the largest value of a measure of stress inside a half-space under a contact, and where it is.

#include <cstdint>
#include <span>

#include "contact/results/stresses.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace rollcon {

/// Searches body 1 or 2 for the largest von_mises, shear or orthogonal_shear; over the histories of particles that pass
/// through the contact along t1, for the largest dang_van (parameter: weight of the hydrostatic stress) or crossland
/// (likewise), or integrates lundberg_palmgren (exponents of stress and depth, least depth) over y and depth. place: in
/// the axes. Throws err_option for an unknown measure, err_argument for wrong parameters, err_state without contact.
double largest_stress(const Solution& s, std::int32_t body, StressesInside& inside, const char* measure,
                      std::span<const double> parameter, Vec3& place);

/// Is a block of hexahedra under the contact, in the axes: three times as long and wide, as deep as the contact is
/// wide, with smaller elements near the surface.
struct BlockInside {
  BlockInside(const Solution& s, std::int32_t body);
  SurfaceMesh surface;  ///< nodes alone
  VolumeElements volume;
};

}  // namespace rollcon
