#pragma once
/// Finds the contact of a scene on strips: all of its parts, from nothing or from a solution nearby. The result is that
/// of the scene to the tolerance of Newton's method, wherever it began.

#include "framing/strips/strip_contact.hpp"
#include "framing/strips/strip_probe.hpp"

namespace rollcon::strips {

class StripFinder {
 public:
  /// The contact lies inside of the box (length). warm: `state` is a solution nearby; with other counts it is
  /// found from nothing.
  /// unfit: strips do not fit this contact (rows with two intervals, or parts about to merge).
  StripReport find(const StripScene& scene, const Rectangle& box, StripCounts counts, StripState& state, bool warm);
  StripSolver& solver() { return solver_; }
  const StripProbe& probe() const { return probe_; }

 private:
  void look_closer(const StripScene& scene, StripCounts counts, ProbeCells cells, StripState& state);
  bool start(const StripScene& scene, const Rectangle& box, StripCounts counts, int cells, StripState& state);
  bool more_parts(const StripScene& scene, const Rectangle& box, StripState& state);
  double deformed_gap(const StripScene& scene, const StripState& state, const Vec2& at, bool near);
  bool inside(const StripState& state, const Vec2& at, double reach) const;

  StripStatus status_ = StripStatus::solved;
  StripSolver solver_;
  StripProbe probe_, part_probe_;
  StripState coarse_, part_;
  StripIntegrals integrals_;
  std::vector<Vec2> point_;
  std::vector<double> gap_;
};

/// Rows and chords of an ellipse of Hertz: of the gap that its values and slopes beside a point tell, under a load or
/// at an approach. False where the gap has no ellipse there.
bool fit_ellipse(const StripScene& scene, const Vec2& at, double size, double depth, double load,
                 const StripLayout& layout, int part, double* geometry);
/// A start with other counts from a solution: shapes of chords by cubics across, tractions over their bounds.
void refine(const StripState& coarse, StripState& fine);

}  // namespace rollcon::strips
