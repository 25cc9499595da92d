#pragma once
/// Makes what depends on the frame alone follow a stretch of the frame, without making it again.

#include <cstdint>
#include <span>
#include <vector>

#include "contact/convection/convection.hpp"
#include "contact/problem/problem.hpp"
#include "contact/scene/scene.hpp"

namespace rollcon {

/// Holds a flat frame and its characteristic scheme as they would be on the mesh before it was placed (FramePlace).
class UnitFrame {
 public:
  /// Takes the frame and the scheme on that mesh itself, at length 1 and width 1.
  void take_frame(const Frame& frame, const Problem& problem);
  void take_convection(const Frame& frame, const Convection& convection);

  /// Returns the node at (X, -Y) for each; empty: some have none, or nodes of Y < 0 do not come first.
  std::span<const std::int32_t> mirror() const { return mirror_; }

  /// Put the frame in place without allocating; `node` tells where the nodes are then.
  void put_frame(const FramePlace& place, const std::vector<Vec3>& node, Frame& frame) const;
  void put_problem(const FramePlace& place, Problem& problem) const;
  void put_convection(const FramePlace& place, const Frame& frame, Convection& convection) const;

 private:
  double area_ = 0;
  std::vector<double> x_, y_, weight_, cell_area_, moment_x_, moment_y_;
  std::vector<double> ahead_, slip_;  ///< steps of the scheme, and how far from the nodes it takes slip
  std::vector<std::int32_t> mirror_;

  void find_mirror();
};

}  // namespace rollcon
