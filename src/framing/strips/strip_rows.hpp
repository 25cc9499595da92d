#pragma once
/// Places the rows of strips where curvatures of the bodies jump across the rolling direction: a contact that reaches a
/// rounded end of a roller has its largest pressure there, over a length much shorter than the contact is wide.

#include <vector>

#include "framing/strips/strip_contact.hpp"

namespace rollcon::strips {

/// Describes a jump of curvature across, by places in the width, which goes from -1 to 1.
struct Corner {
  double at = 0;        ///< place in the width; it may be a little beyond
  double place = 0;     ///< place in the width, or its end
  double reach = 0;     ///< distance over which pressures change, of half the width
  double strength = 1;  ///< 1: rows lie near this corner; 0: they stay where they are
};

/// Says whether rows are at other than the usual places.
bool is_laid(const StripLayout& layout);

class CornerRows {
 public:
  explicit CornerRows(StripSolver& solver) : solver_(solver) {}
  /// Widens what a probe found of one part up to where half of the overlap is left: its rows may lie far apart.
  static void widen(const StripScene& scene, StripState& state);
  /// Says whether corners are near the contact of a solution on strips, or rows are laid for corners.
  bool cornered(const StripScene& scene, const StripState& solved);
  /// Finds strips of the counts whose rows lie near corners, where the places of rows and the contact without friction
  /// agree, so that the result does not depend on where rows were before. laid: geometry, and tractions over pressures.
  /// Returns false where they are not found.
  bool lay(const StripScene& scene, const StripState& solved, StripCounts counts, StripState& laid);

 private:
  void find(const StripScene& scene, const StripState& state);
  void place(StripCounts counts, double least);
  bool move(const StripScene& scene, const StripState& from, StripCounts counts, double least);
  bool settle(const StripScene& scene, StripState& state);
  bool guide(const StripScene& scene, const StripState& solved);

  StripSolver& solver_;
  std::vector<Corner> corner_;
  std::vector<double> across_;
  StripState guide_, moved_;
};

}  // namespace rollcon::strips
