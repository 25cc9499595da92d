#pragma once
/// Integrates first moments of the shape functions over the frame.

#include <vector>

#include "mesh/frame.hpp"

namespace rollcon {

/// Finds mx[k], my[k] = integrals of N_k x, N_k y over the projected frame: moments of interpolated tractions about the
/// axes' origin, exact for straight-sided elements. On a curved frame the integrals run over the surface itself. mz[k]
/// = integral of N_k z; 0 where a flat frame's nodes lie in the plane of the axes, up to rounding.
void moment_weights(const Frame& frame, std::vector<double>& mx, std::vector<double>& my, std::vector<double>& mz);

}  // namespace rollcon
