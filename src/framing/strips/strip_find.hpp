#pragma once
/// Finds the contact of a scene on strips: all of its parts, from nothing or from a solution nearby. Wherever it began,
/// the result is the scene's solution to the tolerance of Newton's method.

#include "framing/strips/strip_contact.hpp"
#include "framing/strips/strip_probe.hpp"
#include "framing/strips/strip_rows.hpp"

namespace rollcon::strips {

class StripFinder {
 public:
  /// Finds the contact inside of the box (length). warm: `state` is a solution nearby; with other counts it is found
  /// from nothing. unfit: strips do not fit this contact (rows with two intervals, or parts about to merge).
  /// patient: all starts are tried before it is said that they do not.
  StripReport find(const StripScene& scene, const Rectangle& box, StripCounts counts, StripState& state, bool warm,
                   bool patient = true);
  StripSolver& solver() { return solver_; }
  /// Computes total derivatives of the totals, one for each parameter. Where rows lie near corners and a parameter
  /// moves the contact, which moves them, these are differences of solves.
  bool rates(const StripScene& scene, const StripState& state, std::span<const StripParameter> parameter,
             std::span<StripTotals> rate, std::span<double> share_rate = {});
  /// Says whether the last contact has corners and rows were not found near them: peaks of pressure there are missed.
  bool missed_corners() const { return missed_corners_; }
  const StripProbe& probe() const { return probe_; }
  /// Says whether the last contact begins in so many parts, as on rough profiles, that it gets one attempt alone.
  bool scattered() const { return parts_seen_ > most_parts; }

 private:
  static constexpr int most_parts = 2;
  void look_closer(const StripScene& scene, StripCounts counts, ProbeCells cells, StripState& state);
  bool start(const StripScene& scene, const Rectangle& box, StripCounts counts, int cells, bool joined,
             StripState& state);
  bool more_parts(const StripScene& scene, const Rectangle& box, StripState& state);
  bool solve_at_corners(const StripScene& scene, const StripState& solved, StripCounts counts, StripState& state);
  double deformed_gap(const StripScene& scene, const StripState& state, const Vec2& at, bool near);
  bool inside(const StripState& state, const Vec2& at, double reach) const;

  StripStatus status_ = StripStatus::solved;
  int parts_seen_ = 0;  ///< parts that the probe saw last
  StripSolver solver_;
  StripProbe probe_, part_probe_;
  CornerRows rows_{solver_};
  StripState coarse_, part_, laid_, probed_, beside_;
  bool missed_corners_ = false;
  StripIntegrals integrals_;
  std::vector<Vec2> point_;
  std::vector<double> gap_;
};

/// Sets rows and chords of Hertz's ellipse for the gap that its values and slopes beside a point tell, under a load or
/// at an approach. Returns false where the gap has no ellipse there.
bool fit_ellipse(const StripScene& scene, const Vec2& at, double size, double depth, double load,
                 const StripLayout& layout, int part, double* geometry);
/// Makes a start with other counts from a solution: shapes of chords by cubics across, and tractions over their bounds.
void refine(const StripState& coarse, StripState& fine);

}  // namespace rollcon::strips
