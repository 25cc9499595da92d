#pragma once
/// Represents cubic splines on uniform nodes, as sums of B-splines.

#include <cstdint>
#include <span>
#include <vector>

namespace rollcon {

/// Says what a spline is at one of its ends.
enum class SplineEnd {
  flat,      ///< slope 0
  straight,  ///< second derivative 0
  open       ///< the first two pieces are one cubic
};

/// Holds the four B-splines that are not 0 in an interval, and derivatives by the coordinate, in intervals.
struct SplineWeights {
  std::int64_t first = 0;  ///< number of the first of the four coefficients
  double value[4] = {}, slope[4] = {};
};

/// Evaluates the B-splines at t from 0 to `intervals`; beyond, the outer pieces go on.
SplineWeights spline_weights(double t, std::int64_t intervals);

/// Maps values at the nodes 0 .. intervals to intervals + 3 coefficients. intervals >= 3.
class SplineFit {
 public:
  SplineFit(std::int64_t intervals, SplineEnd begin, SplineEnd end);
  std::int64_t coefficients() const { return intervals_ + 3; }
  void apply(std::span<const double> value, std::span<double> coefficient) const;  ///< values at all nodes

 private:
  std::int64_t intervals_;
  std::vector<double> matrix_;  ///< coefficients x nodes
};

}  // namespace rollcon
