#pragma once
/// Finds how much of friction the given tangential loads use under the pressures of a frame without friction.

#include <optional>

#include "contact/newton/newton.hpp"

namespace rollcon {

/// Keeps its storage from one problem to the next.
class FrictionlessShare {
 public:
  /// Returns nothing where the pressures were not found. Throws Cancelled where the monitor asks to stop.
  std::optional<FrictionShare> find(const Problem& problem, const Prescribed& given, const Procedure& procedure,
                                    double tolerance, std::int64_t max_iterations, Monitor& monitor);

 private:
  Newton newton_;
  Iterate iterate_;
};

}  // namespace rollcon
