#pragma once
/// Holds what a wheel and its rail remember between steps in time: the tractions of patches at the end of a step, and
/// where these were. It is a value; patches that move, split or merge find theirs in it by place.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/problem/past.hpp"
#include "framing/makers.hpp"
#include "mesh/frame.hpp"

namespace rollcon {

/// Holds one patch, on a regular grid along its axes; these are in the rail, with x from the wheelset.
struct PatchPast {
  Axes axes;
  double weight = 1;  ///< share of the patch in sums
  double depth = 0;   ///< overlap along the normal, less what other patches make the surfaces give way
  RectangleCells cells;
  std::array<std::vector<double>, 3> traction;

  std::int64_t nodes() const { return (cells.along + 1) * (cells.across + 1); }
};

/// Holds all patches; none: the bodies are at rest.
struct WheelPast {
  double time = 0;
  std::int64_t steps = 0;
  double sink = 0;  ///< way beyond first touch under a given force
  std::vector<PatchPast> patch;
};

/// Returns the origin that a new patch's axes should have: that of the past patch with the most weight in the box,
/// projected on the new patch's plane. The box is given in the axes as they are. Returns the axes' own origin if no
/// past patch is there.
Vec3 origin_from(const WheelPast& past, const Axes& axes, const Rectangle& box);
/// Holds the frame of a grid.
struct GridFrame {
  RectangleCells cells;
  std::shared_ptr<FrameOfPast> frame;
};

/// Gives a step's start the tractions that patches of the past left within the box, in the axes of the new patch, and
/// returns the grid on which they are. overlap: of the new patch; its increase is an approach within the step. made:
/// the frame of the grid, which stays as long as the grid does.
RectangleCells start_from(const WheelPast& past, const Axes& axes, const Rectangle& box, double overlap,
                          PastStep& start, GridFrame& made);

}  // namespace rollcon
