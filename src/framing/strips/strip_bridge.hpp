#pragma once
/// Contacts that are about to split or to join: rows of one part and rows of two parts are not the same, and neither
/// fits a neck that vanishes. Such a contact is interpolated between contacts whose neck is filled up or dug out.

#include <array>

#include "framing/strips/strip_find.hpp"

namespace rollcon::strips {

/// A neck between two places where the undeformed bodies are nearest, as the gap alone has it.
struct Neck {
  Vec2 place{};       ///< where the gap is largest between both
  double radius = 0;  ///< of the bump, 0.63 of the distance of both
  double wall = 0;    ///< how much larger the gap is there than at the shallower of both; 0: there is no neck
};

/// A gap with a smooth bump at a neck, of a height (below 0 it fills the neck): height (1 - r^2/radius^2)^3.
struct BridgedGap : PlaneField {
  const PlaneField* gap = nullptr;
  Neck neck;
  double height = 0;
  void at(std::span<const Vec2> point, double* value, Vec2* slope) const override;
};

/// The contact of a scene: strips, and where these do not fit a neck, a mean of theirs and of four neighbours'.
struct StripSolution {
  StripState strips;
  double share = 1;  ///< of the strips
  std::array<StripState, 4> neighbour;
  Neck neck;
};

/// Solves scenes with or without necks. Holds room alone.
class StripContact {
 public:
  /// The contact lies inside of the box (length). warm: `solution` is one nearby.
  StripReport solve(const StripScene& scene, const Rectangle& box, StripCounts counts, StripSolution& solution,
                    bool warm);
  static StripTotals totals(const StripSolution& solution);
  /// Total derivatives of the totals, one for each parameter. Changes of the weight by the parameter count, changes of
  /// the neck's place do not: they move what is interpolated by less than its error.
  bool rates(const StripScene& scene, const StripSolution& solution, std::span<const StripParameter> parameter,
             std::span<StripTotals> rate);

 private:
  bool bridge(const StripScene& scene, const Rectangle& box, StripCounts counts, StripSolution& solution);

  StripFinder finder_;
  std::vector<StripTotals> part_rates_;
  std::vector<double> share_rates_;
};

}  // namespace rollcon::strips
