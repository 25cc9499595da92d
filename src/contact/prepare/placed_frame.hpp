#pragma once
/// Frames that keep their shape but for a stretch: what depends on the frame alone follows it without being made again.

#include <cstdint>
#include <span>
#include <vector>

#include "contact/convection/convection.hpp"
#include "contact/problem/problem.hpp"
#include "contact/scene/scene.hpp"

namespace rollcon {

/// A flat frame and its characteristic scheme as they would be on the mesh before it was placed (FramePlace).
class UnitFrame {
 public:
  /// From the frame on that mesh itself, at length 1 and width 1, and the scheme there.
  void take_frame(const Frame& frame, const Problem& problem);
  void take_convection(const Frame& frame, const Convection& convection);

  /// Node at (X, -Y) for each; empty: there is none for some, or nodes of Y < 0 do not come first.
  std::span<const std::int32_t> mirror() const { return mirror_; }

  /// In place: nothing is allocated. node: where they are then.
  void put_frame(const FramePlace& place, const std::vector<Vec3>& node, Frame& frame) const;
  void put_problem(const FramePlace& place, Problem& problem) const;
  void put_convection(const FramePlace& place, const Frame& frame, Convection& convection) const;

 private:
  double area_ = 0;
  std::vector<double> x_, y_, weight_, cell_area_, moment_x_, moment_y_;
  std::vector<double> ahead_, slip_;  ///< the scheme's steps, and how far from the nodes it takes slip
  std::vector<std::int32_t> mirror_;

  void find_mirror();
};

}  // namespace rollcon
