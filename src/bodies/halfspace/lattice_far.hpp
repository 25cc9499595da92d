#pragma once
/// Declares the inner loop of the lattice integrals away from their source, one function per instruction set.

#include <cstdint>

#include "bodies/halfspace/kernels.hpp"

namespace rollcon::halfspace {

/// Describes observers (x[i], y), i < count, and a product rule around the source at the origin.
struct LatticeFar {
  const double* x = nullptr;
  double y = 0;
  std::int64_t count = 0;
  int nx = 0, ny = 0;
  const double *px = nullptr, *wx = nullptr;  ///< nx points and weights along x
  const double *py = nullptr, *wy = nullptr;  ///< ny points and weights along y
  double* integral[integral_count] = {};      ///< arrays of count values, overwritten
};

/// Computes the integrals that `terms` wants (kernels.hpp) and leaves the others alone.
using LatticeFarFunction = void (*)(const LatticeFar& job, int terms);

LatticeFarFunction lattice_far(InstructionSet set);

}  // namespace rollcon::halfspace
