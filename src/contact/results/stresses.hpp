#pragma once
/// Finds stresses and displacements inside the half-spaces of a solved contact.

#include <cstdint>
#include <memory>

#include "contact/solution.hpp"

namespace rollcon {

/// Lists points along t1, t2 and n of the contact's axes.
struct PointsInside {
  std::int64_t count;
  const double* xyz;
};

/// Finds fields inside body 1 or 2 under a solution, which must outlive it.
class StressesInside {
 public:
  /// Throws err_unsupported if the body is no half-space, or the contact conformal.
  StressesInside(const Solution& state, std::int32_t body, double accuracy, int threads);
  ~StressesInside();

  /// Finds stresses 11, 22, nn, 12, 1n, 2n and displacements 1, 2, n; either may be null. err_unsupported:
  /// displacements of a viscoelastic body; err_argument: a point is outside of it.
  void find(const PointsInside& points, double* stress, double* displacement);

 private:
  struct Fields;
  std::unique_ptr<Fields> fields_;
};

}  // namespace rollcon
