#pragma once
/// Finds stresses and displacements inside the half-spaces of a solved contact.

#include <cstdint>

#include "contact/solution.hpp"

namespace rollcon {

/// Lists points along t1, t2 and n of the contact's axes.
struct PointsInside {
  std::int64_t count;
  const double* xyz;
};

/// Finds stresses 11, 22, nn, 12, 1n, 2n and displacements 1, 2, n in body 1 or 2; either may be null. err_unsupported:
/// the body is no half-space; err_argument: a point is outside of it.
void find_stresses(const Solution& state, std::int32_t body, const PointsInside& points, double accuracy, int threads,
                   double* stress, double* displacement);

}  // namespace rollcon
