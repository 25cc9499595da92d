#include "wheelrail/fineness.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/index.hpp"

namespace rollcon {
namespace {

/// Holds what accuracies are solved with (docs/wheelrail.md).
struct Level {
  double accuracy;
  Fineness fineness;
};
constexpr Level levels[] = {{0.02, {{9, 10}, {10, 12}, {12, 22}}},
                            {0.01, {{10, 12}, {12, 16}, {20, 40}}},
                            {0.005, {{12, 14}, {14, 16}, {32, 64}}}};

/// Returns the intervals of a spacing over a length, within what a lattice takes; 0: none is given.
std::int64_t intervals(double length, double spacing, std::int64_t standard) {
  constexpr double least = 2, most = 1000;
  return spacing > 0 ? to_index(std::clamp(std::ceil(length / spacing), least, most)) : standard;
}

}  // namespace

Fineness fineness_for(const WheelOptions& options, bool on_lattices, const OverlapPatch& patch) {
  Fineness fineness = std::end(levels)[-1].fineness;
  for (const Level& level : levels)
    if (level.accuracy <= options.accuracy) {
      fineness = level.fineness;
      break;
    }
  LatticeSize& lattice = fineness.lattice;
  lattice.conformal = options.conformal != 0;
  lattice.along = intervals(patch.front - patch.back, options.spacing_along, lattice.along);
  lattice.across = intervals(patch.high - patch.low, options.spacing_across, lattice.across);
  if (on_lattices || options.spacing_along > 0 || options.spacing_across > 0) fineness.strips = {0, 0};
  return fineness;
}

}  // namespace rollcon
