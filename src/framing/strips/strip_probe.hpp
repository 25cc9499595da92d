#pragma once
/// Finds where strips begin, by a coarse lattice without friction that closes in on the contact. Newton's method then
/// finds the strips, which do not depend on where it began.

#include "framing/strips/strip_contact.hpp"

namespace rollcon::strips {

/// Counts cells of the lattice along the rolling direction and across. Small parts of contacts need more.
struct ProbeCells {
  int along = 8, across = 12;
};

class StripProbe {
 public:
  /// Sets layout, geometry and approach of `state`: one part for each connected part of the contact, in ascending order
  /// across. The contact lies inside of the box (length); nothing is known of the gap outside. no_contact: the bodies
  /// do not touch at the approach that is given.
  StripStatus start(const StripScene& scene, const Rectangle& box, StripCounts counts, StripState& state,
                    ProbeCells cells = {});
  /// Makes one part of the two that the last start() found, with a waist between them.
  void join(const StripScene& scene, StripState& state);
  /// Returns middles of both halves of the last lattice's pressures, on both sides of its least row between two peaks.
  bool halves(Vec2& first, Vec2& second) const;
  /// Returns the part's box, one cell wider, and loads at the last lattice's nodes that belong to other parts.
  Rectangle loads_beside(int part, std::vector<std::array<double, 3>>& loads) const;

 private:
  /// Describes one row of a part: its load per length, middle and variance of its pressures.
  struct Line {
    double load = 0, middle = 0, variance = 0;
    int nodes = 0;
  };
  bool press(const StripScene& scene);
  void find_parts();
  bool close_in();
  double beyond(const StripScene& scene, int part, int outer, int to) const;
  void fill_waist(int row);
  void lay(const StripScene& scene, StripCounts counts, StripState& state);
  void fit(const StripScene& scene, int part, const StripLayout& layout, std::vector<double>& geometry);

  Rectangle box_{};
  ProbeCells cells_;
  int lines_ = 0, columns_ = 0;  ///< counts of nodes inside
  int parts_ = 0;
  double approach_ = 0;
  std::vector<double> influence_, gap_, pressure_, right_;
  std::vector<int> active_, part_, stack_;
  std::vector<Line> line_;
  std::vector<Vec2> point_;
  Lu<double> lu_;
};

}  // namespace rollcon::strips
